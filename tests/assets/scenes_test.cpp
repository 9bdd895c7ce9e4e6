#include "framework/accel/accelerator.h"
#include "framework/math/rng.h"
#include "framework/scene/loader/loader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace luch {
namespace {

const std::filesystem::path folder_of_scenes = std::filesystem::path(LUCH_SOURCE_DIR) / "scenes";

Loaded loaded(const std::string& name) {
    return load_scene(folder_of_scenes / name / (name + ".scene"));
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
    int scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_of_scenes)) {
        const std::string name = entry.path().filename().string();
        if (!std::filesystem::exists(entry.path() / (name + ".scene"))) continue;
        const Loaded scene = loaded(name);
        EXPECT_TRUE(scene.warnings.empty()) << name << ": " << scene.warnings.front();
        ++scenes;
    }
    EXPECT_GE(scenes, 12);
}

TEST(Page, LiesInThePlaneOfFocusWithThingsBeforeAndBehind) {
    const Loaded page = loaded("page");
    EXPECT_TRUE(page.warnings.empty());
    const Camera& camera = page.scene.camera;
    ASSERT_TRUE(camera.has_lens());
    const Screen screen(camera, page.scene.settings.frame);
    int before = 0, behind = 0;
    for (const Node& node : page.scene.nodes) {
        if (node.name == "desk") continue;
        const Boxd box = bounds_of(page.scene.geometries[node.geometry]);
        const double depth = screen.to_view(node.to_world.point(box.centre())).z;
        before += depth < camera.focal_distance - 10 ? 1 : 0;
        behind += depth > camera.focal_distance + 10 ? 1 : 0;
        if (node.name != "pages") continue;
        for (unsigned i = 0; i < 8; ++i) {
            const Vec3d corner{i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y,
                               i & 4 ? box.hi.z : box.lo.z};
            const double at = screen.to_view(node.to_world.point(corner)).z;
            EXPECT_NEAR(at, camera.focal_distance, 2) << "the page's corners are sharp";
        }
    }
    EXPECT_GE(before, 5);
    EXPECT_GE(behind, 15);
}

TEST(Fence, HasThingsFarBeforeInAndFarBehindThePlaneOfFocus) {
    const Loaded fence = loaded("fence");
    EXPECT_TRUE(fence.warnings.empty());
    const Camera& camera = fence.scene.camera;
    ASSERT_TRUE(camera.has_lens());
    const Screen screen(camera, fence.scene.settings.frame);
    int before = 0, in = 0, behind = 0;
    for (const Node& node : fence.scene.nodes) {
        const double depth = screen.to_view(node.to_world.point(Vec3d(0))).z;
        before += depth > 1 && depth < camera.focal_distance / 2 ? 1 : 0;
        in += std::abs(depth / camera.focal_distance - 1) < 0.1 ? 1 : 0;
        behind += depth > camera.focal_distance * 2 ? 1 : 0;
    }
    EXPECT_EQ(before, 4);
    EXPECT_EQ(in, 1);
    EXPECT_GE(behind, 6);
}

TEST(Fisheye, SeesTheWholeHallAndTheSkyOnlyThroughTheDome) {
    const Loaded hall = loaded("fisheye");
    EXPECT_TRUE(hall.warnings.empty());
    const Camera& camera = hall.scene.camera;
    EXPECT_EQ(camera.projection, Projection::fisheye);
    const auto accelerator = build_accelerator(hall.scene);
    WorkCounts work;
    const Size size{64, 64};
    const Screen screen(camera, size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const Ray ray = screen.ray(x + 0.5, y + 0.5);
            if (nowhere(ray)) continue;
            const bool sky = !accelerator->occluded(ray, work);
            // The opening is 1.62 wide, 16.4 − 1.65 above the eye.
            const double aside = std::hypot(ray.direction.x, ray.direction.z);
            const double edge = 1.62 / (16.4 - 1.65);
            const double slope = aside / std::abs(ray.direction.y);
            if (std::abs(slope / edge - 1) < 0.2) continue;
            EXPECT_EQ(sky, ray.direction.y > 0 && slope < edge) << x << " " << y;
        }
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

TEST(Island, RisesOutOfTheSeaAndItsEdgesSinkBelowTheGround) {
    const Scene scene = loaded("island").scene;
    ASSERT_EQ(count_of<Heightfield>(scene.geometries), 1);
    const auto down = [&](double x, double z) {
        Ray ray{{x, 400, z}, {0, -1, 0}};
        std::string met;
        while (const Hit hit = closest_brute(scene, ray)) {
            met += scene.nodes[hit.node].name + " ";
            ray.t_min = hit.t;
        }
        return met;
    };
    EXPECT_EQ(down(0.5, 20.5), "island sea ground ");
    EXPECT_EQ(down(-158.5, -158.5), "sea ground island ");
    EXPECT_EQ(down(900, 900), "sea ground ");
}

TEST(Dice, HaveSevenOnOppositeFacesAndPaintInEveryPip) {
    const Scene scene = loaded("die").scene;
    EXPECT_EQ(scene.nodes.size(), 1u + 2 * 3 + 1);  // the lamp's face too
    const auto solid = std::find_if(scene.nodes.begin(), scene.nodes.end(),
                                    [](const Node& node) { return node.name == "ivory_die"; });
    ASSERT_NE(solid, scene.nodes.end());
    const auto& csg = std::get<Csg>(scene.geometries[solid->geometry]);
    EXPECT_EQ(csg.parts.size(), 23u);
    int pips[3][2] = {};
    for (const Csg::Part& part : csg.parts) {
        const auto* ball = std::get_if<Sphere>(&scene.geometries[part.geometry]);
        if (ball == nullptr || !part.flipped) continue;
        for (int axis = 0; axis < 3; ++axis) {
            if (std::abs(ball->centre[axis]) > 1) ++pips[axis][ball->centre[axis] > 0];
        }
        const Vec3d above = solid->to_world.point(ball->centre * 1.4);
        const Vec3d into = solid->to_world.direction(-ball->centre);
        const Hit hit = closest_brute(scene, {above, into});
        ASSERT_TRUE(hit);
        // The pips on the die's ground face see the table first.
        const std::string& name = scene.nodes[hit.node].name;
        if (above.y > 0) {
            EXPECT_EQ(name, "ivory_die_pips");
        }
    }
    for (const auto& [one, other] : pips) EXPECT_EQ(one + other, 7);
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
