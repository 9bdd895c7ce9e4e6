// The exact mode: bit for bit what shadow rays say, with few of them.
#include "framework/technique/catalogue.h"
#include "framework/trace/known_light.h"
#include "techniques/shadow_map/items.h"
#include "tests/testing/everything.h"
#include "tests/testing/meshes.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

#include <numbers>

namespace luch::baseline {
TechniqueInfo describe();
}

namespace luch::techniques::shadow_map {
namespace {

using testing::different_pixels;
using testing::OwnStudio;

Outcome exact(const OwnStudio& studio, const char* side = "side=256") {
    const auto technique = make(reference(), Mode::exact);
    set_param(*technique, side);
    return studio.render(*technique);
}

/// Rays that are left, of those that the baseline shoots; −1 where the picture is not the same.
double rays_left(const OwnStudio& studio, const char* side = "side=256") {
    const Outcome mine = exact(studio, side);
    const Outcome truth = studio.render(*baseline::describe().create());
    if (different_pixels(mine, truth) > 0) return -1;
    return static_cast<double>(mine.counts.of(RayKind::shadow)) /
           static_cast<double>(truth.counts.of(RayKind::shadow));
}

/// A floor with wires over it, far thinner than a texel: bars, and slivers of a mesh.
Scene wires() {
    Scene scene = testing::empty_scene();
    scene.camera.position = {0, 3, -5};
    scene.camera.pitch_deg = -25;
    scene.lights[0] = PointLight{.position = {1, 8, -2}, .power = 90};
    scene.lights.emplace_back(SpotLight{.position = {-6, 5, 1},
                                        .direction = glm::normalize(Vec3d(6, -5, 3)),
                                        .inner_cosine = 0.9,
                                        .outer_cosine = 0.7,
                                        .power = 60});
    testing::add_shape(scene, Plane{.limit = 30});
    for (int i = 0; i < 12; ++i) {
        const Transform bar = Transform::scaling({0.004, 2, 0.004})
                                  .then(Transform::rotation(0.3 * i, 0.2, 0.1 * i))
                                  .then(Transform::translation({-3 + 0.5 * i, 1.2, 2}));
        testing::add_shape(scene, Cube{.side = 1}, bar);
    }
    std::vector<Vec3d> positions;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < 40; ++i) {
        const double angle = 0.37 * i;
        const Vec3d foot{std::cos(angle) * 2, 0.3, 4 + std::sin(angle) * 2};
        for (const Vec3d& corner :
             {foot, foot + Vec3d(0.003, 0, 0.002), foot + Vec3d(0.2, 2.5, -0.1)}) {
            indices.push_back(static_cast<std::uint32_t>(positions.size()));
            positions.push_back(corner);
        }
    }
    testing::add_shape(scene, testing::mesh_of(positions, indices));
    return scene;
}

TEST(ExactShadows, AreThoseOfRaysWithWiresThinnerThanATexel) {
    const OwnStudio studio(wires());
    for (const char* side : {"side=16", "side=64", "side=256"}) {
        const double left = rays_left(studio, side);
        std::printf("wires %s: %.2f %% of the rays\n", side, 100 * left);
        EXPECT_GE(left, 0) << side << ": another picture";
        EXPECT_LE(left, 0.1) << side;
    }
}

TEST(ExactShadows, AreThoseOfRaysAmongSixtySpheres) {
    const OwnStudio studio(testing::sixty_spheres());
    const double left = rays_left(studio);
    std::printf("sixty spheres: %.2f %% of the rays\n", 100 * left);
    EXPECT_GE(left, 0) << "another picture";
    EXPECT_LE(left, 0.1);
}

TEST(ExactShadows, AreThoseOfRaysWhateverTheScene) {
    const OwnStudio everything(testing::bit_of_everything()), each(testing::one_of_each());
    EXPECT_GE(rays_left(everything), 0);
    EXPECT_GE(rays_left(each), 0);
}

TEST(ExactShadows, AreThoseOfRaysFarFromTheOriginAndAtAllScales) {
    for (const double scale : {1e-6, 1.0, 1e6}) {
        for (const double away : {0.0, 1e4}) {
            Scene scene = wires();
            const Transform moved = Transform::translation(Vec3d(away, -away, 2 * away))
                                        .then(Transform::scaling(Vec3d(scale)));
            for (Node& node : scene.nodes) {
                node.to_world = node.to_world.then(moved);
                node.to_object = node.to_world.inverse();
            }
            scene.camera.position = moved.point(scene.camera.position);
            std::get<PointLight>(scene.lights[0]).position = moved.point({1, 8, -2});
            std::get<SpotLight>(scene.lights[1]).position = moved.point({-6, 5, 1});
            const OwnStudio studio(std::move(scene));
            EXPECT_GE(rays_left(studio), 0) << scale << " " << away;
        }
    }
}

TEST(ExactShadows, HoldWithTheLightOnASurfaceInABoxAndAtACorner) {
    for (const Vec3d& light : {Vec3d(0, 0, 4), Vec3d(1, 1, 3), Vec3d(0.5, 0, 5), Vec3d(0, 1, 4),
                               Vec3d(0, 0.9999999, 4), Vec3d(-3, -0.99, 6)}) {
        Scene scene = testing::empty_scene();
        scene.lights[0] = PointLight{.position = light, .power = 9};
        testing::add_shape(scene, Cube{.centre = {0, 0, 4}, .side = 2});
        testing::add_shape(scene, Plane{.y = -1});
        testing::add_shape(scene, testing::uv_sphere(8, 12, 2), Transform::translation({-3, 0, 6}));
        testing::add_shape(scene, Cube{.centre = {0, 0, 0}, .side = 30});
        const OwnStudio studio(std::move(scene));
        EXPECT_GE(rays_left(studio), 0) << light.x << " " << light.y << " " << light.z;
    }
}

/// Items of all faces.
Items items_around(const Scene& scene, const Vec3d& light, int n) {
    const Content content(scene);
    Items items{n, {}};
    for (int face = 0; face < faces_of_cube; ++face) {
        items.faces[static_cast<std::size_t>(face)] =
            items_of(scene, content, light, face, n, {0, 0, n, n});
    }
    return items;
}

/// Rays from a light through the corners and edges of triangles, and by them, to points behind.
std::vector<Ray> awkward_rays(const Scene& scene, const Vec3d& light, Key key) {
    std::vector<Ray> rays;
    const Node& node = scene.nodes[0];
    const Mesh& mesh = std::get<Mesh>(scene.geometries[node.geometry]);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const Vec3d a(mesh.corner(i, 0)), b(mesh.corner(i, 1)), c(mesh.corner(i, 2));
        const double u = key.branch(i).uniform(0);
        for (const Vec3d& at :
             {a, a + u * (b - a), c + u * (a - c), a + u * 1e-7 * (b - c), (a + b + c) / 3.0}) {
            for (const double length : {0.999999, 1.0, 1.0000001, 1.5, 40.0}) {
                rays.push_back({light, length * (node.to_world.point(at) - light), 0, 1});
            }
        }
    }
    return rays;
}

