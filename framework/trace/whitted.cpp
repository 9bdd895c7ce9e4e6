#include "framework/trace/whitted.h"

#include "framework/trace/known_shadows.h"
#include "framework/trace/light_sample.h"
#include "framework/trace/optics.h"

namespace luch {
namespace {

/// What random numbers are drawn for: the branches of a surface point's key.
enum Purpose : std::uint64_t { lights, reflection, layers, jitter, refraction };

}  // namespace

/// Shades one surface point with a material; the visitor of Material.
struct MaterialShader {
    const Whitted& tracer;
    const Scene& scene;
    const Surface& surface;
    const Ray& ray;
    RayKind kind;
    Key key;
    int depth;
    const Refraction* medium;                    ///< what the ray came through; null: nothing
    const KnownShadows* shadows = nullptr;       ///< answers for this point, where there are any
    std::size_t point = AmbientSource::nowhere;  ///< its number among the tile's rays
    ShadedParts* parts = nullptr;  ///< told of this point's parts, where there are any

    Rgb operator()(const Lambert& material) const {
        const auto no_highlight = [](const Vec3d&) { return Rgb(0); };
        return lit(albedo(material.color, material.texture), no_highlight);
    }

    Rgb operator()(const Phong& material) const {
        const Vec3d to_viewer = -glm::normalize(ray.direction);
        return lit(albedo(material.color, material.texture), [&](const Vec3d& to_light) {
            const Vec3d bounced = mirrored(-to_light, surface.normal);
            // Rounding may make it larger than 1, which is infinite to a large power.
            const double cosine = std::min(std::max(0.0, glm::dot(bounced, to_viewer)), 1.0);
            return material.specular * static_cast<float>(std::pow(cosine, material.exponent));
        });
    }

    Rgb operator()(const Reflection& material) const {
        if (!looks_into(material.multiplier, Part::mirrors)) return Rgb(0);
        const Key bounce = key.branch(reflection);
        if (material.glossiness >= 1) {
            const Ray mirror = leaving(surface, mirrored(ray.direction, surface.normal));
            return times(material.multiplier,
                         tracer.radiance(RayKind::reflection, mirror, bounce, depth + 1, medium));
        }
        // A glossy reflection in a glossy reflection takes one ray, or their number would explode.
        const int count = kind == RayKind::glossy ? 1 : material.samples;
        const double radius = std::pow(10.0, 2 - 8 * material.glossiness);
        Rgb sum(0);
        for (int i = 0; i < count; ++i) {
            const Key sample = bounce.branch(i);
            sum += tracer.radiance(RayKind::glossy, leaving(surface, glossy(radius, sample)),
                                   sample, depth + 1, medium);
        }
        return times(material.multiplier, sum) / static_cast<float>(count);
    }

    Rgb operator()(const Refraction& material) const {
        if (!looks_into(material.multiplier, Part::clear_things)) return Rgb(0);
        const double ratio = surface.front ? 1 / material.ior : material.ior;
        const auto bent = refracted(glm::normalize(ray.direction), surface.normal, ratio);
        if (!bent) return Rgb(0);
        return times(
            material.multiplier,
            tracer.radiance(RayKind::refraction, leaving(surface, *bent), key.branch(refraction),
                            depth + 1, surface.front ? &material : nullptr));
    }

    Rgb operator()(const Layered& material) const {
        Rgb colour(0);
        for (std::size_t i = 0; i < material.layers.size(); ++i) {
            const auto& layer = material.layers[i];
            const Rgb blend = albedo(layer.blend, layer.texture);
            if (!looks_into(blend, Part::layers)) continue;
            const Key branch = key.branch(layers).branch(i);
            const MaterialShader below{tracer, scene, surface, ray,     kind,
                                       branch, depth, medium,  nullptr, point};
            const Rgb light = std::visit(below, scene.materials[layer.material]);
            colour = colour * (Rgb(1) - blend) + times(blend, light);
            if (parts != nullptr) parts->layer(point, blend, light);
        }
        return colour;
    }

