#include "techniques/ssao/rays.h"

#include "framework/trace/directions.h"

#include <array>

namespace luch::techniques::ssao {

float traced_occlusion(const Surface& surface, double radius, int rays, Key key, Tracer& tracer) {
    constexpr int batch = 64;
    std::array<Ray, batch> some;
    std::array<std::uint8_t, batch> blocked;
    int met = 0;
    for (int i = 0; i < rays; i += batch) {
        const int count = std::min(batch, rays - i);
        for (int k = 0; k < count; ++k) {
            const Vec2d square = spread(key, static_cast<std::uint32_t>(i + k));
            Ray& ray = some[static_cast<std::size_t>(k)];
            ray = leaving(surface, sample_cosine(surface.geometric_normal, square));
            ray.t_max = static_cast<float>(radius);
        }
        const auto n = static_cast<std::size_t>(count);
        tracer.occluded(RayKind::gi, std::span(some).first(n), std::span(blocked).first(n));
        for (std::size_t k = 0; k < n; ++k) met += blocked[k];
    }
    return static_cast<float>(met) / static_cast<float>(rays);
}

Rgb TracedAmbient::at(const Surface& surface, std::size_t point) const {
    if (point == nowhere) return ambient_;
    const float visible = 1 - traced_occlusion(surface, params_->radius, params_->samples,
                                               occlusion_key(rays_->keys[point]), *tracer_);
    const auto& [x, y] = rays_->pixels[point];
    visibility_(x, y) = visible;
    return ambient_ * visible;
}

}  // namespace luch::techniques::ssao
