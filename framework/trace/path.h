#pragma once

#include "framework/trace/bsdf.h"
#include "framework/trace/path_lights.h"
#include "framework/trace/tracer.h"

namespace luch {

/// Which of the two ways to find light is used where both can: to choose a point of a light, or to
/// follow the BSDF and see what it meets. Where only one can, it does.
enum class PathSampling { both, light, bsdf };

/// How a path tracer goes about it. The mean of the picture does not depend on it (but for depth).
struct PathSettings {
    PathSampling sampling = PathSampling::both;
    /// Multiple importance sampling with the power heuristic (Veach and Guibas, "Optimally
    /// Combining Sampling Techniques for Monte Carlo Rendering", 1995); false: the mean of both
    /// ways.
    bool mis = true;
    bool roulette = true;  ///< Russian roulette after a few bounces, by what is left of the light
    int depth = 8;         ///< the camera ray has depth 0; see PathTracer::radiance
};

/// Follows paths from the camera to the lights (Kajiya, "The Rendering Equation", 1986). At every
/// vertex a point of one light, a directional light and a direction of the sky are sampled, and the
/// path goes on as the BSDF says; what it meets by chance is weighed against what sampling finds.
///
/// Ambient light is unused. A point light shines with color · power / d², reflected by albedo/π. No
/// light is sampled through a clear surface: what comes that way is found by the paths that go
/// through it, from lights with an area and the sky.
class PathTracer {
 public:
    PathTracer(const Scene& scene, const PathLights& lights, const PathSettings& settings,
               const Needs& needs, Tracer& tracer)
        : scene_(&scene), lights_(&lights), settings_(settings), needs_(needs), tracer_(&tracer) {}

    /// One sample of the light that comes back along a camera ray (direction of unit length).
    /// Samples that are spread together share the key. A ray deeper than the settings' depth is
    /// black, as in the classic tracer; a surface at that depth is lit by the lights and the sky.
    [[nodiscard]] Vec3d radiance(const Ray& camera_ray, const Draw& draw);

 private:
    /// The state of a path.
    struct Path {
        Ray ray;
        RayKind kind = RayKind::primary;
        const Refraction* medium = nullptr;
        Vec3d throughput{1};
        Vec3d light{0};
        /// The vertex that the ray left, and the density with which it did; 0: light sampling could
        /// not have found what it meets.
        Vec3d from{0}, from_normal{0};
        double pdf = 0;
        int depth = 0;
    };
    /// A part that is counted when it is needed.
    bool at_work(Part part);
    bool step(Path& path, const Draw& draw);
    void meet_sky(Path& path) const;
    void meet_lamp(Path& path, const Hit& hit, std::uint32_t light);
    bool go_on(Path& path, const Draw& draw);

    [[nodiscard]] Vec3d direct(const Draw& draw, const Refraction* medium);
    [[nodiscard]] Vec3d from_placed(const Draw& draw, const Refraction* medium);
    [[nodiscard]] Vec3d from_rect(std::uint32_t light, double probability, const Vec2d& square,
                                  const Refraction* medium);
    [[nodiscard]] Vec3d from_point(const Vec3d& place, const Vec3d& intensity,
                                   const Refraction* medium);
    [[nodiscard]] Vec3d from_distant(const Draw& draw);
    [[nodiscard]] Vec3d from_sky(const Vec2d& square);
    [[nodiscard]] Vec3d unless_blocked(const Vec3d& light, const Ray& shadow);

    [[nodiscard]] double light_weight(double light_pdf, double bsdf_pdf) const;
    [[nodiscard]] double bsdf_weight(double bsdf_pdf, double light_pdf) const;

    const Scene* scene_;
    const PathLights* lights_;
    PathSettings settings_;
    Needs needs_;
    Tracer* tracer_;
    Surface surface_;  ///< of the vertex at hand
    Bsdf bsdf_;
};

}  // namespace luch
