#include "techniques/sh_ambient/incoming.h"

#include "framework/math/spread.h"
#include "framework/trace/directions.h"
#include "framework/trace/whitted.h"

#include <bit>

namespace luch::techniques::sh_ambient {
namespace {

/// What random numbers are drawn for.
enum Purpose : std::uint64_t { direction, shading, next_surface };

/// The mean of `samples` values, the sound ones counting.
template <class Sample>
Rgb mean_of(int samples, Sample&& sample) {
    Vec3d sum(0);
    for (int i = 0; i < samples; ++i) {
        const Rgb value = sample(static_cast<std::uint32_t>(i));
        if (all_finite(value)) sum += Vec3d(value);
    }
    return Rgb(sum / static_cast<double>(samples));
}

}  // namespace

/// Ambient light of a surface that light is reflected by.
struct Incoming::Reflected : AmbientSource {
    Reflected(const Incoming& from, Key path, int left)
        : incoming(from), key(path), bounces(left) {}

    Rgb at(const Surface& surface, std::size_t) const override {
        const Key own = key_of(key, surface.position);
        const Vec3d way = sample_cosine(surface.normal, own.square(direction));
        // Below the true surface there is its own inside.
        if (!(glm::dot(way, surface.geometric_normal) > 0)) return Rgb(0);
        return incoming.along(leaving(surface, way), own.branch(next_surface), bounces);
    }

    const Incoming& incoming;
    Key key;
    int bounces;
};

Rgb Incoming::along(const Ray& ray, Key key, int bounces) const {
    const Hit hit = tracer_->closest(RayKind::gi, ray);
    if (!hit) return sky_radiance(*scene_, ray.direction);
    if (bounces == 0 || std::holds_alternative<Emission>(material_of(*scene_, hit))) return Rgb(0);
    const Reflected ambient(*this, key.branch(next_surface), bounces - 1);
    const Whitted classic(*scene_, needs_, *tracer_, {.ambient = &ambient});
    // As if the ray came from a glossy mirror: a glossy surface then answers with one ray.
    return classic.shade(RayKind::glossy, ray, hit, key.branch(shading));
}

Rgb Incoming::mean_at(const Surface& surface, int samples, Key key) const {
    return mean_of(samples, [&](std::uint32_t i) {
        const Vec3d way = sample_cosine(surface.normal, spread(key.branch(direction), i));
        if (!(glm::dot(way, surface.geometric_normal) > 0)) return Rgb(0);
        return radiance(leaving(surface, way), key.branch(next_surface).branch(i));
    });
}

Rgb mean_of_sky(const Scene& scene, const Vec3d& normal, int samples, Key key) {
    return mean_of(samples, [&](std::uint32_t i) {
        return sky_radiance(scene, sample_cosine(normal, spread(key.branch(direction), i)));
    });
}

Key key_of(Key key, const Vec3d& place) {
    for (int axis = 0; axis < 3; ++axis)
        key = key.branch(std::bit_cast<std::uint64_t>(place[axis]));
    return key;
}

}  // namespace luch::techniques::sh_ambient
