#include "framework/stress/made/everything.h"
#include "framework/stress/made/meshes.h"
#include "framework/stress/made/scenes.h"
#include "framework/stress/rays/ask.h"
#include "framework/stress/rays/exact_sphere.h"

namespace luch::stress {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

void compare(const Sphere& sphere, const Vec3d& eye, double tolerance, const Effort& effort,
             Tally& tally) {
    Scene scene = empty_scene();
    add(scene, sphere, Lambert{});
    const auto accelerator = build_accelerator(scene, effort.isa);
    const bool near = sphere.radius > 10;
    each_packet(effort.of(1'000'000), Key(44), [&](Key key, int count) {
        RayPacket rays;
        rays.origin = eye;
        for (int i = 0; i < count; ++i) {
            const Vec3d to = random_point(key.branch(i), 1);
            rays.add(near ? to : sphere.centre + 1.2 * to - eye, infinite);
        }
        ask(*accelerator, rays, tally, [&](int i, const Hit& hit) {
            return is_right(exact_hit(sphere, rays.ray(i)), hit, tolerance);
        });
    });
}

}  // namespace

Tally small_and_huge_spheres(const Effort& effort) {
    Tally tally;
    const Vec3d afar = 1e4 / std::sqrt(14.0) * Vec3d(1, 2, -3);
    compare({.centre = {0, 0, 0}, .radius = 1}, afar, 1e-6, effort, tally);
    compare({.centre = {0, -1e6, 0}, .radius = 1e6}, {0, 1, 0}, 1e-6, effort, tally);
    compare({.centre = {0, -1e12, 0}, .radius = 1e12}, {0, 1, 0}, 1e-4, effort, tally);
    return tally;
}

Tally concentric_spheres(const Effort& effort) {
    Tally tally;
    Scene scene = empty_scene();
    add(scene, Sphere{.radius = 1}, Lambert{});
    add(scene, Sphere{.radius = 1 + 4e-5}, Lambert{});
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
        ask(*accelerator, rays, tally,
            [&](int, const Hit& hit) { return hit.node == (inside ? 0u : 1u); });
    });
    return tally;
}

}  // namespace luch::stress