    Rgb operator()(const Const& material) const { return material.color; }

    Rgb operator()(const Emission& material) const {
        counts().did(Part::visible_lights);
        return surface.front ? Rgb(0) : material.radiance;
    }

 private:
    [[nodiscard]] Counts& counts() const { return tracer.tracer_->counts(); }
    [[nodiscard]] bool needs(Part part) const { return tracer.needs_[part]; }

    /// Whether a mirror, a clear thing or a layer of that colour is worth looking into.
    bool looks_into(const Rgb& colour, Part part) const {
        if (colour == Rgb(0)) part = Part::black_branches;
        if (!needs(part)) return false;
        counts().did(part);
        return true;
    }

    /// Black stays black whatever the light, were it infinite.
    static Rgb times(const Rgb& colour, const Rgb& light) {
        return colour == Rgb(0) ? Rgb(0) : colour * light;
    }

    Rgb albedo(const Rgb& color, TextureId texture) const {
        if (texture == no_texture) return color;
        if (parts != nullptr && parts->has_words(texture)) {
            return parts->from_words(texture, surface.uv);
        }
        const double cosine = glm::dot(surface.normal, ray.direction) / glm::length(ray.direction);
        return colour_at(scene.textures[texture], {surface.uv, cosine});
    }

    /// A mirrored direction around a normal that is jittered on a disc; those below the surface are
    /// drawn again.
    Vec3d glossy(double radius, Key sample) const {
        const Vec3d& n = surface.normal;
        const Vec3d other = std::abs(n.x) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
        const Vec3d tangent = glm::normalize(glm::cross(n, other));
        const Vec3d bitangent = glm::cross(n, tangent);
        constexpr int attempts = 32;
        for (int i = 0; i < attempts; ++i) {
            const Vec2d square = 2.0 * sample.branch(jitter).square(i) - 1.0;
            if (glm::dot(square, square) > 1) continue;
            const Vec3d direction =
                mirrored(ray.direction,
                         glm::normalize(n + radius * (square.x * tangent + square.y * bitangent)));
            if (glm::dot(direction, n) > 0) return direction;
        }
        return mirrored(ray.direction, n);
    }

    /// Ambient light, and every light's diffuse part and highlight. `highlight(to_light)` is a
    /// factor of the light's colour.
    template <class Highlight>
    Rgb lit(const Rgb& albedo, Highlight&& highlight) const {
        ++counts().shades;
        Rgb diffuse = ambient(), specular(0);
        if (parts != nullptr) parts->lit(point, albedo);
        if (!needs(Part::direct_light)) return albedo * diffuse + specular;
        counts().did(Part::direct_light);
        for (std::size_t i = 0; i < scene.lights.size(); ++i) {
            const int samples = sample_count(scene.lights[i]);
            const Key light_key = sampling_key(i, samples);
            for (int s = 0; s < samples; ++s) {
                const LightSample sample = sample_of(scene.lights[i], s, light_key, surface);
                add_light(i, sample, highlight, diffuse, specular);
            }
        }
        return albedo * diffuse + specular;
    }

    [[nodiscard]] Rgb ambient() const {
        const AmbientSource* known = tracer.known_.ambient;
        return known != nullptr ? known->at(surface, point) : scene.settings.ambient_light;
    }

    /// A light's random numbers; when no light of the scene needs any, not even the key is made.
    Key sampling_key(std::size_t light, int samples) const {
        if (!needs(Part::light_samples)) return Key(0);
        counts().did(Part::light_samples, static_cast<std::uint64_t>(samples));
        return key.branch(lights).branch(light);
    }

