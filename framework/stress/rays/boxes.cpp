#include "framework/accel/hit.h"
#include "framework/stress/made/everything.h"
#include "framework/stress/made/meshes.h"
#include "framework/stress/made/scenes.h"
#include "framework/stress/rays/ask.h"

namespace luch::stress {
namespace {

/// A box of floats, flat in `flat`, an axis or none.
Box random_box(int flat, Key key) {
    const double size = std::exp2(40 * key.uniform(0) - 20);
    const Vec3d lo = size * random_point(key.branch(1), 1);
    Vec3d extent = size * (0.55 + 0.5 * random_point(key.branch(2), 1));
    if (flat < 3) extent[flat] = 0;
    return {Vec3(lo), Vec3(Vec3d(Vec3(lo)) + extent)};
}

/// A ray that runs in a face of the box or in an edge, from outside to a point of it.
Ray ray_in_face(const Box& box, Key key) {
    const int axis = static_cast<int>(key.bits(0) % 3), other = (axis + 1) % 3;
    const bool in_edge = key.bits(1) % 2 == 0;
    Vec3d to, direction = random_point(key.branch(2), 1);
    for (int k = 0; k < 3; ++k) {
        const double share = 0.01 + 0.98 * key.uniform(3 + k);
        to[k] = box.lo[k] + share * (double{box.hi[k]} - box.lo[k]);
    }
    const auto keep_to = [&](int k) {
        to[k] = key.bits(6 + k) % 2 == 0 ? box.lo[k] : box.hi[k];
        direction[k] = key.bits(9 + k) % 2 == 0 ? 0.0 : -0.0;
    };
    keep_to(axis);
    if (in_edge) keep_to(other);
    const double away = 4 * max_norm(box.size()) + 1e-3 * max_norm(to);
    Vec3d origin = to - away * direction;
    for (int k = 0; k < 3; ++k) {
        if (direction[k] == 0) origin[k] = to[k];
    }
    return {origin, direction};
}

/// Cubes of side 1 with a gap of 1 between them, at whole numbers, 3 × 3 × 3.
Mesh cubes() {
    Mesh mesh;
    std::vector<Vec3d> positions;
    for (std::uint32_t cube = 0; cube < 27; ++cube) {
        const Vec3d corner(2 * (cube % 3), 2 * (cube / 3 % 3), 2 * (cube / 9));
        for (int i = 0; i < 8; ++i) positions.push_back(corner + Vec3d(i & 1, i / 2 & 1, i / 4));
        for (std::uint32_t axis = 0; axis < 3; ++axis) {
            const std::uint32_t u = 1u << (axis + 1) % 3, v = 1u << (axis + 2) % 3;
            for (const std::uint32_t first : {8 * cube, 8 * cube + (1u << axis)}) {
                mesh.triangles.push_back(
                    {.position = {first, first + u, first + u + v}, .normal = {}, .uv = {}});
                mesh.triangles.push_back(
                    {.position = {first, first + u + v, first + v}, .normal = {}, .uv = {}});
            }
        }
    }
    set_positions(mesh, positions);
    return mesh;
}

/// A point in one of the cubes.
Vec3d point_of_cubes(Key key) {
    Vec3d point;
    for (int k = 0; k < 3; ++k) {
        point[k] = static_cast<double>(2 * (key.bits(k) % 3)) + 0.01 + 0.98 * key.uniform(k + 3);
    }
    return point;
}

}  // namespace

Tally rays_in_faces_of_boxes(const Effort& effort) {
    Tally tally;
    for (std::uint64_t i = 0; i < effort.of(1'000'000); ++i) {
        const Key key = Key(46).branch(i);
        const Box box = random_box(static_cast<int>(i % 4), key.branch(0));
        const Ray ray = ray_in_face(box, key.branch(1));
        const Interval in = slab(box, object_ray(ray));
        tally.judge(in.near <= in.far, [&] {
            return fmt::format("{}: box ({}, {}, {}) to ({}, {}, {})", words_of(ray), box.lo.x,
                               box.lo.y, box.lo.z, box.hi.x, box.hi.y, box.hi.z);
        });
    }
    return tally;
}

Tally rays_in_faces_of_cubes(const Effort& effort) {
    Tally tally;
    Scene scene = empty_scene();
    add(scene, cubes(), Lambert{});
    const auto accelerator = build_accelerator(scene, effort.isa);
    each_packet(effort.of(1'000'000), Key(47), [&](Key key, int count) {
        const int axis = static_cast<int>(key.bits(0) % 3), other = (axis + 1) % 3;
        const bool in_edge = key.bits(1) % 2 == 0;
        RayPacket rays;
        rays.origin = random_point(key.branch(2), 4) + Vec3d(2.5);
        for (const int k : {axis, in_edge ? other : axis}) {
            rays.origin[k] = static_cast<double>(key.bits(3 + k) % 6);  // in nine cubes' faces
        }
        for (int i = 0; i < count; ++i) {
            const Key own = key.branch(i + 6);
            Vec3d direction = point_of_cubes(own) - rays.origin;
            for (const int k : {axis, in_edge ? other : axis}) {
                direction[k] = own.bits(k) % 2 == 0 ? 0.0 : -0.0;
            }
            rays.add(direction, std::numeric_limits<float>::infinity());
        }
        ask(*accelerator, rays, tally, [](int, const Hit& hit) { return static_cast<bool>(hit); });
    });
    return tally;
}

}  // namespace luch::stress
