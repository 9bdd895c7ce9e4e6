#include "framework/baseline/deferred.h"

namespace luch {

void DeferredPixels::clear() {
    pixels.clear();
    rays.clear();
    keys.clear();
}

void DeferredPixels::add(int x, int y, const Ray& ray, Key key) {
    if (nowhere(ray)) return;
    pixels.emplace_back(x, y);
    rays.push_back(ray);
    keys.push_back(key);
}

void DeferredPixels::shade(const Scene& scene, const Needs& needs, Tracer& tracer) {
    hits.resize(rays.size());
    light.resize(rays.size());
    parts.reset(rays.size(), scene.lights.size());
    tracer.closest(RayKind::primary, rays, hits);
    Whitted(scene, needs, tracer).shade(RayKind::primary, rays, hits, keys, light, &parts);
}

void defer_tile(const Scene& scene, const Shot& shot, const Tile& tile, int sample,
                const Needs& needs, Tracer& tracer, DeferredPixels& pixels) {
    const Screen screen(shot.camera, shot.size);
    const bool lens = needs[Part::lens];
    const int samples = sample_count(shot);
    pixels.clear();
    for_each_pixel(tile, [&](int x, int y) {
        pixels.add(x, y, primary_ray(screen, shot, x, y, sample, samples, lens),
                   radiance_key(shot, x, y, sample));
    });
    if (lens) tracer.counts().did(Part::lens, pixels.rays.size());
    pixels.shade(scene, needs, tracer);
}

void defer_edges(const Scene& scene, const Shot& shot, const Tile& tile, int sample,
                 ImageView<const std::uint8_t> edges, const Needs& needs, Tracer& tracer,
                 DeferredPixels& pixels) {
    const Screen screen(shot.camera, shot.size);
    const Vec2d& off = antialias_places[static_cast<std::size_t>(sample)];
    pixels.clear();
    for_each_pixel(tile, [&](int x, int y) {
        if (edges(x, y) == 0) return;
        pixels.add(x, y, screen.ray(x + 0.5 + off.x, y + 0.5 + off.y),
                   radiance_key(shot, x, y, sample + 1));
    });
    pixels.shade(scene, needs, tracer);
}

}  // namespace luch
