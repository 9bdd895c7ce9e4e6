#include "framework/accel/accelerator.h"
#include "framework/accel/csg_hit.h"
#include "framework/math/rng.h"
#include "tests/testing/everything.h"
#include "tests/testing/meshes.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

namespace luch {
namespace {

using Operation = Csg::Operation;

Vec3d random_point(Key key, double size) {
    return size * (2.0 * Vec3d(key.uniform(0), key.uniform(1), key.uniform(2)) - 1.0);
}

Scene scene_of(std::vector<Geometry> geometries, const Csg& csg) {
    Scene scene = testing::empty_scene();
    scene.geometries = std::move(geometries);
    testing::add(scene, csg, Lambert{});
    return scene;
}

Hit hit_in(const Scene& scene, const Ray& ray) {
    WorkCounts work;
    const Hit hit = build_accelerator(scene)->closest(ray, work);
    EXPECT_EQ(hit, closest_brute(scene, ray));
    return hit;
}

/// Whether a point lies in a ball or a cube.
bool holds(const Geometry& geometry, const Vec3d& p) {
    if (const auto* ball = std::get_if<Sphere>(&geometry)) {
        return glm::length(p - ball->centre) < ball->radius;
    }
    const auto& cube = std::get<Cube>(geometry);
    return max_norm(p - cube.centre) < cube.side / 2;
}

bool holds(const std::vector<Geometry>& geometries, GeometryId id, const Vec3d& p) {
    const auto* csg = std::get_if<Csg>(&geometries[id]);
    if (csg == nullptr) return holds(geometries[id], p);
    const bool left = holds(geometries, csg->left, p), right = holds(geometries, csg->right, p);
    return Csg::Gate{csg->operation, 0, 0}.result(left, right);
}

/// Balls and cubes, and `solids` random expressions of all that comes before; the last is the last.
std::vector<Geometry> random_solid(Key key, int shapes, int solids) {
    std::vector<Geometry> geometries;
    for (int i = 0; i < shapes; ++i) {
        const Vec3d centre = random_point(key.branch(i), 1);
        const double size = 0.5 + key.branch(i).uniform(3);
        if (i % 2 == 0) {
            geometries.emplace_back(Sphere{.centre = centre, .radius = size});
        } else {
            geometries.emplace_back(Cube{.centre = centre, .side = 1.7 * size});
        }
    }
    for (int i = 0; i < solids; ++i) {
        const Key one = key.branch(100 + i);
        const auto last = static_cast<GeometryId>(geometries.size() - 1);
        const auto other = static_cast<GeometryId>(one.bits(0) % last);
        const auto operation = static_cast<Operation>(one.bits(1) % 3);
        geometries.emplace_back(one.bits(2) % 2 == 0
                                    ? make_csg(operation, last, other, geometries)
                                    : make_csg(operation, other, last, geometries));
    }
    return geometries;
}

TEST(CsgShape, IsHitWhereMembershipChangesAlongTheRay) {
    int hits = 0, misses = 0;
    for (int solid = 0; solid < 60; ++solid) {
        const auto geometries = random_solid(Key(1).branch(solid), 5, 6);
        const auto id = static_cast<GeometryId>(geometries.size() - 1);
        const Scene scene = scene_of(geometries, std::get<Csg>(geometries[id]));
        for (int i = 0; i < 300; ++i) {
            const Key key = Key(2).branch(solid).branch(i);
            const Ray ray{random_point(key.branch(0), i % 3 == 0 ? 1 : 4),
                          random_point(key.branch(1), 1)};
            const Hit hit = hit_in(scene, ray);
            const bool at_start = holds(geometries, id, ray.origin);
            // Every point up to the hit is like the first one; behind it, it is not.
            const double end = hit ? hit.t * (1 - 1e-5) : 20;
            for (int k = 1; k <= 60; ++k) {
                ASSERT_EQ(holds(geometries, id, ray.at(end * k / 60)), at_start)
                    << solid << ' ' << i;
            }
            if (hit) {
                ASSERT_NE(holds(geometries, id, ray.at(hit.t * (1 + 1e-5))), at_start);
            }
            ++(hit ? hits : misses);
        }
    }
    EXPECT_GT(hits, 2000);
    EXPECT_GT(misses, 2000);
}

TEST(CsgShape, CountsCrossingsBeyondTheRaysEnd) {
    // The far sides of both are beyond t_max, and still tell that the ray starts inside the cube.
    const std::vector<Geometry> geometries{Cube{.side = 4}, Sphere{}};
    const Scene scene = scene_of(geometries, make_csg(Operation::subtract, 0, 1, geometries));
    const Ray ray{{-1.5, 0, 0}, {1, 0, 0}, 0, 1};
    EXPECT_FLOAT_EQ(hit_in(scene, ray).t, 0.5);
    EXPECT_EQ(hit_in(scene, ray).primitive, 6u);
    EXPECT_FLOAT_EQ(hit_in(scene, {{-1.5, 0, 0}, {1, 0, 0}, 0.5f, 9}).t, 2.5);
    EXPECT_FALSE(hit_in(scene, {{-1.5, 0, 0}, {1, 0, 0}, 0, 0.5f}));
    // The same of parts that are followed along the ray: a ball of triangles, and ground.
    const std::vector<Geometry> others{testing::uv_sphere(8, 12, 2),
                                       Heightfield(Image<float>({4, 4}, 0.5f))};
    const Scene cut = scene_of(others, make_csg(Operation::subtract, 0, 1, others));
    EXPECT_FLOAT_EQ(hit_in(cut, {{0.3, 1.5, 0.2}, {0, -1, 0}, 0, 1.1f}).t, 1);
    EXPECT_FALSE(hit_in(cut, {{0.3, 1.5, 0.2}, {0, -1, 0}, 0, 0.9f}));
}

TEST(CsgShape, HasNoWallWherePartsTouch) {
    const std::vector<Geometry> geometries{Cube{.centre = {-1, 0, 0}, .side = 2},
                                           Cube{.centre = {1, 0, 0}, .side = 2}};
    for (int i = 0; i < 1000; ++i) {
        const Key key = Key(3).branch(i);
        const Ray ray{{-5, 0.9 * key.uniform(0), 0}, {1, 0.1 * key.uniform(1) - 0.09, 0.1}};
        const Scene join = scene_of(geometries, make_csg(Operation::join, 0, 1, geometries));
        const Hit in = hit_in(join, ray);
        ASSERT_TRUE(in);
        Ray onwards = ray;
        onwards.t_min = in.t;
        ASSERT_GT(hit_in(join, onwards).t, 6) << i;
        const Scene common = scene_of(geometries, make_csg(Operation::intersect, 0, 1, geometries));
        ASSERT_FALSE(hit_in(common, ray)) << i;
    }
    // Taking away what shares a face leaves no skin.
    const std::vector<Geometry> shell{Cube{.side = 2}, Cube{.centre = {0.5, 0, 0}, .side = 1}};
    const Scene cut = scene_of(shell, make_csg(Operation::subtract, 0, 1, shell));
    EXPECT_FLOAT_EQ(hit_in(cut, {{5, 0.2, 0.3}, {-1, 0, 0}}).t, 5);
    EXPECT_EQ(hit_in(cut, {{5, 0.2, 0.3}, {-1, 0, 0}}).primitive, 6u);
}

TEST(CsgShape, TakesAPlaneAsInsideBeforeIt) {
    // "An odd number of hits ahead" puts the inside of a plane between the eye and the plane.
    const std::vector<Geometry> geometries{Sphere{}, Plane{}};
    const Scene scene = scene_of(geometries, make_csg(Operation::intersect, 0, 1, geometries));
    EXPECT_FLOAT_EQ(hit_in(scene, {{0.5, 5, 0}, {0, -1, 0}}).t, 5 - std::sqrt(0.75f));
    EXPECT_FLOAT_EQ(hit_in(scene, {{0.5, 0.1, 0}, {0, -1, 0}}).t, 0.1f);
    EXPECT_FALSE(hit_in(scene, {{0.5, -0.1, 0}, {0, -1, 0}}));
}

/// A closed mesh minus nothing: a ray's crossings must be even in number from outside, odd from
/// inside, however it is aimed.
int wrong_parities(const Mesh& mesh, bool inside, int count) {
    int wrong = 0;
    for (int i = 0; i < count; ++i) {
        const Key key = Key(4).branch(i);
        const auto triangle = static_cast<std::uint32_t>(key.bits(0) % mesh.triangles.size());
        const Vec3d a(mesh.corner(triangle, 0)), b(mesh.corner(triangle, 1));
        const Vec3d target = i % 2 == 0 ? a : 0.5 * (a + b);
        Vec3d origin = inside ? random_point(key.branch(1), 0.2) : random_point(key.branch(1), 3);
        if (!inside && i % 3 == 0) origin[i % 9 / 3] = target[i % 9 / 3];
        if (!inside && max_norm(origin) < 1) continue;
        // In float from here on, so that corners and edges are met exactly now and then.
        const Ray ray{Vec3d(Vec3(origin)), Vec3d(Vec3(target) - Vec3(origin))};
        const ObjectRay object = object_ray(ray);
        Crossings crossings(ray);
        TriangleHit hit;
        for (std::uint32_t k = 0; k < mesh.triangles.size(); ++k) {
            if (cross_triangle(object, mesh.corner(k, 0), mesh.corner(k, 1), mesh.corner(k, 2),
                               hit)) {
                crossings.add(hit, k);
            }
        }
        wrong += (crossings.found().size() % 2 == 1) != inside;
    }
    return wrong;
}

TEST(Crossings, AlternateThroughAClosedMeshAtEveryCornerAndEdge) {
    const Mesh ball = testing::uv_sphere(8, 12, 0.5);
    EXPECT_EQ(wrong_parities(ball, false, 30'000), 0);
    EXPECT_EQ(wrong_parities(ball, true, 30'000), 0);
    const Mesh box = testing::mesh_of({{-1, -1, -1},
                                       {1, -1, -1},
                                       {-1, 1, -1},
                                       {1, 1, -1},
                                       {-1, -1, 1},
                                       {1, -1, 1},
                                       {-1, 1, 1},
                                       {1, 1, 1}},
                                      {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                       2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5});
    EXPECT_EQ(wrong_parities(box, false, 30'000), 0);
    EXPECT_EQ(wrong_parities(box, true, 30'000), 0);
}

TEST(Crossings, DecideEveryEdgeTheSameFromBothSides) {
    for (int i = 0; i < 20'000; ++i) {
        const Key key = Key(5).branch(i);
        const Vec3 a(random_point(key.branch(0), 1)), b(random_point(key.branch(1), 1));
        // Nearly or exactly in the plane of a and b.
        Vec3 d = static_cast<float>(key.uniform(3)) * a + static_cast<float>(key.uniform(4)) * b;
        if (i % 2 == 0) d = i % 4 == 0 ? a : -2.0f * b;
        const int sign = tilted_edge_sign(a, b, d);
        ASSERT_NE(sign, 0) << i;
        ASSERT_EQ(tilted_edge_sign(b, a, d), -sign) << i;
        using T = long double;
        const T exact = (T(a.y) * b.z - T(a.z) * b.y) * d.x + (T(a.z) * b.x - T(a.x) * b.z) * d.y +
                        (T(a.x) * b.y - T(a.y) * b.x) * d.z;
        if (std::abs(exact) > 1e-17L) {
            ASSERT_EQ(sign, exact > 0 ? 1 : -1) << i;
        }
    }
    EXPECT_EQ(tilted_edge_sign({1, 2, 3}, {2, 4, 6}, {1, 0, 0}), 0);
}

__extension__ typedef __int128 Whole;

TEST(Crossings, KnowSignsThatDoubleArithmeticCannot) {
    // Whole numbers of 24 bits, all but parallel: the products have 72 bits and cancel.
    int beyond_double = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Key key = Key(7).branch(i);
        Whole a[3], b[3], d[3];
        for (int k = 0; k < 3; ++k) {
            a[k] = 15'000'000 + static_cast<int>(key.bits(k) % 5);
            b[k] = a[k] + static_cast<int>(key.bits(3 + k) % 5) - 2;
            d[k] = a[k] + static_cast<int>(key.bits(6 + k) % 5) - 2;
        }
        const Whole value = (a[1] * b[2] - a[2] * b[1]) * d[0] +
                            (a[2] * b[0] - a[0] * b[2]) * d[1] + (a[0] * b[1] - a[1] * b[0]) * d[2];
        if (value == 0) continue;
        const auto floats = [](const Whole(&v)[3]) {
            return Vec3(static_cast<float>(v[0]), static_cast<float>(v[1]),
                        static_cast<float>(v[2]));
        };
        beyond_double += edge_sign(floats(a), floats(b), floats(d)) == 0;
        ASSERT_EQ(tilted_edge_sign(floats(a), floats(b), floats(d)), value > 0 ? 1 : -1) << i;
    }
    EXPECT_GT(beyond_double, 1000);
}

TEST(CsgShape, TakesMeshesAsItTakesShapes) {
    // A fine ball of triangles in a corner far from the origin, cut by a cube and hollowed by
    // itself.
    const Vec3d far{1000, -2000, 500};
    Mesh ball = testing::uv_sphere(24, 36, 1);
    ball.from_frame = ball.from_frame.then(Transform::translation(far));
    std::vector<Geometry> geometries{ball, Sphere{.centre = far, .radius = 0.5},
                                     Cube{.centre = far + Vec3d(1, 1, -1), .side = 2}};
    geometries.emplace_back(make_csg(Operation::subtract, 0, 1, geometries));
    geometries.emplace_back(make_csg(Operation::subtract, 3, 2, geometries));
    const Scene scene = scene_of(geometries, std::get<Csg>(geometries[4]));
    const auto accelerator = build_accelerator(scene);
    WorkCounts work;
    int hits = 0;
    for (int i = 0; i < 10'000; ++i) {
        const Key key = Key(6).branch(i);
        Vec3d target = far + random_point(key.branch(0), 1);
        if (i % 2 == 0) {
            const auto corner = static_cast<std::uint32_t>(key.bits(1) % ball.positions.size());
            target = ball.from_frame.point(Vec3d(ball.positions[corner]));
        }
        const Vec3d origin = far + random_point(key.branch(2), 3);
        const Ray ray{origin, target - origin};
        const Hit hit = accelerator->closest(ray, work);
        ASSERT_EQ(hit, closest_brute(scene, ray)) << i;
        if (!hit) continue;
        ++hits;
        const Vec3d p = ray.at(hit.t) - far;
        const double r = glm::length(p);
        ASSERT_TRUE(r > 0.499 && r < 1.001) << i;
        ASSERT_FALSE(p.x > 1e-3 && p.y > 1e-3 && p.z < -1e-3) << i;
        const double skin = std::min(
            {std::abs(r - 0.5), std::abs(r - 1) / 10, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        ASSERT_LE(skin, 1e-3) << i;
    }
    EXPECT_GT(hits, 3000);
}

TEST(CsgShape, HoldsMoreCrossingsThanItsScratchDoes) {
    // 2,000 sheets one behind the other: an even number, so the ray starts outside.
    Mesh sheets;
    std::vector<Vec3d> positions;
    for (int i = 0; i < 2000; ++i) {
        const double z = 1 + i / 1000.0;
        for (const Vec3d& p : {Vec3d(-1, -1, z), Vec3d(1, -1, z), Vec3d(0, 1, z)}) {
            positions.push_back(p);
        }
        const auto first = static_cast<std::uint32_t>(3 * i);
        sheets.triangles.push_back({{first, first + 1, first + 2}, {}, {}});
    }
    set_positions(sheets, positions);
    const std::vector<Geometry> geometries{sheets, Cube{.side = 100}};
    const Scene scene = scene_of(geometries, make_csg(Operation::intersect, 0, 1, geometries));
    EXPECT_NEAR(hit_in(scene, {{0, 0, 0}, {0, 0, 1}}).t, 1, 1e-6);
    EXPECT_NEAR(hit_in(scene, {{0, 0, 1.0005}, {0, 0, 1}}).t, 0.0005, 1e-6);
    EXPECT_FALSE(hit_in(scene, {{0, 0, 3.5}, {0, 0, 1}}));
}

}  // namespace
}  // namespace luch
