#pragma once

#include "framework/baseline/tile_rays.h"
#include "framework/technique/context.h"
#include "framework/trace/known_light.h"
#include "techniques/sh_ambient/sh_ambient.h"

#include <atomic>

namespace luch::techniques::sh_ambient {

/// What a frame's ambient light is made of.
struct Ambience {
    const Scene& scene;
    const Steps& steps;
    const Params& params;
    Needs needs;
    bool any = true;                                      ///< else it is black everywhere
    Sh9 sky{};                                            ///< environment
    const ProbeGrid* grid = nullptr;                      ///< probes
    Key key{};                                            ///< sampled, traced
    std::atomic<std::uint64_t> points = 0, negative = 0;  ///< asked for; of them below 0
};

/// Planes of a frame; those that are empty are not drawn.
struct Planes {
    ImageView<Rgb> irradiance;
    ImageView<std::uint32_t> probe;
    ImageView<float> weight;
};

/// Answers for the ambient light of one tile, and tells the frame how often, at its end.
class TileAmbient : public AmbientSource {
 public:
    TileAmbient(Ambience& of, Context& context, Tracer& tracer, Planes planes = {})
        : of_(of), context_(context), tracer_(tracer), planes_(planes) {}
    ~TileAmbient() override;
    TileAmbient(const TileAmbient&) = delete;
    TileAmbient& operator=(const TileAmbient&) = delete;

    /// The rays whose points will ask from now on.
    void look(const TileRays& rays) { rays_ = &rays; }

    /// E(n)/π: an albedo of 1 sends on what comes in on average.
    [[nodiscard]] Rgb at(const Surface& surface, std::size_t point) const override;

 private:
    [[nodiscard]] Rgb irradiance(const Surface& surface, std::size_t point) const;
    [[nodiscard]] Rgb from(const Sh9& light, const Surface& surface) const;
    [[nodiscard]] Sh9 from_probes(const Surface& surface, std::size_t point) const;
    /// The pixel of a point that is seen first; none where the planes are not drawn.
    [[nodiscard]] const std::pair<int, int>* pixel_of(std::size_t point) const;

    Ambience& of_;
    Context& context_;
    Tracer& tracer_;
    Planes planes_;
    const TileRays* rays_ = nullptr;
    mutable std::uint64_t points_ = 0, negative_ = 0;
};

}  // namespace luch::techniques::sh_ambient
