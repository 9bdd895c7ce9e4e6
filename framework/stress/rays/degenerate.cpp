#include "framework/accel/wide/build.h"
#include "framework/stress/made/everything.h"
#include "framework/stress/made/meshes.h"
#include "framework/stress/made/scenes.h"
#include "framework/stress/rays/ask.h"

#include <cstring>

namespace luch::stress {
namespace {

void add_triangle(Mesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {a, b, c});
    mesh.triangles.push_back({.position = {first, first + 1, first + 2}, .normal = {}, .uv = {}});
}

float any_float(Key key) {
    const auto bits = static_cast<std::uint32_t>(key.bits(0));
    float value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

Vec3 corner_of(Key key) {
    return Vec3(random_point(key, 1));
}

/// One kind of bad mesh.
Mesh mesh_of_kind(int kind, Key key) {
    Mesh mesh;
    for (std::uint64_t i = 0; i < 600; ++i) {
        const Key own = key.branch(i);
        const Vec3 a = corner_of(own.branch(0)), b = corner_of(own.branch(1));
        const Vec3 c = corner_of(own.branch(2));
        switch (kind) {
            case 0:  // collinear
                add_triangle(mesh, a, b, a + static_cast<float>(own.uniform(3)) * (b - a));
                break;
            case 1:  // points, and two corners the same
                add_triangle(mesh, a, a, i % 2 == 0 ? a : b);
                break;
            case 2:  // slivers
                add_triangle(mesh, a, b, a + (b - a) * 0.5f + 1e-7f * c);
                break;
            case 3:  // random bits: NaN, infinities, denormals, 1e±38
                add_triangle(mesh, {any_float(own.branch(4)), any_float(own.branch(5)), a.z},
                             {b.x, any_float(own.branch(6)), any_float(own.branch(7))}, c);
                break;
            default:  // duplicates of duplicates
                add_triangle(mesh, corner_of(key.branch(i % 7)), corner_of(key.branch(i % 7 + 50)),
                             corner_of(key.branch(i % 7 + 90)));
        }
        if (i % 3 == 0) add_triangle(mesh, a, b, c);  // a sound one among them
    }
    return mesh;
}

int depth_of(const wide::Tree& tree, std::uint32_t child) {
    if ((child & wide::leaf_bit) != 0) return 0;
    const wide::Node& node = tree.nodes[child];
    int deepest = 0;
    for (int slot = 0; (node.used >> slot & 1) != 0 && slot < wide::node_width; ++slot) {
        deepest = std::max(deepest, depth_of(tree, node.child[slot]));
    }
    return deepest + 1;
}

bool has_nan(const Hit& hit) {
    return std::isnan(hit.t) || std::isnan(hit.u) || std::isnan(hit.v);
}

void compare(Mesh mesh, std::uint64_t total, const Effort& effort, Key start, Tally& tally) {
    const int depth = depth_of(wide::built(mesh, effort.isa), 0);
    tally.judge(depth < 24, [&] { return fmt::format("depth {}", depth); });
    Scene scene = empty_scene();
    add(scene, std::move(mesh), Lambert{});
    const auto accelerator = build_accelerator(scene, effort.isa);
    each_packet(total, start, [&](Key key, int count) {
        RayPacket rays;
        rays.origin = random_point(key.branch(0), 2);
        for (int i = 0; i < count; ++i) {
            const Key own = key.branch(i + 1);
            const bool aimed = i % 2 == 0;
            const Vec3d to = aimed ? awkward_point(scene, own) : random_point(own, 1);
            rays.add(to - rays.origin, std::numeric_limits<float>::infinity());
        }
        ask(*accelerator, rays, tally, [&](int i, const Hit& hit) {
            return hit == closest_brute(scene, rays.ray(i)) && !has_nan(hit);
        });
    });
}

}  // namespace

Tally degenerate_meshes(const Effort& effort) {
    Tally tally;
    for (int kind = 0; kind < 5; ++kind) {
        const Key key = Key(49).branch(kind);
        compare(mesh_of_kind(kind, key), effort.of(20'000), effort, key, tally);
    }
    Mesh same = triangle({-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
    same.triangles.resize(10'000, same.triangles[0]);
    compare(same, effort.of(5'000), effort, Key(50), tally);
    compare(Mesh{}, 0, effort, Key(51), tally);
    return tally;
}

}  // namespace luch::stress
