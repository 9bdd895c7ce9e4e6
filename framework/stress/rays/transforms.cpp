#include "framework/stress/made/everything.h"
#include "framework/stress/made/meshes.h"
#include "framework/stress/made/scenes.h"
#include "framework/stress/rays/ask.h"
#include "framework/stress/rays/exact_sphere.h"

#include <stdexcept>

namespace luch::stress {
namespace {

constexpr double tolerance = 1e-5;

/// Rows of numbers that no transform should be given: what they flatten differs.
glm::dmat3 singular_matrix(Key key) {
    const Vec3d a = random_point(key.branch(0), 1), b = random_point(key.branch(1), 1);
    const double scale = std::pow(10.0, 40 * key.uniform(2) - 20);
    switch (key.bits(3) % 5) {
        case 0:
            return scale * glm::dmat3(a, a, b);  // two rows the same
        case 1:
            return scale * glm::dmat3(a, b, a + 2.0 * b);  // in one plane
        case 2:
            return scale * glm::dmat3(a, Vec3d(0), b);
        case 3:
            return glm::dmat3(a, b, Vec3d(std::numeric_limits<double>::quiet_NaN()));
        default:
            return glm::dmat3(a, b, Vec3d(std::numeric_limits<double>::infinity(), 0, 0));
    }
}

/// A transform that is awkward but sound: mirrored, sheared, and of any scale from 1e-8 to 1e8.
Transform awkward_transform(Key key) {
    const double scale = std::pow(10.0, 16 * key.uniform(0) - 8);
    Transform place = Transform::rotation(6 * key.uniform(1), 3 * key.uniform(2), key.uniform(3));
    if (key.bits(4) % 2 == 0) place.matrix[0] = -place.matrix[0];
    if (key.bits(5) % 2 == 0) place.matrix[1] += (4 * key.uniform(6) - 2) * place.matrix[0];
    if (key.bits(7) % 2 == 0) place.matrix[2] *= 0.05 + key.uniform(8);
    place.matrix *= scale;
    place.offset = scale * random_point(key.branch(9), 5);
    return place;
}

/// Rays from about a unit ball's place in the world to points of it.
RayPacket rays_to(const Transform& to_world, int count, Key key) {
    RayPacket rays;
    rays.origin = to_world.point(random_point(key.branch(0), 2) + Vec3d(0, 0, -4));
    for (int i = 0; i < count; ++i) {
        rays.add(to_world.point(random_point(key.branch(i + 1), 1)) - rays.origin,
                 std::numeric_limits<float>::infinity());
    }
    return rays;
}

/// The nearest of a mesh's triangles by Cramer's rule in double, for a ray in the mesh's own frame;
/// nothing where it is close to an edge of any.
struct DoubleHit {
    double t = std::numeric_limits<double>::infinity();
    bool sure = true;
};
DoubleHit hit_in_double(const Mesh& mesh, const Ray& ray) {
    DoubleHit nearest;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const Vec3d a(mesh.corner(i, 0)), b(mesh.corner(i, 1)), c(mesh.corner(i, 2));
        const Vec3d across = glm::cross(ray.direction, c - a), from = ray.origin - a;
        const double determinant = glm::dot(b - a, across);
        const double u = glm::dot(from, across) / determinant;
        const Vec3d along = glm::cross(from, b - a);
        const double v = glm::dot(ray.direction, along) / determinant;
        const double t = glm::dot(c - a, along) / determinant;
        const double inside = std::min({u, v, 1 - u - v});
        if (!(inside > -tolerance)) continue;
        if (inside < tolerance) nearest.sure = false;
        if (t > 0) nearest.t = std::min(nearest.t, t);
    }
    return nearest;
}

bool is_near(double t, const Hit& hit) {
    if (!std::isfinite(t)) return !hit;
    return hit && std::abs(hit.t - t) <= tolerance * t;
}

}  // namespace

Tally singular_transforms(const Effort& effort) {
    Tally tally;
    for (std::uint64_t i = 0; i < effort.of(100'000); ++i) {
        const Transform flat{singular_matrix(Key(56).branch(i)), Vec3d(1, 2, 3)};
        Scene scene = empty_scene();
        bool refused = false;
        try {
            add(scene, Sphere{}, Lambert{}, flat);
        } catch (const std::domain_error&) {
            refused = true;
        }
        tally.judge(refused, [&] { return fmt::format("matrix {} was taken", i); });
    }
    return tally;
}

Tally transformed_spheres(const Effort& effort) {
    Tally tally;
    for (std::uint64_t i = 0; i < std::max<std::uint64_t>(effort.of(1'000'000) / 256, 20); ++i) {
        const Key key = Key(57).branch(i);
        Scene scene = empty_scene();
        const Sphere sphere{};
        add(scene, sphere, Lambert{}, awkward_transform(key.branch(0)));
        const auto accelerator = build_accelerator(scene, effort.isa);
        const RayPacket rays = rays_to(scene.nodes[0].to_world, 256, key.branch(1));
        ask(*accelerator, rays, tally, [&](int k, const Hit& hit) {
            const Ray in_object = scene.nodes[0].to_object.ray(rays.ray(k));
            return is_right(exact_hit(sphere, in_object), hit, tolerance);
        });
    }
    return tally;
}

Tally transformed_meshes(const Effort& effort) {
    Tally tally;
    for (std::uint64_t i = 0; i < std::max<std::uint64_t>(effort.of(200'000) / 256, 20); ++i) {
        const Key key = Key(58).branch(i);
        Scene scene = empty_scene();
        add(scene, uv_sphere(6, 9, 1), Lambert{}, awkward_transform(key.branch(0)));
        const auto accelerator = build_accelerator(scene, effort.isa);
        const auto& mesh = std::get<Mesh>(scene.geometries[0]);
        const Node& node = scene.nodes[0];
        const RayPacket rays = rays_to(mesh.from_frame.inverse().then(node.to_world), 256, key);
        ask(*accelerator, rays, tally, [&](int k, const Hit& hit) {
            const DoubleHit truth = hit_in_double(mesh, node.to_object.ray(rays.ray(k)));
            return !truth.sure || is_near(truth.t, hit);
        });
    }
    return tally;
}

}  // namespace luch::stress
