#pragma once

#include "framework/trace/known_light.h"
#include "framework/trace/tracer.h"

#include <span>
#include <vector>

namespace luch {

/// How much of which light gets to the points of a tile: what a source knows, and what is found for
/// the lights that stand in one place. Shadow rays of one light start where it stands, so they are
/// asked for all points at once, in packets.
class KnownShadows {
 public:
    /// Asks the source, if there is one, and shoots the shadow rays that are left of the points
    /// whose material is diffuse or Phong; of others it is not known whether they need any. Those
    /// that cannot change the picture are left out with Part::dark_shadow_rays.
    KnownShadows(const Scene& scene, std::span<const Surface> points, std::span<const Hit> hits,
                 const Needs& needs, Tracer& tracer, const ShadowSource* source = nullptr);

    /// 0 (blocked)..1 (lit), or ShadowSource::unknown.
    [[nodiscard]] float share(std::size_t light, std::size_t point) const {
        return shares_[light * points_ + point];
    }

 private:
    void ask(const ShadowSource& source, std::size_t light, std::span<const Surface> points,
             std::span<const std::uint32_t> which);
    void keep_unknown(std::size_t light, std::vector<std::uint32_t>& asked,
                      std::vector<Ray>& rays) const;

    std::size_t points_;
    std::vector<float> shares_;
};

}  // namespace luch
