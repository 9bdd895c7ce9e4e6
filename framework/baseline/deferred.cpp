#include "framework/baseline/deferred.h"

namespace luch {

void DeferredPixels::shade(const Scene& scene, const Needs& needs, Tracer& tracer) {
    light.resize(rays.size());
    parts.reset(rays.size(), scene.lights.size());
    Whitted(scene, needs, tracer).shade(RayKind::primary, rays, hits, keys, light, &parts);
}

void defer_tile(const Scene& scene, const Shot& shot, const Tile& tile, int sample,
                const Needs& needs, Tracer& tracer, DeferredPixels& pixels) {
    pixels.shoot(Screen(shot.camera, shot.size), shot, tile, sample, needs, tracer);
    pixels.shade(scene, needs, tracer);
}

void defer_edges(const Scene& scene, const Shot& shot, const Tile& tile, int sample,
                 ImageView<const std::uint8_t> edges, const Needs& needs, Tracer& tracer,
                 DeferredPixels& pixels) {
    shoot_edges(shot, tile, sample, edges, tracer, pixels);
    pixels.shade(scene, needs, tracer);
}

}  // namespace luch
