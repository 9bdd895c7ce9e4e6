#include "tests/stability/ask.h"
#include "tests/stability/exact_sphere.h"
#include "tests/testing/everything.h"
#include "tests/testing/meshes.h"
#include "tests/testing/scenes.h"

namespace luch::stability {
namespace {

using testing::random_point;

constexpr float infinite = std::numeric_limits<float>::infinity();

void compare(const Sphere& sphere, const Vec3d& eye, double tolerance, const Effort& effort,
             Counts& counts) {
    Scene scene = testing::empty_scene();
    testing::add(scene, sphere, Lambert{});
    const auto accelerator = build_accelerator(scene, effort.isa);
    const bool near = sphere.radius > 10;
    each_packet(effort.of(1'000'000), Key(44), [&](Key key, int count) {
        RayPacket rays;
        rays.origin = eye;
        for (int i = 0; i < count; ++i) {
            const Vec3d to = random_point(key.branch(i), 1);
            rays.add(near ? to : sphere.centre + 1.2 * to - eye, infinite);
        }
        ask(*accelerator, rays, counts, [&](int i, const Hit& hit) {
            return is_right(exact_hit(sphere, rays.ray(i)), hit, tolerance);
        });
    });
}

}  // namespace

Counts small_and_huge_spheres(const Effort& effort) {
    Counts counts;
    const Vec3d afar = 1e4 / std::sqrt(14.0) * Vec3d(1, 2, -3);
    compare({.centre = {0, 0, 0}, .radius = 1}, afar, 1e-6, effort, counts);
    compare({.centre = {0, -1e6, 0}, .radius = 1e6}, {0, 1, 0}, 1e-6, effort, counts);
    compare({.centre = {0, -1e12, 0}, .radius = 1e12}, {0, 1, 0}, 1e-4, effort, counts);
    return counts;
}

Counts concentric_spheres(const Effort& effort) {
    Counts counts;
    Scene scene = testing::empty_scene();
    testing::add(scene, Sphere{.radius = 1}, Lambert{});
    testing::add(scene, Sphere{.radius = 1 + 4e-5}, Lambert{});
    const auto accelerator = build_accelerator(scene, effort.isa);
    each_packet(effort.of(2'000'000), Key(45), [&](Key key, int count) {
        const bool inside = key.bits(0) % 2 == 0;
        RayPacket rays;
        rays.origin = random_point(key.branch(1), 0.5);
        if (!inside) rays.origin += (2 + 98 * key.uniform(2)) * Vec3d(0.6, 0, -0.8);
        for (int i = 0; i < count; ++i) {
            const Vec3d to = random_point(key.branch(i + 3), 0.57);
            rays.add(inside ? to : to - rays.origin, infinite);
        }
        ask(*accelerator, rays, counts,
            [&](int, const Hit& hit) { return hit.node == (inside ? 0u : 1u); });
    });
    return counts;
}

}  // namespace luch::stability
