#include "framework/stress/made/everything.h"
#include "framework/stress/made/meshes.h"
#include "framework/stress/made/scenes.h"
#include "framework/stress/rays/ask.h"
#include "framework/trace/surface.h"

namespace luch::stress {
namespace {

/// Calls at_scale(scale, key) for 1e-3, 1e-2, …, 1e6.
template <class AtScale>
void each_scale(AtScale&& at_scale) {
    for (int exponent = -3; exponent <= 6; ++exponent) {
        at_scale(std::pow(10.0, exponent), Key(48).branch(exponent + 3));
    }
}

/// A direction of the half space that a normal points to, some of them grazing.
Vec3d outward(const Vec3d& normal, Key key) {
    Vec3d direction = random_point(key.branch(0), 1);
    const double along = glm::dot(direction, normal);
    if (along < 0) direction -= 2 * along * normal;
    if (key.bits(1) % 4 == 0) direction -= 0.999 * std::abs(along) * normal;
    return direction;
}

/// Things that are convex: what leaves them outwards never meets them again.
std::vector<Geometry> convex_things(double scale) {
    return {uv_sphere(12, 16, scale),
            Sphere{.centre = scale * Vec3d(0.1, 0.2, 0.3), .radius = scale},
            Cube{.centre = scale * Vec3d(0.1, 0.2, 0.3), .side = 2 * scale},
            Plane{.y = 0.3 * scale, .limit = 2 * scale}};
}

void leave(const Scene& scene, const Accelerator& accelerator, double scale, Key key,
           Tally& tally) {
    const Vec3d eye = scale * (random_point(key.branch(0), 1) + Vec3d(0, 3, 4));
    const Ray ray{eye, scale * random_point(key.branch(1), 1) - eye};
    WorkCounts work;
    const Hit hit = accelerator.closest(ray, work);
    if (!hit) return;
    const Surface surface = surface_at(scene, ray, hit);
    const Ray away = leaving(surface, outward(surface.geometric_normal, key.branch(2)));
    const Hit again = accelerator.closest(away, work);
    tally.judge(!again && !accelerator.occluded(away, work),
                [&] { return fmt::format("{}: met again at {}", words_of(away), again.t); });
    const Vec3d light = surface.position + 5 * scale * outward(surface.geometric_normal, key);
    const Ray shadow = shadow_ray(surface, light);
    tally.judge(!accelerator.occluded(shadow, work),
                [&] { return words_of(shadow) + ": in its own shadow"; });
}

/// Two squares, one a ten-thousandth of their size above the other.
Mesh thin_gap(double scale) {
    Mesh mesh;
    std::vector<Vec3d> positions;
    for (int i = 0; i < 8; ++i) {
        positions.push_back(scale * Vec3d((i & 1) * 2 - 1, (i & 4) * 2.5e-5, (i & 2) - 1));
    }
    for (const std::uint32_t first : {0u, 4u}) {
        mesh.triangles.push_back(
            {.position = {first, first + 1, first + 3}, .normal = {}, .uv = {}});
        mesh.triangles.push_back(
            {.position = {first, first + 3, first + 2}, .normal = {}, .uv = {}});
    }
    set_positions(mesh, positions);
    return mesh;
}

}  // namespace

Tally rays_off_surfaces(const Effort& effort) {
    Tally tally;
    each_scale([&](double scale, Key start) {
        for (const Geometry& thing : convex_things(scale)) {
            Scene scene = empty_scene();
            add(scene, thing, Lambert{}, Transform::rotation(0.3, 0.2, 0.1));
            const auto accelerator = build_accelerator(scene, effort.isa);
            for (std::uint64_t i = 0; i < effort.of(1'000'000) / 4; ++i) {
                leave(scene, *accelerator, scale, start.branch(thing.index()).branch(i), tally);
            }
        }
    });
    return tally;
}

Tally rays_through_thin_gaps(const Effort& effort) {
    Tally tally;
    each_scale([&](double scale, Key start) {
        Scene scene = empty_scene();
        add(scene, thin_gap(scale), Lambert{}, Transform::rotation(0.3, 0.2, 0.1));
        const auto accelerator = build_accelerator(scene, effort.isa);
        const Node& node = scene.nodes[0];
        WorkCounts work;
        for (std::uint64_t i = 0; i < effort.of(1'000'000) / 4; ++i) {
            const Key key = start.branch(i);
            const Vec3d up = glm::normalize(node.to_world.direction({0, 1, 0}));
            const Vec3d from = random_point(key.branch(0), 0.4) - 1.5 * up;
            const Ray ray{scale * from, up + 0.2 * random_point(key.branch(1), 1)};
            const Hit hit = accelerator->closest(ray, work);
            if (!hit) continue;
            // Seen from below: the lower square. Out of its other side the upper one is near.
            const Surface surface = surface_at(scene, ray, hit);
            const Vec3d through = outward(up, key.branch(2)) + 0.1 * up;
            const Hit above = accelerator->closest(leaving(surface, through), work);
            const bool other = above && above.primitive / 2 == 1 - hit.primitive / 2;
            tally.judge(hit.primitive / 2 == 0 && other,
                        [&] { return words_of(leaving(surface, through)) + ": leaks"; });
        }
    });
    return tally;
}

}  // namespace luch::stress
