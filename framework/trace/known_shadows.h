#pragma once

#include "framework/trace/surface.h"
#include "framework/trace/tracer.h"

#include <span>
#include <vector>

namespace luch {

/// Which points of a tile see which of the lights that stand in one place. Shadow rays of one light
/// start where it stands, so they are asked for all points at once, in packets.
class KnownShadows {
 public:
    enum class Answer : std::uint8_t { not_asked, lit, blocked };

    /// Shoots the shadow rays of the points whose material is diffuse or Phong; of others it is not
    /// known whether they need any. Those that cannot change the picture are left out with
    /// Part::dark_shadow_rays.
    KnownShadows(const Scene& scene, std::span<const Surface> points, std::span<const Hit> hits,
                 const Needs& needs, Tracer& tracer);

    [[nodiscard]] Answer of(std::size_t light, std::size_t point) const {
        return answers_[light * points_ + point];
    }

 private:
    std::size_t points_;
    std::vector<Answer> answers_;
};

}  // namespace luch
