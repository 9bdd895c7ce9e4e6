// How far off the picture is from ray-traced occlusion of the same radius, and why: too few
// samples, or what a picture cannot show.
#include "framework/math/spread.h"
#include "techniques/ssao/ssao.h"
#include "tests/testing/scenes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace luch::techniques::ssao {
namespace {

using testing::OwnStudio;
using testing::plane_of;

/// Things of several sizes in a room that is open to the eye.
Scene room() {
    Scene scene = testing::empty_scene();
    scene.lights.clear();
    scene.settings.frame = {120, 90};
    scene.camera.position = {0, 2.2, -6.5};
    scene.camera.pitch_deg = -14;
    scene.camera.fov_deg = 72;
    testing::add_shape(scene, Plane{.limit = 30});
    testing::add_shape(scene, Cube{.centre = {0, 8, 12}, .side = 20});
    testing::add_shape(scene, Cube{.centre = {-13, 8, 0}, .side = 20});
    testing::add_shape(scene, Sphere{.centre = {-1.2, 0.8, 0}, .radius = 0.8});
    testing::add_shape(scene, Sphere{.centre = {0.8, 0.5, -1}, .radius = 0.5});
    testing::add_shape(scene, Cube{.side = 1.4},
                       Transform::rotation(0.6, 0, 0).then(Transform::translation({2, 0.7, 0.3})));
    testing::add_shape(scene, Cube{.centre = {-1.5, 0.1, -1.8}, .side = 0.4});
    return scene;
}

using Params = std::vector<std::string>;

std::vector<float> visibility_of(const OwnStudio& studio, const Params& params,
                                 std::uint64_t seed = 0, const Steps& steps = reference()) {
    const std::unique_ptr<Technique> technique = make(steps, {});
    set_param(*technique, "radius=1");
    set_param(*technique, "show=visibility");
    for (const std::string& param : params) set_param(*technique, param);
    Shot shot = shot_of(studio.scene());
    shot.spp = 1;
    shot.seed = seed;
    return plane_of<float>(studio.render(*technique, shot), "visibility").pixels();
}

double mean_off(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
    return sum / static_cast<double>(a.size());
}

/// The slope of a line through points of log-log paper.
double slope_of(const std::vector<double>& x, const std::vector<double>& y) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double a = std::log(x[i]), b = std::log(y[i]);
        sx += a;
        sy += b;
        sxx += a * a;
        sxy += a * b;
    }
    const auto n = static_cast<double>(x.size());
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

const OwnStudio& studio() {
    static const OwnStudio made(room());
    return made;
}
const std::vector<float>& truth() {
    static const std::vector<float> traced = visibility_of(studio(), {"mode=rays", "samples=512"});
    return traced;
}

std::string samples(int n) {
    return fmt::format("samples={}", n);
}

/// Points that have nothing to do with one another.
void independent(Key key, std::span<Vec3> points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Key own = key.branch(i);
        const Vec2d disc = disc_of(own.square(0));
        const double height = std::sqrt(std::max(0.0, 1 - glm::dot(disc, disc)));
        points[i] = Vec3(Vec3d(disc, height) * std::sqrt(own.uniform(7)));
    }
}

TEST(SsaoError, OfTheLecturesPointsFallsWithTheirSquareRootDownToAFloor) {
    Steps steps = reference();
    steps.kernel = independent;
    const Params classic{"mode=classic", "blur=off"};
    const auto at = [&](int n, const Steps& of, std::uint64_t seed) {
        return visibility_of(studio(), {classic[0], classic[1], samples(n)}, seed, of);
    };
    const auto converged = at(2048, reference(), 99);
    std::vector<double> counts, sampling, spread_out, off;
    for (int n = 16; n <= 512; n *= 2) {
        counts.push_back(n);
        double error = 0;
        for (const std::uint64_t seed : {1, 2, 3}) {
            error += mean_off(at(n, steps, seed), converged) / 3;
        }
        sampling.push_back(error);
        spread_out.push_back(mean_off(at(n, reference(), 1), converged));
        off.push_back(mean_off(at(n, reference(), 1), truth()));
    }
    EXPECT_NEAR(slope_of(counts, sampling), -0.5, 0.1);
    EXPECT_LT(slope_of(counts, spread_out), -0.55) << "points that are spread evenly do better";
    const double floor = mean_off(converged, truth());
    EXPECT_NEAR(off.back(), floor, 0.02 * floor);
    EXPECT_NEAR(floor, 0.055, 0.01);
}

TEST(SsaoError, OfSlicesFallsDownToAFloor) {
    double floor_of_bits = 0;
    for (const char* mode : {"mode=bitmask", "mode=gtao"}) {
        const auto at = [&](int n, const char* blur, std::uint64_t seed = 0) {
            return visibility_of(studio(), {mode, blur, samples(n)}, seed);
        };
        const auto converged = at(18 * 256, "blur=off", 5);
        const double floor = mean_off(converged, truth());
        std::vector<double> counts, sampling;
        for (int n = 18; n <= 576; n *= 2) {
            counts.push_back(n);
            sampling.push_back(mean_off(at(n, "blur=off"), converged));
        }
        EXPECT_LT(slope_of(counts, sampling), -0.8) << mode;
        EXPECT_LT(floor, 0.02) << mode;
        EXPECT_NEAR(mean_off(at(576, "blur=off"), truth()), floor, 0.05 * floor) << mode;
        // The blur makes good for most of what one slice lacks.
        EXPECT_LT(mean_off(at(18, "blur=edges"), truth()), 1.4 * floor) << mode;
        EXPECT_GT(mean_off(at(18, "blur=off"), truth()), 3 * floor) << mode;
        if (floor_of_bits == 0) floor_of_bits = floor;
        EXPECT_LE(floor_of_bits, 1.02 * floor) << "the default is not the worse one";
    }
}

TEST(SsaoError, OfTheDefaultIsLessThanHalfOfTheLecturesAndLittleMoreAtHalfResolution) {
    const double best = mean_off(visibility_of(studio(), {}), truth());
    EXPECT_LT(2 * best, mean_off(visibility_of(studio(), {"mode=classic"}), truth()));
    const double half = mean_off(visibility_of(studio(), {"half=on"}), truth());
    EXPECT_GT(half, best);
    EXPECT_LT(half, 1.5 * best);
    EXPECT_LT(best, mean_off(visibility_of(studio(), {"blur=gaussian"}), truth()));
    EXPECT_LT(best, mean_off(visibility_of(studio(), {"thickness=0.1"}), truth()));
}

TEST(SsaoError, OfRaysFallsWithTheirNumber) {
    std::vector<double> counts, error;
    for (int n = 4; n <= 64; n *= 2) {
        counts.push_back(n);
        error.push_back(mean_off(visibility_of(studio(), {"mode=rays", samples(n)}, 9), truth()));
    }
    EXPECT_LT(slope_of(counts, error), -0.5);
}

}  // namespace
}  // namespace luch::techniques::ssao
