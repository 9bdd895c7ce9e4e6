#include "framework/trace/whitted.h"

namespace luch {
namespace {

/// What random numbers are drawn for: the branches of a surface point's key.
enum Purpose : std::uint64_t { lights, reflection, layers, jitter };

Vec3d mirrored(const Vec3d& direction, const Vec3d& normal) {
    return direction - 2 * glm::dot(direction, normal) * normal;
}

/// A point that a light shines from, and what it sends to a surface point when nothing is between.
struct LightSample {
    Vec3d position;
    Rgb irradiance;  ///< on a surface that faces it; divided by the number of samples
    Rgb highlight;   ///< the light's colour, for Phong; divided by the number of samples
};

/// The light's square is cut into cells, with one jittered point in each.
LightSample sample_of(const RectLight& light, int cell, Key key, const Vec3d& target) {
    const int column = cell % light.x_samples, row = cell / light.x_samples;
    const Vec2d inside = key.square(cell);
    const double x = (column + inside.x) / light.x_samples - 0.5;
    const double z = (row + inside.y) / light.y_samples - 0.5;
    const double orientation = glm::determinant(light.to_world.matrix) < 0 ? -1 : 1;
    const Vec3d facing =
        orientation * glm::normalize(glm::cross(light.to_world.direction({1, 0, 0}),
                                                light.to_world.direction({0, 0, 1})));
    // Lifted off the light's own visible face, which would block half of the rays by rounding.
    Vec3d position = light.to_world.point({x, 0, z});
    position += 0x1p-44 * (max_norm(position) + max_norm(light.to_world.matrix)) * facing;
    const Vec3d to_target = target - position;
    const double distance = glm::length(to_target);
    const double cosine = std::max(0.0, glm::dot(facing, to_target) / distance);
    const float share = 1.0f / static_cast<float>(light.x_samples * light.y_samples);
    const auto strength = static_cast<float>(light.power * cosine / (distance * distance));
    return {position, light.color * (strength * share), cosine > 0 ? light.color * share : Rgb(0)};
}

LightSample sample_of(const PointLight& light, int, Key, const Vec3d& target) {
    const Vec3d to_target = target - light.position;
    const auto strength = static_cast<float>(light.power / glm::dot(to_target, to_target));
    return {light.position, light.color * strength, light.color};
}

int sample_count(const PointLight&) {
    return 1;
}
int sample_count(const RectLight& light) {
    return light.x_samples * light.y_samples;
}

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

    Rgb operator()(const Lambert& material) const {
        const auto no_highlight = [](const Vec3d&) { return 0.0f; };
        return lit(albedo(material.color, material.texture), no_highlight);
    }

    Rgb operator()(const Phong& material) const {
        const Vec3d to_viewer = -glm::normalize(ray.direction);
        return lit(albedo(material.color, material.texture), [&](const Vec3d& to_light) {
            const Vec3d bounced = mirrored(-to_light, surface.normal);
            const double cosine = std::max(0.0, glm::dot(bounced, to_viewer));
            return static_cast<float>(material.specular * std::pow(cosine, material.exponent));
        });
    }

    Rgb operator()(const Reflection& material) const {
        if (material.multiplier == Rgb(0)) return Rgb(0);
        const Key bounce = key.branch(reflection);
        if (material.glossiness >= 1) {
            return material.multiplier *
                   tracer.radiance(RayKind::reflection,
                                   leaving(surface, mirrored(ray.direction, surface.normal)),
                                   bounce, depth + 1);
        }
        // A glossy reflection in a glossy reflection takes one ray, or their number would explode.
        const int count = kind == RayKind::glossy ? 1 : material.samples;
        const double radius = std::pow(10.0, 2 - 8 * material.glossiness);
        Rgb sum(0);
        for (int i = 0; i < count; ++i) {
            const Key sample = bounce.branch(i);
            sum += tracer.radiance(RayKind::glossy, leaving(surface, glossy(radius, sample)),
                                   sample, depth + 1);
        }
        return material.multiplier * sum / static_cast<float>(count);
    }

    Rgb operator()(const Layered& material) const {
        Rgb colour(0);
        for (std::size_t i = 0; i < material.layers.size(); ++i) {
            const auto& layer = material.layers[i];
            const Rgb blend = albedo(layer.blend, layer.texture);
            if (blend == Rgb(0)) continue;
            const MaterialShader below{
                tracer, scene, surface, ray, kind, key.branch(layers).branch(i), depth};
            colour = colour * (Rgb(1) - blend) +
                     std::visit(below, scene.materials[layer.material]) * blend;
        }
        return colour;
    }

    Rgb operator()(const Const& material) const { return material.color; }

    Rgb operator()(const Emission& material) const {
        return surface.front ? Rgb(0) : material.radiance;
    }

 private:
    Rgb albedo(const Rgb& color, TextureId texture) const {
        return texture == no_texture ? color : colour_at(scene.textures[texture], surface.uv);
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
        ++tracer.tracer_->counts().shades;
        Rgb diffuse = scene.settings.ambient_light, specular(0);
        for (std::size_t i = 0; i < scene.lights.size(); ++i) {
            std::visit(
                [&](const auto& light) {
                    const Key light_key = key.branch(lights).branch(i);
                    for (int s = 0; s < sample_count(light); ++s) {
                        const LightSample sample = sample_of(light, s, light_key, surface.position);
                        add_light(sample, highlight, diffuse, specular);
                    }
                },
                scene.lights[i]);
        }
        return albedo * diffuse + specular;
    }

    template <class Highlight>
    void add_light(const LightSample& sample, Highlight&& highlight, Rgb& diffuse,
                   Rgb& specular) const {
        const Vec3d to_light = sample.position - surface.position;
        const double distance = glm::length(to_light);
        const double cosine = distance > 0 ? glm::dot(surface.normal, to_light) / distance : 0;
        const bool dark =
            !(cosine > 0) || (sample.irradiance == Rgb(0) && sample.highlight == Rgb(0));
        if (dark && !tracer.needs_.dark_shadow_rays) return;
        const bool blocked =
            tracer.tracer_->occluded(RayKind::shadow, shadow_ray(surface, sample.position));
        if (dark || blocked) return;
        diffuse += sample.irradiance * static_cast<float>(cosine);
        specular += sample.highlight * highlight(to_light / distance);
    }
};

Rgb Whitted::radiance(RayKind kind, const Ray& ray, Key key, int depth) const {
    if (depth > scene_->settings.max_depth) return Rgb(0);
    return shade(kind, ray, tracer_->closest(kind, ray), key, depth);
}

Rgb Whitted::shade(RayKind kind, const Ray& ray, const Hit& hit, Key key, int depth) const {
    if (!hit) return sky_radiance(*scene_, ray.direction);
    RayLog::Branch branch(tracer_->log());
    branch.follow();
    const Surface surface = surface_at(*scene_, ray, hit, needs_.surface);
    const Material& material = scene_->materials[scene_->nodes[hit.node].material];
    return std::visit(MaterialShader{*this, *scene_, surface, ray, kind, key, depth}, material);
}

}  // namespace luch
