#include "framework/measure/bench_shots.h"

#include "framework/math/rng.h"

#include <numbers>

namespace luch {
namespace {

Vec3d rounded(const Vec3d& v) {
    return Vec3d(Vec3(v));
}

/// Pixel i of the order that keeps neighbours together.
std::pair<int, int> pixel_of(int i, int side) {
    const int tile = i / 256, block = i / 16 % 16, inner = i % 16;
    const int across = side / 16;
    return {tile % across * 16 + block % 4 * 4 + inner % 4,
            tile / across * 16 + block / 4 * 4 + inner / 4};
}

void add(BenchShots& shots, const Ray& ray) {
    shots.rays.push_back(ray);
    shots.active += ray.t_max > ray.t_min ? 1 : 0;
}

void pack(BenchShots& shots, const Vec3d& origin) {
    shots.packets.resize(shots.rays.size() / RayPacket::capacity);
    for (std::size_t i = 0; i < shots.rays.size(); ++i) {
        RayPacket& packet = shots.packets[i / RayPacket::capacity];
        packet.origin = origin;
        packet.add(shots.rays[i].direction, shots.rays[i].t_max);
    }
}

/// A direction around the normal, its density proportional to the cosine.
Vec3d bounce(const Vec3d& normal, Key key) {
    const double height = 2 * key.uniform(0) - 1, angle = 2 * std::numbers::pi * key.uniform(1);
    const double radius = std::sqrt(1 - height * height);
    return normal + Vec3d(radius * std::cos(angle), radius * std::sin(angle), height) * 0.999;
}

/// A point of a surface, lifted off it along the normal that points to `towards`.
struct Lifted {
    Vec3d point, normal;
};

Lifted lifted(const Scene& scene, const Hit& hit, const Vec3d& towards, double offset) {
    const Node& node = scene.nodes[hit.node];
    const Mesh& mesh = std::get<Mesh>(scene.geometries[node.geometry]);
    std::array<Vec3d, 3> corner;
    for (int k = 0; k < 3; ++k) {
        corner[k] = node.to_world.point(Vec3d(mesh.corner(hit.primitive, k)));
    }
    const Vec3d edge1 = corner[1] - corner[0], edge2 = corner[2] - corner[0];
    const Vec3d point = corner[0] + double{hit.u} * edge1 + double{hit.v} * edge2;
    Vec3d normal = glm::normalize(glm::cross(edge1, edge2));
    if (glm::dot(normal, towards - point) < 0) normal = -normal;
    return {point + offset * normal, normal};
}

}  // namespace

BenchShots primary_shots(const BenchView& view, int side) {
    const Vec3d forward = glm::normalize(view.at - view.eye);
    const Vec3d right = glm::normalize(glm::cross(forward, Vec3d(0, 1, 0)));
    const Vec3d up = glm::cross(right, forward);
    const double half = std::tan(std::numbers::pi / 6);
    BenchShots shots;
    for (int i = 0; i < side * side; ++i) {
        const auto [x, y] = pixel_of(i, side);
        const double sx = (2 * (x + 0.5) / side - 1) * half, sy = (1 - 2 * (y + 0.5) / side) * half;
        add(shots, {rounded(view.eye), rounded(glm::normalize(forward + sx * right + sy * up))});
    }
    pack(shots, rounded(view.eye));
    return shots;
}

BenchShots shadow_shots(const Scene& scene, const BenchView& view, std::span<const Hit> hits,
                        double offset) {
    BenchShots shots;
    shots.occlusion = true;
    const Vec3d light = rounded(view.light);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (!hits[i]) {
            add(shots, {light, {0, 0, 1}, 0, -1});
            continue;
        }
        const Lifted place = lifted(scene, hits[i], light, offset);
        add(shots, {light, rounded(place.point - light), 0, 1});
    }
    pack(shots, light);
    return shots;
}

BenchShots diffuse_shots(const Scene& scene, const BenchShots& primary, std::span<const Hit> hits,
                         double offset) {
    BenchShots shots;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (!hits[i]) {
            add(shots, {{0, 0, 0}, {0, 0, 1}, 0, -1});
            continue;
        }
        const Lifted place = lifted(scene, hits[i], primary.rays[i].origin, offset);
        add(shots, {rounded(place.point), rounded(bounce(place.normal, Key(1).branch(i)))});
    }
    return shots;
}

}  // namespace luch
