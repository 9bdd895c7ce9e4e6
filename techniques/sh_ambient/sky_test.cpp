// Irradiance of whole skies against sampling them.
#include "techniques/sh_ambient/sky.h"

#include "framework/math/spread.h"
#include "framework/scene/loader/loader.h"
#include "techniques/sh_ambient/incoming.h"
#include "techniques/sh_ambient/ringing.h"

#include <gtest/gtest.h>

#include <numbers>

namespace luch::techniques::sh_ambient {
namespace {

const Steps steps = reference();

Scene scene_of(const std::string& name) {
    return load_scene(LUCH_SOURCE_DIR "/scenes/" + name + "/" + name + ".scene").scene;
}

/// Unit normals all around.
std::vector<Vec3d> normals(int count) {
    std::vector<Vec3d> all;
    for (int i = 0; i < count; ++i) {
        const Vec2d square = spread(Key(5), static_cast<std::uint32_t>(i));
        const double z = 1 - 2 * square.x, turn = 2 * std::numbers::pi * square.y;
        const double r = std::sqrt(1 - z * z);
        all.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
    }
    return all;
}

Rgb irradiance(const Sh9& light, const Vec3d& normal) {
    const Vec3 n(normal);
    Rgb e;
    steps.irradiance(light, {&n, 1}, {&e, 1});
    return e;
}

/// Errors over all normals and colours, relative to the mean irradiance.
struct Error {
    double mean = 0, most = 0;
};

Error error_of(const Scene& scene, const Sh9& light, int samples = 16384) {
    Error error;
    double whole = 0, most = 0, sum = 0;
    const auto all = normals(256);
    for (const Vec3d& n : all) {
        const Rgb truth =
            std::numbers::pi_v<float> * mean_of_sky(scene, n, samples, key_of(Key(1), n));
        const Rgb off = glm::abs(truth - irradiance(light, n));
        sum += off.x + off.y + off.z;
        whole += truth.x + truth.y + truth.z;
        most = std::max<double>(most, max_norm(off));
    }
    return {sum / whole, most / (whole / (3.0 * all.size()))};
}

TEST(Probe, Errors) {
    for (const char* name : {"mirrors", "island", "die", "clay"}) {
        const Scene scene = scene_of(name);
        const SkyLight sky = sky_light_of(scene, steps);
        for (int degree = 0; degree < 3; ++degree) {
            const Error e = error_of(scene, tamed(sky.light, degree, Ringing::off));
            const Error f = error_of(scene, tamed(sky.light, degree, Ringing::least));
            const Error g = error_of(scene, tamed(sky.light, degree, Ringing::scaled));
            std::printf("%s %d: %.4f %% most %.4f  least %.4f  scaled %.4f\n", name, degree,
                        100 * e.mean, 100 * e.most, 100 * f.mean, 100 * g.mean);
        }
    }
}

}  // namespace
}  // namespace luch::techniques::sh_ambient
