#pragma once

#include "framework/baseline/tile_rays.h"
#include "framework/trace/known_light.h"
#include "framework/trace/surface.h"
#include "techniques/ssao/ssao.h"

namespace luch::techniques::ssao {

/// The truth: the share of rays from a surface, with the density cos/π around its geometric normal,
/// that meet something within the radius. They are RayKind::gi and spread evenly.
float traced_occlusion(const Surface& surface, double radius, int rays, Key key, Tracer& tracer);

/// The key of a pixel's rays, from that of its sample.
inline Key occlusion_key(Key sample) {
    return sample.branch(0x55a0);
}

/// Ambient light that is found by rays, at what the rays of a tile meet first.
class TracedAmbient : public AmbientSource {
 public:
    /// `visibility`: what each pixel's last ray found is written there. All must outlive it.
    TracedAmbient(const Rgb& ambient, const Params& params, const TileRays& rays, Tracer& tracer,
                  ImageView<float> visibility)
        : ambient_(ambient),
          params_(&params),
          rays_(&rays),
          tracer_(&tracer),
          visibility_(visibility) {}
    [[nodiscard]] Rgb at(const Surface& surface, std::size_t point) const override;

 private:
    Rgb ambient_;
    const Params* params_;
    const TileRays* rays_;
    Tracer* tracer_;
    ImageView<float> visibility_;
};

}  // namespace luch::techniques::ssao
