#include "framework/math/rng.h"
#include "framework/stress/made/meshes.h"
#include "framework/stress/made/scenes.h"
#include "framework/stress/raster/sights.h"
#include "framework/stress/rays/rows.h"

#include <fmt/format.h>

#include <bit>

// Exact items on meshes of every awkward sort.
namespace luch::stress {
namespace {

Camera random_camera(Key key) {
    const double fov = key.bits(3) % 8 == 0 ? 150 : 20 + 80 * key.uniform(4);
    return camera_at(random_point(key.branch(0), 1), 360 * key.uniform(1),
                     180 * key.uniform(2) - 90, fov);
}

/// A patch of triangles that share their edges: a fan around a point ahead of the camera, as large
/// as `size`, its rim of random radii.
Mesh fan(const Camera& camera, double size, Key key) {
    const Transform to_world = camera.to_world();
    const int sides = 3 + static_cast<int>(key.bits(0) % 4);
    const double distance = std::exp2(6 * key.uniform(1) - 3);
    std::vector<Vec3d> points{to_world.point({0.3 * distance * (key.uniform(2) - 0.5),
                                              0.3 * distance * (key.uniform(3) - 0.5), distance})};
    std::vector<std::uint32_t> indices;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * 3.14159265 * i / sides;
        const double radius = size * distance * (0.2 + key.uniform(10 + i));
        points.push_back(to_world.point({radius * std::cos(angle), radius * std::sin(angle),
                                         distance * (1 + 0.2 * size * key.uniform(30 + i))}));
        const auto next = static_cast<std::uint32_t>((i + 1) % sides);
        indices.insert(indices.end(), {0, static_cast<std::uint32_t>(i + 1), next + 1});
    }
    return mesh_of(points, indices);
}

/// What a row looks at. Of all pixels at least a share `hit` must show a mesh, and no more than
/// `doubtful` may be ambiguous, or the row would say nothing.
struct Wanted {
    std::uint64_t meshes;
    std::uint64_t key;
    Size size;
    double hit, doubtful;
};

/// made(i, key, camera) is the i-th mesh; it may move the camera before it.
template <class Made>
Tally looked_at(const Effort& effort, const Wanted& wanted, Made&& made) {
    Tally tally;
    Sights all;
    for (std::uint64_t i = 0; i < effort.of(wanted.meshes); ++i) {
        const Key key = Key(wanted.key).branch(i);
        Scene scene = empty_scene();
        scene.camera = random_camera(key);
        add_shape(scene, made(i, key, scene.camera));
        const Sights sights = compared_with_brute(scene, wanted.size, effort.isa);
        all += sights;
        tally.judge(sights.right(), [&] {
            return fmt::format("mesh {}: {} items, {} hits, {} depths and {} searches are wrong", i,
                               sights.wrong_items, sights.wrong_hits, sights.wrong_depths,
                               sights.wrong_searches);
        });
    }
    const auto pixels = static_cast<double>(all.pixels);
    tally.rays = all.pixels;
    const bool telling = static_cast<double>(all.hits) >= wanted.hit * pixels &&
                         static_cast<double>(all.ambiguous) <= wanted.doubtful * pixels;
    if (!telling) {
        tally.judge(false, [&] {
            return fmt::format("{} pixels of {} show a mesh, {} are ambiguous", all.hits,
                               all.pixels, all.ambiguous);
        });
    }
    return tally;
}

/// Four triangles; every third corner is a millionth ahead of the eye's plane, or a million away.
Tally items_off_the_frame(const Effort& effort, bool near, const Wanted& wanted) {
    return looked_at(effort, wanted, [near](std::uint64_t, Key key, const Camera& camera) {
        std::vector<Vec3d> points;
        for (int k = 0; k < 12; ++k) {
            Vec3d p = random_point(key.branch(20 + k), 2);
            if (!near) p *= k % 3 == 0 ? 1e6 : 1;
            if (near) p.z = k % 3 == 0 ? 1e-6 : 2 + p.z;
            points.push_back(camera.to_world().point(p));
        }
        return mesh_of(points, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
    });
}

}  // namespace

Tally items_of_patches(const Effort& effort) {
    return looked_at(effort, {160'000, 41, {8, 8}, 0.15, 0.005},
                     [](std::uint64_t i, Key key, const Camera& camera) {
                         return fan(camera, i % 2 == 0 ? 0.5 : 0.05, key.branch(9));
                     });
}

Tally items_behind_the_eye(const Effort& effort) {
    return looked_at(
        effort, {3'000, 42, {24, 16}, 0.5, 0.05}, [](std::uint64_t i, Key key, Camera& camera) {
            Mesh mesh = triangle_soup(40, i % 3 == 0 ? 2 : 0.7, key.branch(8));
            if (i % 4 == 0) {  // w = 0 exactly for a corner: axes, and an eye at its height
                const double yaw_deg = 90.0 * static_cast<double>(i % 16 / 4);
                camera = camera_at(Vec3d(mesh.corner(0, 1)), yaw_deg, 0, 90);
                camera.position.x = i % 8 == 0 ? camera.position.x : 0;
            }
            return mesh;
        });
}

Tally items_next_to_the_eye(const Effort& effort) {
    return items_off_the_frame(effort, true, {4'000, 43, {24, 16}, 0.1, 0.05});
}

Tally items_far_off_the_frame(const Effort& effort) {
    return items_off_the_frame(effort, false, {2'000, 47, {24, 16}, 0.05, 1});
}

Tally items_of_slivers(const Effort& effort) {
    return looked_at(effort, {4'000, 44, {24, 16}, 0.005, 0.05},
                     [](std::uint64_t, Key key, const Camera&) {
                         std::vector<Vec3d> points;
                         std::vector<std::uint32_t> indices;
                         const double width = std::exp2(-1 - 24 * key.uniform(5));
                         for (std::uint32_t k = 0; k < 20; ++k) {
                             const Vec3d a = random_point(key.branch(20 + k), 2),
                                         b = random_point(key.branch(60 + k), 2);
                             points.insert(points.end(),
                                           {a, b, a + width * random_point(key.branch(90 + k), 1)});
                             indices.insert(indices.end(), {3 * k, 3 * k + 1, 3 * k + 2});
                         }
                         return mesh_of(points, indices);
                     });
}

/// Triangles that lie in planes through the eye, and duplicates.
Tally items_seen_from_their_edge(const Effort& effort) {
    return looked_at(
        effort, {3'000, 45, {24, 16}, 0.17, 1}, [](std::uint64_t i, Key key, Camera& camera) {
            std::vector<Vec3d> points;
            std::vector<std::uint32_t> indices;
            for (std::uint32_t k = 0; k < 24; ++k) {
                Vec3d p = random_point(key.branch(20 + k), 2);
                if (i % 2 == 0) p[static_cast<int>(k / 3 % 3)] = 0.25;
                points.push_back(p);
                indices.push_back(k);
            }
            const double yaw_deg = 90.0 * static_cast<double>(i % 4) + (i % 8 < 4 ? 0 : 17);
            camera = camera_at(Vec3d(0.25, 0.25, 0.25), yaw_deg, 0, 90);
            return mesh_of(points, indices);
        });
}

Tally items_of_random_bits(const Effort& effort) {
    return looked_at(
        effort, {2'000, 46, {24, 16}, 0.07, 1}, [](std::uint64_t, Key key, const Camera&) {
            Mesh mesh = triangle_soup(30, 1, key.branch(8));
            for (std::uint32_t k = 0; k < 6; ++k) {
                Vec3& p = mesh.positions[key.bits(k) % mesh.positions.size()];
                p[static_cast<int>(k % 3)] =
                    std::bit_cast<float>(static_cast<std::uint32_t>(key.bits(100 + k)));
            }
            for (int k = 0; k < 3; ++k) {
                mesh.triangles[3].position[k] = mesh.triangles[3].position[0];
            }
            return mesh;
        });
}

}  // namespace luch::stress