    template <class Highlight>
    void add_light(std::size_t light, const LightSample& sample, Highlight&& highlight,
                   Rgb& diffuse, Rgb& specular) const {
        const bool dark = is_dark(sample, surface);
        if (dark && !needs(Part::dark_shadow_rays)) return;
        const float share = share_of(light, sample.shadow, dark);
        if (dark || share == 0) return;
        const double cosine = glm::dot(surface.normal, sample.to_light);
        const Rgb more = sample.irradiance * static_cast<float>(cosine) * share;
        const Rgb gleam = sample.highlight * highlight(sample.to_light) * share;
        diffuse += more;
        specular += gleam;
        if (parts != nullptr) parts->light(point, light, more, gleam);
    }

    /// How much of a light's sample arrives: 0 (blocked)..1.
    [[nodiscard]] float share_of(std::size_t light, const Ray& shadow, bool dark) const {
        float known = ShadowSource::unknown;
        if (shadows != nullptr) {
            known = shadows->share(light, point);
        } else if (tracer.known_.shadows != nullptr && !dark) {
            known = tracer.known_.shadows->share(light, surface);
        }
        if (known != ShadowSource::unknown) return known;
        if (dark) counts().did(Part::dark_shadow_rays);
        return tracer.tracer_->occluded(RayKind::shadow, shadow) ? 0.0f : 1.0f;
    }
};

Rgb Whitted::sky(const Ray& ray) const {
    if (!needs_[Part::environment]) return scene_->settings.background;
    tracer_->counts().did(Part::environment);
    return sky_radiance(*scene_, ray.direction);
}

Rgb Whitted::radiance(RayKind kind, const Ray& ray, Key key, int depth,
                      const Refraction* medium) const {
    if (depth > scene_->settings.max_depth) return Rgb(0);
    const Hit hit = tracer_->closest(kind, ray);
    const Rgb light = shade(kind, ray, hit, key, depth, medium);
    if (!medium || !hit) return light;
    return light * medium->transmittance(hit.t * glm::length(ray.direction));
}

Rgb Whitted::shade(RayKind kind, const Ray& ray, const Hit& hit, Key key, int depth,
                   const Refraction* medium) const {
    return shade_and_log(kind, ray, hit, key, depth, medium, nullptr, AmbientSource::nowhere);
}

Rgb Whitted::shade_and_log(RayKind kind, const Ray& ray, const Hit& hit, Key key, int depth,
                           const Refraction* medium, ShadedParts* parts, std::size_t point) const {
    if (!hit) return sky(ray);
    RayLog::Branch branch(tracer_->log());
    branch.follow();
    const Surface surface = surface_at(*scene_, ray, hit, needs_, tracer_->counts());
    return std::visit(MaterialShader{*this, *scene_, surface, ray, kind, key, depth, medium,
                                     nullptr, point, parts},
                      material_of(*scene_, hit));
}

void Whitted::shade(RayKind kind, std::span<const Ray> rays, std::span<const Hit> hits,
                    std::span<const Key> keys, std::span<Rgb> light, ShadedParts* parts) const {
    if (tracer_->log() != nullptr) {  // which wants the rays of each path together
        for (std::size_t i = 0; i < rays.size(); ++i) {
            light[i] = shade_and_log(kind, rays[i], hits[i], keys[i], 0, nullptr, parts, i);
        }
        return;
    }
    std::vector<Surface> surfaces(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!hits[i]) continue;
        surfaces[i] = surface_at(*scene_, rays[i], hits[i], needs_, tracer_->counts());
    }
    std::optional<KnownShadows> shadows;
    if (needs_[Part::shared_shadows] || known_.shadows != nullptr) {
        shadows.emplace(*scene_, surfaces, hits, needs_, *tracer_, known_.shadows);
    }
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!hits[i]) {
            light[i] = sky(rays[i]);
            continue;
        }
        const MaterialShader shader{*this,   *scene_, surfaces[i],
                                    rays[i], kind,    keys[i],
                                    0,       nullptr, shadows ? &*shadows : nullptr,
                                    i,       parts};
        light[i] = std::visit(shader, material_of(*scene_, hits[i]));
    }
}

}  // namespace luch
