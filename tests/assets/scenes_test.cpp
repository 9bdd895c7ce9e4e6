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
    for (const char* name : {"room", "spheres", "mirrors"}) {
        const Loaded scene = loaded(name);
        EXPECT_TRUE(scene.warnings.empty()) << name << ": " << scene.warnings.front();
        EXPECT_EQ(scene.scene.settings.frame, (Size{640, 480})) << name;
        EXPECT_FALSE(scene.scene.camera.depth_of_field) << name;
    }
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

}  // namespace
}  // namespace luch
