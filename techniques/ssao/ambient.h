#pragma once

#include "framework/baseline/tile_rays.h"
#include "framework/trace/known_light.h"
#include "techniques/ssao/ssao.h"

namespace luch::techniques::ssao {

/// Ambient light that is known at the pixels' centres.
struct AmbientPlane {
    Rgb elsewhere;  ///< what arrives where no ray of a pixel meets first
    ImageView<const Rgb> light;
    ImageView<const Vec3> position;  ///< of the centres, in camera space
};

/// Takes the light at what the rays of a tile meet first from such a plane: a centre's from its own
/// pixel, another's from that of the nine next to it whose position is nearest.
class PlaneAmbient : public AmbientSource {
 public:
    /// All must outlive it. `centres`: all rays are those of centres.
    PlaneAmbient(const AmbientPlane& plane, const Screen& screen, const TileRays& rays,
                 bool centres)
        : plane_(&plane), screen_(&screen), rays_(&rays), centres_(centres) {}
    [[nodiscard]] Rgb at(const Surface& surface, std::size_t point) const override;

 private:
    const AmbientPlane* plane_;
    const Screen* screen_;
    const TileRays* rays_;
    bool centres_;
};

}  // namespace luch::techniques::ssao
