#pragma once

#include "framework/baseline/tile_rays.h"
#include "framework/technique/frame.h"
#include "framework/trace/known_light.h"
#include "framework/trace/tracer.h"

namespace luch::techniques::shadow_map {

/// What is shown of shadows, beside the frame's colour: the mean share of the lights that are
/// known, whether any was left to rays, and, where it is judged, what was wrong.
struct ShadowPlanes {
    Image<float>* share = nullptr;  ///< null: not wanted
    Image<std::uint8_t>* traced = nullptr;
    Image<float>* false_shadow = nullptr;  ///< null: not judged
    Image<float>* false_light = nullptr;

    /// `draw` false: the first two are not wanted.
    ShadowPlanes(Frame& frame, bool draw, bool judge);
};

/// Asks another source, and writes what it says of a tile's points into the planes. Judges it, too,
/// where that is wished: a shadow ray for every answer about a light in one place.
class JudgedSource final : public ShadowSource {
 public:
    JudgedSource(const ShadowSource& source, const Scene& scene, Tracer& tracer,
                 const ShadowPlanes& planes)
        : source_(&source), scene_(&scene), tracer_(&tracer), planes_(&planes) {}

    /// The pixels of the points that are asked next, by their numbers; begins anew with them.
    void look_at(const TileRays& rays);

    void shares(std::size_t light, std::span<const Surface> points,
                std::span<const std::uint32_t> which, std::span<float> shares) const override;
    [[nodiscard]] float share(std::size_t light, const Surface& surface) const override {
        return source_->share(light, surface);
    }

 private:
    void show(std::span<const std::uint32_t> which, std::span<const float> shares) const;
    void judge(std::size_t light, std::span<const Surface> points,
               std::span<const std::uint32_t> which, std::span<const float> shares) const;

    const ShadowSource* source_;
    const Scene* scene_;
    Tracer* tracer_;
    const ShadowPlanes* planes_;
    const TileRays* rays_ = nullptr;
    mutable std::vector<int> asked_;  ///< lights so far that a point's share is the mean of
};

}  // namespace luch::techniques::shadow_map