TEST(ExactShadows, AnswerRaysThroughCornersAndEdgesAsTheTracerDoes) {
    std::uint64_t known = 0, blocked = 0, wrong = 0;
    for (std::uint64_t trial = 0; trial < 12; ++trial) {
        const Key key(trial);
        Scene scene = testing::empty_scene();
        const double scale = std::pow(10.0, 6 * key.uniform(1) - 3);
        testing::add_shape(
            scene, testing::uv_sphere(16, 24, 1),
            Transform::scaling(scale * Vec3d(1, 0.2 + key.uniform(2), 3))
                .then(Transform::rotation(key.uniform(3), key.uniform(4), 0))
                .then(Transform::translation(scale * (20.0 * Vec3d(key.uniform(5), 1, 2) - 10.0))));
        const Vec3d light = scene.nodes[0].to_world.point(
            3.0 * Vec3d(key.uniform(6) - 0.5, key.uniform(7) - 0.5, key.uniform(8) - 0.5));
        const auto accelerator = build_accelerator(scene);
        Tracer tracer(*accelerator);
        const Items items = items_around(scene, light, 64);
        for (const Ray& ray : awkward_rays(scene, light, key)) {
            const float share = share_by_items(items, scene, ray, tracer.counts());
            if (share == ShadowSource::unknown) continue;
            ++known;
            const bool truth = tracer.occluded(RayKind::shadow, ray);
            blocked += truth ? 1 : 0;
            wrong += truth == (share == 0) ? 0 : 1;
        }
    }
    EXPECT_EQ(wrong, 0u);
    EXPECT_GT(known, 100000u);
    EXPECT_GT(blocked, 20000u);
}

