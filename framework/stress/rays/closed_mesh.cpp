#include "framework/stress/made/everything.h"
#include "framework/stress/made/meshes.h"
#include "framework/stress/made/scenes.h"
#include "framework/stress/rays/ask.h"

namespace luch::stress {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();
enum class Aim { nothing, edges, corners };

/// A closed mesh with slivers at its poles.
Scene ball_at(const Vec3d& centre, int rings, int segments) {
    Scene scene = empty_scene();
    add(scene, uv_sphere(rings, segments, 1), Lambert{}, Transform::translation(centre));
    return scene;
}

/// A direction from a point inside. The mesh is the scene's only node.
Vec3d aimed(const Scene& scene, Aim aim, const Vec3d& from, Key key) {
    if (aim == Aim::nothing) return random_point(key, 1);
    const auto& mesh = std::get<Mesh>(scene.geometries[0]);
    const auto triangle = static_cast<std::uint32_t>(key.bits(0) % mesh.triangles.size());
    const int corner = static_cast<int>(key.bits(1) % 3);
    const Vec3d a(mesh.corner(triangle, corner)), b(mesh.corner(triangle, (corner + 1) % 3));
    const double along = aim == Aim::corners ? 0 : key.uniform(2);
    return scene.nodes[0].to_world.point(a + along * (b - a)) - from;
}

Tally rays_inside(const Effort& effort, Aim aim, std::uint64_t stated) {
    Tally tally;
    for (const Vec3d& centre : {Vec3d(0), Vec3d(148376, 1234, -223423)}) {
        const Scene scene = ball_at(centre, 24, 40);
        const auto accelerator = build_accelerator(scene, effort.isa);
        const Key start = Key(41).branch(static_cast<int>(aim)).branch(centre.x > 0 ? 1 : 0);
        each_packet(effort.of(stated) / 2, start, [&](Key key, int count) {
            RayPacket rays;
            rays.origin = centre + random_point(key.branch(0), 0.4);
            for (int i = 0; i < count; ++i) {
                rays.add(aimed(scene, aim, rays.origin, key.branch(i + 1)), infinite);
            }
            ask(*accelerator, rays, tally,
                [](int, const Hit& hit) { return static_cast<bool>(hit); });
        });
    }
    return tally;
}

}  // namespace

Tally random_rays_inside(const Effort& effort) {
    return rays_inside(effort, Aim::nothing, 20'000'000);
}
Tally rays_at_edges(const Effort& effort) {
    return rays_inside(effort, Aim::edges, 1'000'000);
}
Tally rays_at_corners(const Effort& effort) {
    return rays_inside(effort, Aim::corners, 1'000'000);
}

Tally rays_inside_directly(const Effort& effort) {
    Tally tally;
    for (const Vec3d& centre : {Vec3d(0), Vec3d(148376, 1234, -223423)}) {
        const Scene scene = ball_at(centre, 6, 9);
        for (std::uint64_t i = 0; i < effort.of(3'000'000) / 2; ++i) {
            const Key key = Key(42).branch(i);
            const Vec3d from = centre + random_point(key.branch(0), 0.3);
            const Ray ray{from, aimed(scene, static_cast<Aim>(i % 3), from, key.branch(1))};
            const bool hit = static_cast<bool>(closest_brute(scene, ray));
            tally.judge(hit, [&] { return words_of(ray) + ": no triangle"; });
        }
    }
    return tally;
}

}  // namespace luch::stress
