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
                           std::span<const Hit> hits, const Needs& needs, Tracer& tracer,
                           const ShadowSource* source)
    : points_(points.size()), shares_(points.size() * scene.lights.size(), ShadowSource::unknown) {
    tracer.counts().did(Part::shared_shadows);
    const std::vector<std::uint32_t> lit = lit_points(scene, hits);
    std::vector<std::uint32_t> asked;
    std::vector<Ray> rays;
    std::vector<std::uint8_t> blocked;
    for (std::size_t light = 0; light < scene.lights.size(); ++light) {
        if (!stands_in_one_place(scene.lights[light])) {
            if (source != nullptr) ask(*source, light, points, lit);
            continue;
        }
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
        if (source != nullptr) {
            ask(*source, light, points, asked);
            keep_unknown(light, asked, rays);
        }
        blocked.resize(rays.size());
        tracer.occluded(RayKind::shadow, rays, blocked);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            shares_[light * points_ + asked[i]] = blocked[i] != 0 ? 0.0f : 1.0f;
        }
    }
}

void KnownShadows::ask(const ShadowSource& source, std::size_t light,
                       std::span<const Surface> points, std::span<const std::uint32_t> which) {
    std::vector<float> shares(which.size());
    source.shares(light, points, which, shares);
    for (std::size_t i = 0; i < which.size(); ++i) shares_[light * points_ + which[i]] = shares[i];
}

void KnownShadows::keep_unknown(std::size_t light, std::vector<std::uint32_t>& asked,
                                std::vector<Ray>& rays) const {
    std::size_t left = 0;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        if (share(light, asked[i]) != ShadowSource::unknown) continue;
        asked[left] = asked[i];
        rays[left++] = rays[i];
    }
    asked.resize(left);
    rays.resize(left);
}

}  // namespace luch
