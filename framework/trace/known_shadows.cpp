#include "framework/trace/known_shadows.h"

#include "framework/trace/light_sample.h"

namespace luch {
namespace {

/// The points whose materials certainly ask every light.
std::vector<std::uint32_t> lit_points(const Scene& scene, std::span<const Hit> hits) {
    std::vector<std::uint32_t> points;
    for (std::uint32_t i = 0; i < hits.size(); ++i) {
        if (!hits[i]) continue;
        const Material& material = material_of(scene, hits[i]);
        const bool lit =
            std::holds_alternative<Lambert>(material) || std::holds_alternative<Phong>(material);
        if (lit) points.push_back(i);
    }
    return points;
}

}  // namespace

KnownShadows::KnownShadows(const Scene& scene, std::span<const Surface> points,
                           std::span<const Hit> hits, const Needs& needs, Tracer& tracer)
    : points_(points.size()), answers_(points.size() * scene.lights.size(), Answer::not_asked) {
    tracer.counts().did(Part::shared_shadows);
    const std::vector<std::uint32_t> lit = lit_points(scene, hits);
    std::vector<std::uint32_t> asked;
    std::vector<Ray> rays;
    std::vector<std::uint8_t> blocked;
    for (std::size_t light = 0; light < scene.lights.size(); ++light) {
        if (!stands_in_one_place(scene.lights[light])) continue;
        asked.clear();
        rays.clear();
        for (const std::uint32_t point : lit) {
            // The light stands still: no random number is drawn for it.
            const LightSample sample = sample_of(scene.lights[light], 0, Key(0), points[point]);
            const bool dark = is_dark(sample, points[point]);
            if (dark && !needs[Part::dark_shadow_rays]) continue;
            if (dark) tracer.counts().did(Part::dark_shadow_rays);
            asked.push_back(point);
            rays.push_back(sample.shadow);
        }
        blocked.resize(rays.size());
        tracer.occluded(RayKind::shadow, rays, blocked);
        for (std::size_t i = 0; i < asked.size(); ++i) {
            answers_[light * points_ + asked[i]] = blocked[i] != 0 ? Answer::blocked : Answer::lit;
        }
    }
}

}  // namespace luch
