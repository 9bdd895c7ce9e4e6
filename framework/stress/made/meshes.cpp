#include "framework/stress/made/meshes.h"

#include <numbers>

namespace luch::stress {
namespace {

void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.triangles.push_back({.position = {a, b, c}, .normal = {}, .uv = {}});
}

}  // namespace

Mesh uv_sphere(int rings, int segments, double radius) {
    constexpr double pi = std::numbers::pi;
    std::vector<Vec3d> positions{{0, radius, 0}, {0, -radius, 0}};
    for (int ring = 1; ring < rings; ++ring) {
        for (int k = 0; k < segments; ++k) {
            const double theta = pi * ring / rings, phi = 2 * pi * k / segments;
            positions.push_back(radius * Vec3d(std::sin(theta) * std::cos(phi), std::cos(theta),
                                               std::sin(theta) * std::sin(phi)));
        }
    }
    const auto at = [&](int ring, int k) {
        if (ring == 0) return 0u;
        if (ring == rings) return 1u;
        return static_cast<std::uint32_t>(2 + (ring - 1) * segments + k % segments);
    };
    Mesh mesh;
    set_positions(mesh, positions);
    for (int ring = 0; ring < rings; ++ring) {
        for (int k = 0; k < segments; ++k) {
            if (ring > 0) add_triangle(mesh, at(ring, k), at(ring, k + 1), at(ring + 1, k));
            if (ring + 1 < rings) {
                add_triangle(mesh, at(ring, k + 1), at(ring + 1, k + 1), at(ring + 1, k));
            }
        }
    }
    return mesh;
}

Mesh triangle_soup(int count, double size, Key key) {
    std::vector<Vec3d> positions;
    const auto point = [&](int i) {
        const Key k = key.branch(i);
        return 2.0 * Vec3d(k.uniform(0), k.uniform(1), k.uniform(2)) - 1.0;
    };
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const Vec3d centre = point(4 * i);
        for (int corner = 1; corner <= 3; ++corner) {
            positions.push_back(centre + size * point(4 * i + corner));
        }
    }
    set_positions(mesh, positions);
    for (int i = 0; i < count; ++i) {
        const auto first = static_cast<std::uint32_t>(3 * i);
        add_triangle(mesh, first, first + 1, first + 2);
    }
    return mesh;
}

Mesh triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    Mesh mesh;
    set_positions(mesh, {a, b, c});
    add_triangle(mesh, 0, 1, 2);
    return mesh;
}

Vec3d random_point(Key key, double size) {
    return size * (2.0 * Vec3d(key.uniform(0), key.uniform(1), key.uniform(2)) - 1.0);
}

Vec3d awkward_point(const Scene& scene, Key key) {
    const Node& node = scene.nodes[key.bits(0) % scene.nodes.size()];
    const auto* mesh = std::get_if<Mesh>(&scene.geometries[node.geometry]);
    if (mesh == nullptr) return node.to_world.point(random_point(key.branch(1), 1));
    const auto triangle = static_cast<std::uint32_t>(key.bits(2) % mesh->triangles.size());
    const Vec3d a(mesh->corner(triangle, 0)), b(mesh->corner(triangle, 1));
    const double along = key.bits(3) % 2 == 0 ? 0 : key.uniform(4);
    return node.to_world.point(a + along * (b - a));
}

}  // namespace luch::stress
