#include "framework/trace/bsdf.h"

#include "framework/trace/directions.h"
#include "framework/trace/optics.h"

#include <limits>

namespace luch {
namespace {

/// What a vertex's random numbers are drawn for. See also path.cpp.
enum Purpose : std::uint64_t { lobe_choice, lobe_direction, jitter };

double mean_size(const Vec3d& colour) {
    return (std::abs(colour.x) + std::abs(colour.y) + std::abs(colour.z)) / 3;
}

}  // namespace

void Bsdf::set(const Scene& scene, const Surface& surface, const Vec3d& direction,
               const Material& material, const Refraction* medium) {
    surface_ = &surface;
    medium_ = medium;
    direction_ = direction;
    const bool sound = glm::dot(surface.normal, surface.geometric_normal) > 0;
    normal_ = sound ? surface.normal : surface.geometric_normal;
    mirrored_ = mirrored(direction, normal_);
    emitted_ = Vec3d(0);
    scatters_ = false;
    lobes_.clear();
    add(scene, material, Vec3d(1));
    share_chances();
}

void Bsdf::add(const Scene& scene, const Material& material, const Vec3d& weight) {
    if (const auto* lambert = std::get_if<Lambert>(&material)) {
        const Vec3d colour = albedo(scene, lambert->color, lambert->texture);
        add_lobe({.kind = Lobe::diffuse, .weight = weight * colour});
    } else if (const auto* phong = std::get_if<Phong>(&material)) {
        const Vec3d colour = albedo(scene, phong->color, phong->texture);
        const double left = std::clamp(1 - max_norm(colour), 0.0, 1.0);
        const Vec3d share = left * Vec3d(glm::clamp(phong->specular, 0.0f, 1.0f));
        add_lobe({.kind = Lobe::diffuse, .weight = weight * colour});
        add_lobe({.kind = Lobe::highlight, .weight = weight * share, .shape = phong->exponent});
    } else if (const auto* mirror = std::get_if<Reflection>(&material)) {
        const bool sharp = mirror->glossiness >= 1;
        add_lobe({.kind = sharp ? Lobe::mirror : Lobe::glossy,
                  .weight = weight * Vec3d(mirror->multiplier),
                  .shape = std::pow(10.0, 2 - 8 * mirror->glossiness)});
    } else if (const auto* clear = std::get_if<Refraction>(&material)) {
        add_lobe({.kind = Lobe::clear,
                  .weight = weight * Vec3d(clear->multiplier),
                  .clear_material = clear});
    } else if (const auto* layered = std::get_if<Layered>(&material)) {
        add_layers(scene, *layered, weight);
    } else if (const auto* unlit = std::get_if<Const>(&material)) {
        emitted_ += weight * Vec3d(unlit->color);
    } else if (const auto* lamp = std::get_if<Emission>(&material)) {
        if (!surface_->front) emitted_ += weight * Vec3d(lamp->radiance);
    }
}

void Bsdf::add_layers(const Scene& scene, const Layered& material, const Vec3d& weight) {
    Vec3d left = weight;  // of what lies above
    for (auto layer = material.layers.rbegin(); layer != material.layers.rend(); ++layer) {
        const Vec3d blend = albedo(scene, layer->blend, layer->texture);
        add(scene, scene.materials[layer->material], left * blend);
        left *= 1.0 - blend;
    }
}

void Bsdf::add_lobe(Lobe lobe) {
    lobe.chance = mean_size(lobe.weight);
    // A texel that is not finite is not hidden: the pixel is to be counted.
    if (!std::isfinite(lobe.chance)) {
        emitted_ = Vec3d(std::numeric_limits<double>::quiet_NaN());
    } else if (lobe.chance > 0) {
        lobes_.push_back(lobe);
    }
}

void Bsdf::share_chances() {
    double sum = 0;
    for (const Lobe& lobe : lobes_) sum += lobe.chance;
    for (Lobe& lobe : lobes_) {
        lobe.chance /= sum;
        scatters_ = scatters_ || lobe.kind == Lobe::diffuse || lobe.kind == Lobe::highlight;
    }
}

Vec3d Bsdf::albedo(const Scene& scene, const Rgb& color, TextureId texture) const {
    if (texture == no_texture) return Vec3d(color);
    const double cosine = glm::dot(surface_->normal, direction_);
    return Vec3d(colour_at(scene.textures[texture], {surface_->uv, cosine}));
}

Bsdf::Value Bsdf::evaluate(const Vec3d& to_light) const {
    Value value;
    const double cosine = glm::dot(normal_, to_light);
    if (!(cosine > 0) || !(glm::dot(surface_->geometric_normal, to_light) > 0)) return value;
    for (const Lobe& lobe : lobes_) {
        if (lobe.kind == Lobe::diffuse) {
            const double pdf = cosine_pdf(cosine);
            value.reflected += lobe.weight * pdf;
            value.pdf += lobe.chance * pdf;
        } else if (lobe.kind == Lobe::highlight) {
            const double n = lobe.shape;
            const double pdf = power_cosine_pdf(glm::dot(mirrored_, to_light), n);
            value.reflected += lobe.weight * ((n + 2) / (n + 1) * pdf * cosine);
            value.pdf += lobe.chance * pdf;
        }
    }
    return value;
}

std::optional<Bounce> Bsdf::sample(const Draw& draw) const {
    if (lobes_.empty()) return std::nullopt;
    const Lobe& lobe = lobes_.size() == 1 ? lobes_[0] : chosen(draw.pair(lobe_choice).x);
    const bool served = lobe.kind == Lobe::diffuse || lobe.kind == Lobe::highlight;
    return served ? scattered(lobe, draw) : passed(lobe, draw);
}

const Bsdf::Lobe& Bsdf::chosen(double random) const {
    for (const Lobe& lobe : lobes_) {
        if (random < lobe.chance) return lobe;
        random -= lobe.chance;
    }
    return lobes_.back();
}

std::optional<Bounce> Bsdf::scattered(const Lobe& lobe, const Draw& draw) const {
    const Vec2d square = draw.pair(lobe_direction);
    const Vec3d direction = lobe.kind == Lobe::diffuse
                                ? sample_cosine(normal_, square)
                                : sample_power_cosine(mirrored_, lobe.shape, square);
    const Value value = evaluate(direction);
    if (!(value.pdf > 0)) return std::nullopt;
    return Bounce{direction, value.reflected / value.pdf, value.pdf, RayKind::gi, medium_};
}

std::optional<Bounce> Bsdf::passed(const Lobe& lobe, const Draw& draw) const {
    Bounce bounce{.direction = {}, .weight = lobe.weight / lobe.chance, .medium = medium_};
    if (lobe.kind == Lobe::mirror) {
        bounce.kind = RayKind::reflection;
        bounce.direction = mirrored(direction_, surface_->normal);
    } else if (lobe.kind == Lobe::glossy) {
        bounce.kind = RayKind::glossy;
        bounce.direction = blurred(lobe.shape, draw);
    } else {
        const double ior = lobe.clear_material->ior;
        const auto bent = refracted(direction_, surface_->normal, surface_->front ? 1 / ior : ior);
        if (!bent) return std::nullopt;
        bounce.kind = RayKind::refraction;
        bounce.direction = *bent;
        bounce.medium = surface_->front ? lobe.clear_material : nullptr;
    }
    bounce.direction = glm::normalize(bounce.direction);
    return bounce;
}

Vec3d Bsdf::blurred(double radius, const Draw& draw) const {
    const Vec3d& n = surface_->normal;
    const Frame3 frame(n);
    constexpr std::uint64_t attempts = 32;
    for (std::uint64_t i = 0; i < attempts; ++i) {
        const Vec2d disc = radius * disc_of(draw.pair(jitter + i));
        const Vec3d jittered = glm::normalize(frame.world({disc.x, disc.y, 1}));
        const Vec3d direction = mirrored(direction_, jittered);
        if (glm::dot(direction, n) > 0) return direction;
    }
    return mirrored(direction_, n);
}

}  // namespace luch
