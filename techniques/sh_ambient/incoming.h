#pragma once

#include "framework/math/rng.h"
#include "framework/trace/surface.h"
#include "framework/trace/tracer.h"

namespace luch::techniques::sh_ambient {

/// Light that comes in at a point from around, but not from the lights, which the classic tracer
/// asks itself: the sky, and surfaces as the classic tracer shows them, their ambient light being
/// traced in turn, one direction a surface (path tracing: Kajiya, "The Rendering Equation", 1986).
class Incoming {
 public:
    /// Light is reflected by up to `bounces` surfaces; 0: the sky alone.
    Incoming(const Scene& scene, const Needs& needs, Tracer& tracer, int bounces)
        : scene_(&scene), needs_(needs), tracer_(&tracer), bounces_(bounces) {}

    /// One sample of what comes along a ray.
    [[nodiscard]] Rgb radiance(const Ray& ray, Key key) const { return along(ray, key, bounces_); }

    /// An estimate of E(n)/π at a point of a surface: the mean over directions around its normal,
    /// spread by the cosine. Samples that are not finite bring nothing.
    [[nodiscard]] Rgb mean_at(const Surface& surface, int samples, Key key) const;

    [[nodiscard]] Tracer& tracer() const { return *tracer_; }

 private:
    struct Reflected;
    [[nodiscard]] Rgb along(const Ray& ray, Key key, int bounces) const;

    const Scene* scene_;
    Needs needs_;
    Tracer* tracer_;
    int bounces_;
};

/// The same of the sky alone, with nothing in its way: no rays.
[[nodiscard]] Rgb mean_of_sky(const Scene& scene, const Vec3d& normal, int samples, Key key);

/// A key of a point's own, whoever asks.
[[nodiscard]] Key key_of(Key key, const Vec3d& place);

}  // namespace luch::techniques::sh_ambient
