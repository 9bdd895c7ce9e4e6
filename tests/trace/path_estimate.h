#pragma once

#include "framework/trace/path.h"

namespace luch::testing {

/// What many independent samples of one ray say.
struct Measured {
    Vec3d mean{0};
    Vec3d error{0};  ///< one standard error of the mean

    /// How many standard errors the mean's worst channel is from `truth`. What rounding does is not
    /// counted.
    [[nodiscard]] double sigmas_from(const Vec3d& truth, const Vec3d& truth_error = Vec3d(0)) const;
};

/// A scene with all that is needed to follow paths in it.
class PathBench {
 public:
    explicit PathBench(Scene scene)
        : scene_(std::move(scene)), accelerator_(build_accelerator(scene_)), lights_(scene_) {}

    [[nodiscard]] Measured measured(const Ray& ray, const PathSettings& settings, int samples,
                                    std::uint64_t seed = 1) const;
    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const PathLights& lights() const { return lights_; }
    [[nodiscard]] const Accelerator& accelerator() const { return *accelerator_; }

 private:
    const Scene scene_;
    std::unique_ptr<Accelerator> accelerator_;
    PathLights lights_;
};

/// All ways to find light, with a name each.
struct NamedSettings {
    const char* name;
    PathSettings settings;
};
std::vector<NamedSettings> all_ways(int depth);

/// empty_scene() without its light.
Scene dark_scene();

/// A scene under a cube map, each side of 16 × 16 pixels of one colour.
void set_sky(Scene& scene, const Rgb& colour);

/// A ray from `eye` to `target`.
[[nodiscard]] inline Ray ray_to(const Vec3d& eye, const Vec3d& target) {
    return {eye, glm::normalize(target - eye)};
}

}  // namespace luch::testing
