#pragma once

#include "framework/math/rng.h"
#include "framework/scene/scene.h"
#include "framework/trace/known_light.h"
#include "framework/trace/shaded_parts.h"
#include "framework/trace/surface.h"
#include "framework/trace/tracer.h"

namespace luch {

/// The classic recursive ray tracer (Whitted, "An Improved Illumination Model for Shaded Display",
/// 1980): closest hit, direct light with shadow rays, mirrors and
/// clear things, to the scene's depth limit.
class Whitted {
 public:
    /// What `known` points to must outlive it.
    Whitted(const Scene& scene, const Needs& needs, Tracer& tracer, const KnownLight& known = {})
        : scene_(&scene), needs_(needs), tracer_(&tracer), known_(known) {}

    /// Light that comes back along a ray. `medium` is what the ray runs through, where light fades;
    /// null: nothing. A camera within a medium is not known to be there.
    [[nodiscard]] Rgb radiance(RayKind kind, const Ray& ray, Key key, int depth = 0,
                               const Refraction* medium = nullptr) const;

    /// The same, when the hit is known already (from a tile of primary rays, an item buffer…).
    [[nodiscard]] Rgb shade(RayKind kind, const Ray& ray, const Hit& hit, Key key, int depth = 0,
                            const Refraction* medium = nullptr) const;

    /// The same for neighbours at depth 0, light[i] of rays[i]; lights that stand in one place are
    /// asked for all of them at once. Bit for bit the same, and as many rays. `parts`, where given,
    /// are told what the light is made of.
    void shade(RayKind kind, std::span<const Ray> rays, std::span<const Hit> hits,
               std::span<const Key> keys, std::span<Rgb> light, ShadedParts* parts = nullptr) const;

 private:
    friend struct MaterialShader;
    [[nodiscard]] Rgb sky(const Ray& ray) const;
    [[nodiscard]] Rgb shade_and_log(RayKind kind, const Ray& ray, const Hit& hit, Key key,
                                    int depth, const Refraction* medium, ShadedParts* parts,
                                    std::size_t point) const;

    const Scene* scene_;
    Needs needs_;
    Tracer* tracer_;
    KnownLight known_;
};

}  // namespace luch
