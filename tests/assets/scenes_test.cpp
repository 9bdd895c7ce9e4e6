#include "framework/accel/accelerator.h"
#include "framework/math/rng.h"
#include "framework/scene/loader/loader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace luch {
namespace {

Loaded loaded(const std::string& name) {
    return load_scene(std::filesystem::path(LUCH_SOURCE_DIR) / "scenes" / name / (name + ".scene"));
}

template <class Kind, class Items>
long count_of(const Items& items) {
    return std::count_if(items.begin(), items.end(),
                         [](const auto& item) { return std::holds_alternative<Kind>(item); });
}

/// A direction, uniform over the sphere.
Vec3d direction(const Key& key) {
    const Vec2d p = key.square(0);
    const double z = 2 * p.x - 1, r = std::sqrt(1 - z * z), turn = 2 * M_PI * p.y;
    return {r * std::cos(turn), r * std::sin(turn), z};
}

int rays_that_escape(const Scene& scene) {
    const auto accelerator = build_accelerator(scene);
    WorkCounts work;
    int escaped = 0;
    for (int k = 0; k < 4000; ++k) {
        const Ray ray{scene.camera.position, direction(Key(k))};
        escaped += !accelerator->occluded(ray, work);
    }
    return escaped;
}

TEST(OwnScenes, LoadWithoutAWarning) {
    for (const char* name : {"room", "spheres", "mirrors", "glass", "clay"}) {
        const Loaded scene = loaded(name);
        EXPECT_TRUE(scene.warnings.empty()) << name << ": " << scene.warnings.front();
        EXPECT_EQ(scene.scene.settings.frame, (Size{640, 480})) << name;
        EXPECT_FALSE(scene.scene.camera.depth_of_field) << name;
    }
}

TEST(Room, IsClosed) {
    EXPECT_EQ(rays_that_escape(loaded("room").scene), 0);
    EXPECT_GT(rays_that_escape(loaded("mirrors").scene), 0);
}

TEST(Room, HasOneAreaLightAndTheFineTeapotWithNormalsOutwards) {
    const Scene scene = loaded("room").scene;
    EXPECT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(count_of<RectLight>(scene.lights), 1);
    ASSERT_EQ(count_of<Mesh>(scene.geometries), 1);
    for (const Geometry& geometry : scene.geometries) {
        const Mesh* mesh = std::get_if<Mesh>(&geometry);
        if (mesh == nullptr) continue;
        EXPECT_EQ(mesh->triangles.size(), 6320u);
        EXPECT_FALSE(mesh->uvs.empty());
        for (std::uint32_t t = 0; t < mesh->triangles.size(); ++t) {
            const Vec3 a = mesh->corner(t, 0);
            const Vec3 face = glm::cross(mesh->corner(t, 1) - a, mesh->corner(t, 2) - a);
            for (const auto n : mesh->triangles[t].normal) {
                EXPECT_GT(glm::dot(face, mesh->normals.at(n)), 0) << "triangle " << t;
            }
        }
    }
}

TEST(Spheres, AreSixtyOverAFloorUnderOneLampWithoutMirrors) {
    const Scene scene = loaded("spheres").scene;
    EXPECT_EQ(scene.nodes.size(), 61u);
    EXPECT_EQ(count_of<Sphere>(scene.geometries), 60);
    EXPECT_EQ(count_of<PointLight>(scene.lights), 1);
    EXPECT_EQ(count_of<Reflection>(scene.materials), 0);
    EXPECT_FALSE(scene.environment.has_value());
    EXPECT_NE(scene.settings.background, Rgb(0));
}

TEST(Mirrors, FaceEachOtherAndEndAtADepth) {
    const Scene scene = loaded("mirrors").scene;
    EXPECT_EQ(scene.settings.max_depth, 8);
    EXPECT_EQ(count_of<PointLight>(scene.lights), 2);
    EXPECT_EQ(count_of<Layered>(scene.materials), 3);
    EXPECT_TRUE(scene.environment.has_value());
    // A ray straight across the hall, between the pillars and above all that stands there, meets
    // the one mirror, and back the other.
    const Hit left = closest_brute(scene, {{0, 120, 80}, {-1, 0, 0}});
    const Hit right = closest_brute(scene, {{0, 120, 80}, {1, 0, 0}});
    ASSERT_TRUE(left && right);
    EXPECT_EQ(scene.nodes[left.node].name, "leftMirror");
    EXPECT_EQ(scene.nodes[right.node].name, "rightMirror");
}

TEST(Glass, StandsAsBlocksOfOneKindEachTwiceAsThickAsTheOneBefore) {
    const Scene scene = loaded("glass").scene;
    double thickness = 0.5;
    for (int i = 1; i <= 5; ++i, thickness *= 2) {
        const auto node = std::find_if(scene.nodes.begin(), scene.nodes.end(), [&](const Node& n) {
            return n.name == "block" + std::to_string(i);
        });
        ASSERT_NE(node, scene.nodes.end()) << i;
        EXPECT_DOUBLE_EQ(node->to_world.matrix[2][2], thickness);
        EXPECT_EQ(node->material, scene.nodes.back().material);
    }
}

/// Rays through a closed surface enter as often as they leave.
TEST(Glass, HasVesselsAndDrinksWithoutHoles) {
    const Scene scene = loaded("glass").scene;
    for (const char* name : {"tumbler", "drink", "wineGlass", "wine"}) {
        const auto node = std::find_if(scene.nodes.begin(), scene.nodes.end(),
                                       [&](const Node& n) { return n.name == name; });
        ASSERT_NE(node, scene.nodes.end());
        const auto& mesh = std::get<Mesh>(scene.geometries[node->geometry]);
        Scene alone;
        alone.geometries.emplace_back(mesh);
        alone.materials.emplace_back(Const{});
        add_node(alone, name, 0, 0, {});
        const auto accelerator = build_accelerator(alone);
        WorkCounts work;
        for (int k = 0; k < 500; ++k) {
            const Vec2d p = Key(k).square(0);
            Ray ray{{8 * p.x - 4, 30, 8 * p.y - 4}, direction(Key(k).branch(1))};
            ray.direction = glm::normalize(Vec3d(0.1 * ray.direction.x, -1, ray.direction.z * 0.1));
            int inside = 0;
            for (Hit hit; (hit = accelerator->closest(ray, work)); ray.t_min = hit.t) {
                const Vec3d normal = glm::cross(
                    Vec3d(mesh.corner(hit.primitive, 1) - mesh.corner(hit.primitive, 0)),
                    Vec3d(mesh.corner(hit.primitive, 2) - mesh.corner(hit.primitive, 0)));
                inside += glm::dot(normal, ray.direction) < 0 ? 1 : -1;
                EXPECT_GE(inside, 0) << name << ", ray " << k;
            }
            EXPECT_EQ(inside, 0) << name << ", ray " << k;
        }
    }
}

TEST(Clay, HasNoLightButTheSkyAndNothingToLookUp) {
    const Scene scene = loaded("clay").scene;
    EXPECT_TRUE(scene.lights.empty());
    EXPECT_TRUE(scene.textures.empty());
    ASSERT_TRUE(scene.environment);
    EXPECT_EQ(std::get<ConstantEnvironment>(*scene.environment).color,
              scene.settings.ambient_light);
    EXPECT_EQ(count_of<Lambert>(scene.materials), static_cast<long>(scene.materials.size()));
}

TEST(Cornell, IsABoxWithOneOpenSideAndAsksForGlobalIllumination) {
    const Scene scene = loaded("cornell").scene;
    EXPECT_TRUE(scene.settings.global_illumination);
    EXPECT_EQ(count_of<RectLight>(scene.lights), 1);
    EXPECT_EQ(scene.lights.size(), 1u);
    const Vec3d middle{278, 440, 280};
    const auto wall = [&](const Vec3d& direction) {
        const Hit hit = closest_brute(scene, {middle, direction});
        return hit ? scene.nodes[hit.node].name : "nothing";
    };
    EXPECT_EQ(wall({-1, 0, 0}), "redWall");
    EXPECT_EQ(wall({1, 0, 0}), "greenWall");
    EXPECT_EQ(wall({0, 0, 1}), "whiteWalls");
    EXPECT_EQ(wall({0, 1, 0}), "lamp");
    EXPECT_EQ(wall({0, 0, -1}), "nothing");
    EXPECT_EQ(wall(Vec3d(0.35, -1, -0.35)), "shortBlock");
}

}  // namespace
}  // namespace luch