TEST(ExactShadows, FindATriangleThatRoundingMovesAcrossATexelsBorder) {
    // A mesh's rays start at a float. This light is nearly half a step before one, and the edge of
    // the triangle leans over the step, so a ray left of the border through x = light.x meets what
    // is right of it.
    const float step = std::nextafter(0.3f, 0.0f);
    const Vec3d light{0.3f - 0.48 * (0.3f - double(step)), 0, 0};
    Scene scene = testing::empty_scene();
    Mesh mesh;
    mesh.positions = {{step, -1, 2}, {0.3f, 1, 2}, {1, 0, 2}};
    mesh.triangles = {{{0, 1, 2}, {}, {}}};
    testing::add_shape(scene, mesh);
    const auto accelerator = build_accelerator(scene);
    Tracer tracer(*accelerator);
    const Items items = items_around(scene, light, 64);
    int moved = 0;
    for (int i = 0; i < 4000; ++i) {
        const Ray ray{light, {-1e-13, (i + 0.5) / 2000 - 1, 3}, 0, 1};
        const bool truth = tracer.occluded(RayKind::shadow, ray);
        EXPECT_EQ(share_by_items(items, scene, ray, tracer.counts()) == 0, truth) << i;
        moved += truth ? 1 : 0;
    }
    EXPECT_GT(moved, 100);
}

TEST(ExactShadows, FindATriangleThatIsHardlyOffTheLight) {
    Scene scene = testing::empty_scene();
    testing::add_shape(scene, testing::mesh_of({{-1, 0, -1}, {1, 0, -1}, {0, 0, 2}}, {0, 1, 2}));
    const auto accelerator = build_accelerator(scene);
    Tracer tracer(*accelerator);
    for (const double height : {1e-12, 1e-9, 1e-7, 1e-5, 1e-3}) {
        const Vec3d light{0.1, height, 0.2};
        const Items items = items_around(scene, light, 32);
        int blocked = 0;
        for (std::uint64_t i = 0; i < 2000; ++i) {
            const Vec3d to = testing::random_point(Key(i), 3);
            const Ray ray{light, to - light, 0, 1};
            const float share = share_by_items(items, scene, ray, tracer.counts());
            const bool truth = tracer.occluded(RayKind::shadow, ray);
            EXPECT_EQ(share == 0, truth) << height;
            blocked += truth ? 1 : 0;
        }
        EXPECT_GT(blocked, 500) << height;
    }
}

TEST(ExactShadows, KnowThatABoxShadesItsOwnInside) {
    Scene scene = testing::empty_scene();  // the camera is in the box, the light is not
    testing::add_shape(scene, Cube{.side = 8});
    testing::add_shape(scene, Sphere{.centre = {1, -1, 3}, .radius = 0.5});
    const OwnStudio studio(std::move(scene));
    EXPECT_EQ(rays_left(studio), 0);
}

TEST(ExactShadows, HoldOnAHugeBallInGrazingLight) {
    for (const double height : {1e-4, 0.01, 1.0}) {
        Scene scene = testing::empty_scene();
        scene.camera.position = {0, 2, 0};
        scene.camera.pitch_deg = -20;
        scene.lights[0] = PointLight{.position = {0.3, height, 4}, .power = 9};
        testing::add_shape(scene, Sphere{.centre = {0, -1e6, 0}, .radius = 1e6});
        testing::add_shape(scene, Cube{.side = 0.5}, Transform::translation({1, 0.2, 6}));
        const OwnStudio studio(std::move(scene));
        EXPECT_EQ(rays_left(studio), 0) << height;
    }
}

TEST(ExactShadows, LeaveSolidsHeightfieldsAndDenseMeshesToRays) {
    Scene scene = testing::empty_scene();
    testing::add_shape(scene, testing::uv_sphere(60, 60, 1), Transform::translation({0, 0, 5}));
    testing::add_shape(scene, Plane{.y = -2});
    const OwnStudio studio(std::move(scene));
    EXPECT_GT(rays_left(studio, "side=8"), 0.1);
    const double fine = rays_left(studio, "side=512");
    EXPECT_GE(fine, 0);
    EXPECT_LT(fine, 0.1);
}

TEST(ExactShadows, TakeTheBaselinesRaysForLightsWithAnArea) {
    Scene scene = wires();
    scene.lights.clear();
    add_rect_light(scene, "", {.to_world = Transform::translation({0, 6, 2}), .power = 40});
    const OwnStudio studio(std::move(scene));
    EXPECT_EQ(rays_left(studio), 1);
}

}  // namespace
}  // namespace luch::techniques::shadow_map
