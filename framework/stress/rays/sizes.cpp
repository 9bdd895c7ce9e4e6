#include "framework/measure/bench_judge.h"
#include "framework/stress/made/everything.h"
#include "framework/stress/made/meshes.h"
#include "framework/stress/made/scenes.h"
#include "framework/stress/rays/ask.h"
#include "framework/stress/rays/exact_sphere.h"

namespace luch::stress {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

/// Calls at_size(size, key) for 1e-20, 1e-19, …, 1e20.
template <class AtSize>
void each_size(AtSize&& at_size) {
    for (int exponent = -20; exponent <= 20; ++exponent) {
        at_size(std::pow(10.0, exponent), Key(43).branch(exponent + 20));
    }
}

/// Rays from about a thing of that size, half of them with directions of about its size.
RayPacket rays_about(const Vec3d& centre, double size, int count, Key key) {
    RayPacket rays;
    rays.origin = centre + size * (random_point(key.branch(0), 2) + Vec3d(0, 0, -3.5));
    for (int i = 0; i < count; ++i) {
        const Vec3d to = centre + size * random_point(key.branch(i + 1), 1) - rays.origin;
        rays.add(i % 2 == 0 ? to : to / size, infinite);
    }
    return rays;
}

}  // namespace

Tally meshes_of_every_size(const Effort& effort) {
    Tally tally;
    each_size([&](double size, Key start) {
        Scene scene = empty_scene();
        add(scene, uv_sphere(6, 9, size), Lambert{});
        const Node& node = scene.nodes[0];
        const auto& mesh = std::get<Mesh>(scene.geometries[0]);
        const auto accelerator = build_accelerator(scene, effort.isa);
        each_packet(effort.of(400'000) / 41, start, [&](Key key, int count) {
            const RayPacket rays = rays_about(Vec3d(0), size, count, key);
            ask(*accelerator, rays, tally, [&](int i, const Hit& hit) {
                const Ray ray = rays.ray(i);
                const Judgement truth = judged(mesh, 1, node.to_object.ray(ray));
                if (!hit) return truth.verdict != Verdict::hit;
                const double distance = glm::length(ray.at(hit.t) / size);
                return truth.verdict != Verdict::miss && distance > 0.7 && distance < 1 + 1e-5 &&
                       std::ranges::count(truth.nearest, hit.primitive) > 0;
            });
        });
    });
    return tally;
}

Tally spheres_of_every_size(const Effort& effort) {
    Tally tally;
    each_size([&](double size, Key start) {
        Scene scene = empty_scene();
        const Sphere sphere{.centre = size * Vec3d(0.1, -0.2, 0.3), .radius = size};
        add(scene, sphere, Lambert{});
        const auto accelerator = build_accelerator(scene, effort.isa);
        each_packet(effort.of(4'000'000) / 41, start, [&](Key key, int count) {
            const RayPacket rays = rays_about(sphere.centre, size, count, key);
            ask(*accelerator, rays, tally, [&](int i, const Hit& hit) {
                return is_right(exact_hit(sphere, rays.ray(i)), hit, 1e-6);
            });
        });
    });
    return tally;
}

}  // namespace luch::stress
