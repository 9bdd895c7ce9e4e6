#include "tests/trace/path_estimate.h"

#include "tests/testing/scenes.h"

namespace luch::testing {

double Measured::sigmas_from(const Vec3d& truth, const Vec3d& truth_error) const {
    double worst = 0;
    for (int k = 0; k < 3; ++k) {
        const double rounding = 1e-6 * (std::abs(truth[k]) + std::abs(mean[k]));
        const double off = std::max(0.0, std::abs(mean[k] - truth[k]) - rounding);
        const double sigma = std::hypot(error[k], truth_error[k]);
        if (off > 0) worst = std::max(worst, off / sigma);
    }
    return worst;
}

Measured PathBench::measured(const Ray& ray, const PathSettings& settings, int samples,
                             std::uint64_t seed) const {
    Tracer tracer(*accelerator_);
    PathTracer paths(scene_, lights_, settings, Needs(), tracer);
    Measured result;
    Vec3d spread(0);
    for (int i = 0; i < samples; ++i) {
        // A key for each sample: the samples are independent.
        const Vec3d light = paths.radiance(ray, {Key(seed).branch(static_cast<unsigned>(i)), 0});
        const Vec3d off = light - result.mean;
        result.mean += off / (i + 1.0);
        spread += off * (light - result.mean);
    }
    result.error = glm::sqrt(spread / (samples * (samples - 1.0)));
    return result;
}

std::vector<NamedSettings> all_ways(int depth) {
    return {{"mis", {.depth = depth}},
            {"light", {.sampling = PathSampling::light, .depth = depth}},
            {"bsdf", {.sampling = PathSampling::bsdf, .depth = depth}},
            {"halves", {.mis = false, .depth = depth}},
            {"no roulette", {.roulette = false, .depth = depth}}};
}

Scene dark_scene() {
    Scene scene = empty_scene();
    scene.lights.clear();
    return scene;
}

void set_sky(Scene& scene, const Rgb& colour) {
    CubemapEnvironment sky;
    for (Image<Rgb>& side : sky.sides) side = Image<Rgb>({16, 16}, colour);
    scene.environment = std::move(sky);
}

}  // namespace luch::testing
