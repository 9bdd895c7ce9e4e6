// Probes: light that comes in at points of a scene, against closed forms and against paths.
#include "techniques/sh_ambient/probes.h"

#include "framework/scene/loader/loader.h"
#include "framework/trace/path.h"
#include "techniques/sh_ambient/incoming.h"
#include "techniques/sh_ambient/ringing.h"
#include "tests/testing/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace luch::techniques::sh_ambient {
namespace {

constexpr double pi = std::numbers::pi;
const Steps steps = reference();

/// A scene with threads, and grids of probes in it.
struct Lit {
    explicit Lit(Scene of, int threads = 2) : studio(std::move(of), threads) {}

    [[nodiscard]] ProbeGrid grid(const Params& params) {
        ProbeGrid made = grid_around(studio.scene(), Vec3d(0), params.probes);
        EXPECT_TRUE(fill(made, studio.scene(), params, Needs(), Key(1), steps, context));
        return made;
    }
    /// What a ray meets.
    [[nodiscard]] std::optional<Surface> seen(const Ray& ray) {
        const Hit hit = context.tracer(0).closest(RayKind::primary, ray);
        if (!hit) return std::nullopt;
        return surface_at(studio.scene(), ray, hit);
    }
    [[nodiscard]] bool is_lamp(const Surface& at) const {
        const Scene& scene = studio.scene();
        return std::holds_alternative<Emission>(scene.materials[scene.nodes[at.node].material]);
    }
    [[nodiscard]] Rgb traced(const Surface& at, int samples, int bounces) {
        return Incoming(studio.scene(), Needs(), context.tracer(0), bounces)
            .mean_at(at, samples, key_of(Key(9), at.position));
    }

    testing::OwnStudio studio;
    Context context{studio.studio().accelerator, studio.studio().workers, Plan{}, Budget{}};
};

Rgb from_probes(const ProbeGrid& grid, const Surface& at, Leaks leaks) {
    const Receiver receiver{at.position, at.geometric_normal};
    Blend blend;
    steps.blend(grid, {&receiver, 1}, leaks, {&blend, 1});
    Sh9 light;
    steps.trilinear(grid, {&blend, 1}, {&light, 1});
    const Vec3 normal(at.normal);
    Rgb e;
    steps.irradiance(light, {&normal, 1}, {&e, 1});
    return e / static_cast<float>(pi);
}

Material grey(float albedo) {
    return Lambert{.color = Rgb(albedo)};
}

/// A box seen from inside.
void add_box(Scene& scene, const Vec3d& size, const Vec3d& middle, const Material& material) {
    scene.geometries.emplace_back(Cube{});
    scene.materials.push_back(material);
    add_node(scene, "", static_cast<GeometryId>(scene.geometries.size() - 1),
             static_cast<MaterialId>(scene.materials.size() - 1),
             Transform::scaling(size).then(Transform::translation(middle)));
}

Scene dark_scene() {
    Scene scene = testing::empty_scene();
    scene.lights.clear();
    scene.settings.ambient_light = Rgb(0);
    return scene;
}

/// Two rooms, 2 × 2 × 2 each, and a thin wall at x = 0 between them. A lamp is in the left one.
Scene two_rooms() {
    Scene scene = dark_scene();
    add_box(scene, {4, 2, 2}, Vec3d(0), grey(0.5f));
    add_box(scene, {0.02, 2, 2}, Vec3d(0), grey(0.5f));
    scene.lights.emplace_back(PointLight{.position = {-1, 0.3, 0.2}, .power = 1});
    return scene;
}

/// A box's inside in which everything glows alike.
Scene furnace(const Rgb& colour) {
    Scene scene = dark_scene();
    add_box(scene, {3, 2, 1}, {5, 0, 0}, Const{colour});
    return scene;
}

TEST(DistanceMap, LooksUpTheDirectionsOfItsTexels) {
    DistanceMap map;
    for (int y = 0; y < DistanceMap::side; ++y) {
        for (int x = 0; x < DistanceMap::side; ++x) {
            const Vec3d d = DistanceMap::direction(x, y);
            EXPECT_NEAR(glm::length(d), 1, 1e-12);
            map.texels[static_cast<std::size_t>(y * DistanceMap::side + x)] = {
                static_cast<float>(d.x + 2 * d.y + 3 * d.z), 1};
            EXPECT_NEAR(map.towards(d).mean, d.x + 2 * d.y + 3 * d.z, 1e-6);
        }
    }
    // Between texels, and over the edges of the square, it is smooth.
    for (std::uint64_t i = 0; i < 500; ++i) {
        const Vec3d d =
            glm::normalize(Vec3d(Key(i).uniform(0), Key(i).uniform(1), Key(i).uniform(2)) - 0.5);
        EXPECT_NEAR(map.towards(d).mean, d.x + 2 * d.y + 3 * d.z, 0.3) << i;
        EXPECT_NEAR(map.towards(d).mean_square, 1, 1e-6);
    }
}

TEST(Probe, SeesTheSameLightFromAllAroundInAFurnace) {
    Lit lit(furnace({0.5f, 1, 2}));
    const ProbeGrid grid = lit.grid({.probes = 3, .rays = 64, .leaks = 0});
    EXPECT_EQ(grid.count, glm::ivec3(3, 2, 1));
    for (const Sh9& light : grid.light) {
        EXPECT_NEAR(light.l[0].y, std::sqrt(4 * pi), 1e-5);
        for (std::size_t k = 1; k < sh_terms; ++k) EXPECT_NEAR(light.l[k].y, 0, 0.25) << k;
    }
}

TEST(Probe, SpreadsItsRaysBySolidAngleUpToThePoles) {
    // Heights chosen evenly in the angle would give 3z² − 1 the mean ½.
    Lit lit(furnace(Rgb(1)));
    const Sh9 light = lit.grid({.probes = 1, .rays = 4096, .leaks = 0}).light[0];
    for (std::size_t k = 1; k < sh_terms; ++k) EXPECT_NEAR(light.l[k].x, 0, 0.005) << k;
}

TEST(Probe, AgreesWithTheProjectionOfASkyThatNothingHides) {
    CubemapEnvironment sky;
    for (std::size_t i = 0; i < 6; ++i) {
        sky.sides[i] = Image<Rgb>({4, 4}, Rgb(0.2f * static_cast<float>(i + 1)));
    }
    Scene scene = dark_scene();
    scene.environment = sky;
    Lit lit(scene);
    Sh9 light, truth;
    const Incoming incoming(lit.studio.scene(), Needs(), lit.context.tracer(0), 2);
    const Vec3d place(0);
    steps.probe(incoming, {&place, 1}, {0, 4096, 4096}, Key(1), {&light, 1});
    steps.project(sky, truth);
    for (std::size_t k = 0; k < sh_terms; ++k) EXPECT_NEAR(light.l[k].x, truth.l[k].x, 0.01) << k;
}

TEST(Probe, AddsUpRangesOfSamplesAndKnowsPlacesOneByOneOrTogether) {
    Lit lit(two_rooms());
    const Incoming incoming(lit.studio.scene(), Needs(), lit.context.tracer(0), 2);
    const std::array places{Vec3d(-1.3, 0, 0), Vec3d(-0.5, 0.2, 0.1)};
    std::array<Sh9, 2> whole{}, single{}, ranges{};
    steps.probe(incoming, places, {0, 64, 64}, Key(1), whole);
    for (std::size_t i = 0; i < 2; ++i) {
        steps.probe(incoming, {&places[i], 1}, {0, 64, 64}, Key(1), {&single[i], 1});
    }
    EXPECT_EQ(single, whole);
    steps.probe(incoming, places, {0, 24, 64}, Key(1), ranges);
    steps.probe(incoming, places, {24, 64, 64}, Key(1), ranges);
    for (std::size_t k = 0; k < sh_terms; ++k) {
        EXPECT_NEAR(ranges[0].l[k].x, whole[0].l[k].x, 1e-6);
    }
    EXPECT_GT(whole[0].l[0].x, 0.1f);
}

TEST(Probe, CountsLightThatIsNotFiniteForNothing) {
    Scene scene = furnace(Rgb(1));
    add_box(scene, Vec3d(0.1), {4, 0, 0}, Const{Rgb(std::nanf(""), 1, 1)});
    Lit lit(scene);
    const Sh9 light = lit.grid({.probes = 1, .rays = 256, .leaks = 0}).light[0];
    EXPECT_TRUE(all_finite(light.l[0]));
    EXPECT_LT(light.l[0].x, std::sqrt(4 * pi) - 0.001);
}

TEST(Probe, SeesNoLampForItsLightIsDirect) {
    Scene scene = dark_scene();
    testing::add_shape(scene, Plane{.y = -1, .limit = 2});
    add_rect_light(scene, "lamp", RectLight{.to_world = Transform::translation({0, 1, 0})});
    Lit lit(scene);
    const Surface floor = *lit.seen({{0.1, 0, 0}, {0.2, -1, 0}});
    EXPECT_EQ(lit.traced(floor, 256, 3), Rgb(0)) << "a lone flat floor is lit by the lamp only";
    const Incoming incoming(lit.studio.scene(), Needs(), lit.context.tracer(0), 1);
    const Vec3d place(0);
    Sh9 light;
    steps.probe(incoming, {&place, 1}, {0, 256, 256}, Key(1), {&light, 1});
    EXPECT_LT(light.l[1].x, -0.01f) << "light comes from below, off the floor";
}

TEST(Probe, FollowsLightOverAsManySurfacesAsItIsTold) {
    // In a closed room every path meets one more surface at each step.
    Lit lit(two_rooms());
    const Surface floor = *lit.seen({{-1, 0, 0}, {0.1, -1, 0}});
    double before = 0;
    for (int bounces = 0; bounces < 4; ++bounces) {
        static_cast<void>(lit.context.take_counts());
        const double light = lit.traced(floor, 256, bounces).x;
        const std::uint64_t rays = lit.context.take_counts().of(RayKind::gi);
        EXPECT_EQ(rays, 256u * static_cast<std::uint64_t>(bounces + 1));
        EXPECT_TRUE(bounces == 0 ? light == 0 : light > before) << bounces;
        before = light;
    }
}

TEST(Probe, RingsOnlyWhereRingingIsOff) {
    Scene scene = furnace(Rgb(0));
    add_box(scene, Vec3d(0.1), {5.5, 0.5, 0}, Const{Rgb(100)});
    Lit lit(scene);
    for (const Ringing ringing : {Ringing::off, Ringing::least, Ringing::scaled}) {
        const ProbeGrid grid =
            lit.grid({.ringing = static_cast<int>(ringing), .probes = 3, .rays = 1024, .leaks = 0});
        double least = 0;
        for (const Sh9& light : grid.light) least = std::min(least, least_irradiance(light));
        EXPECT_EQ(least < -1e-4, ringing == Ringing::off) << least;
    }
}

TEST(Distances, AreThoseToTheWalls) {
    Lit lit(furnace(Rgb(1)));  // 3 × 2 × 1 around (5, 0, 0)
    const Incoming incoming(lit.studio.scene(), Needs(), lit.context.tracer(0), 0);
    const Vec3d place(5, 0, 0);
    DistanceMap map;
    steps.distances(incoming, {&place, 1}, 4096, 100, Key(1), {&map, 1});
    EXPECT_NEAR(map.towards({1, 0, 0}).mean, 1.5, 0.04);
    EXPECT_NEAR(map.towards({0, -1, 0}).mean, 1, 0.03);
    EXPECT_NEAR(map.towards({0, 0, 1}).mean, 0.5, 0.02);
    EXPECT_NEAR(map.towards({0, 0, 1}).mean_square, 0.25, 0.02);
    steps.distances(incoming, {&place, 1}, 1024, 0.7, Key(1), {&map, 1});
    EXPECT_FLOAT_EQ(map.towards({1, 0, 0}).mean, 0.7f) << "no farther than is asked for";
}

/// A grid of 4 × 3 × 2 unit cells whose light is linear in the place.
ProbeGrid linear_grid() {
    ProbeGrid grid{.box = {{0, 0, 0}, {4, 3, 2}}, .count = {4, 3, 2}, .light = {}, .distances = {}};
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const Vec3d p = grid.place(i);
        Sh9 light;
        for (std::size_t k = 0; k < sh_terms; ++k) {
            light.l[k] = Rgb(static_cast<float>(p.x + 2 * p.y - p.z + static_cast<double>(k)));
        }
        grid.light.push_back(light);
    }
    return grid;
}

TEST(Blend, IsTrilinearBetweenProbesAndStaysAtTheOutermost) {
    const ProbeGrid grid = linear_grid();
    const auto at = [&](const Vec3d& p) {
        const Receiver receiver{p, {0, 1, 0}};
        Blend blend;
        steps.blend(grid, {&receiver, 1}, Leaks::shown, {&blend, 1});
        Sh9 light;
        steps.trilinear(grid, {&blend, 1}, {&light, 1});
        return light;
    };
    for (std::size_t i = 0; i < grid.size(); ++i) {
        EXPECT_EQ(at(grid.place(i)), grid.light[i]) << i;
    }
    EXPECT_NEAR(at({1.2, 1.7, 0.9}).l[4].x, 1.2 + 3.4 - 0.9 + 4, 1e-5);
    // The outermost probes stand a quarter of a cell within the box.
    EXPECT_NEAR(at({-9, 1.7, 30}).l[0].x, 0.25 + 3.4 - 1.75, 1e-5);
}

TEST(Blend, WeighsEightProbesByASumOfOneAndTrustsThoseInFront) {
    const ProbeGrid grid = linear_grid();
    for (std::uint64_t i = 0; i < 200; ++i) {
        const Vec3d p = Vec3d(Key(i).uniform(0), Key(i).uniform(1), Key(i).uniform(2)) * 5.0 - 0.5;
        const Receiver receiver{p, {0, 1, 0}};
        for (const Leaks leaks : {Leaks::shown, Leaks::normals}) {
            Blend blend;
            steps.blend(grid, {&receiver, 1}, leaks, {&blend, 1});
            double sum = 0, above = 0;
            for (std::size_t k = 0; k < 8; ++k) {
                EXPECT_GE(blend.weight[k], 0);
                sum += blend.weight[k];
                if (grid.place(blend.probe[k]).y > p.y) above += blend.weight[k];
            }
            EXPECT_NEAR(sum, 1, 1e-6);
            if (leaks == Leaks::normals && p.y > 1.6 && p.y < 2) {
                EXPECT_GT(above, p.y - 1.5) << "more than its share";
            }
        }
    }
}

TEST(Blend, GivesTheSameBitsForAnyDivision) {
    Lit lit(two_rooms());
    const ProbeGrid grid = lit.grid({.probes = 6, .rays = 32, .bounces = 1});
    std::vector<Receiver> points;
    for (std::uint64_t i = 0; i < 64; ++i) {
        points.push_back(
            {Vec3d(Key(i).uniform(0), Key(i).uniform(1), Key(i).uniform(2)) * 2.0 - 1.0,
             {1, 0, 0}});
    }
    std::vector<Blend> whole(64), parts(64);
    steps.blend(grid, points, Leaks::distances, whole);
    std::vector<Sh9> light(64), light_of_parts(64);
    steps.trilinear(grid, whole, light);
    for (const std::size_t size : {1u, 16u}) {
        for (std::size_t i = 0; i < 64; i += size) {
            steps.blend(grid, std::span(points).subspan(i, size), Leaks::distances,
                        std::span(parts).subspan(i, size));
            steps.trilinear(grid, std::span(parts).subspan(i, size),
                            std::span(light_of_parts).subspan(i, size));
        }
        EXPECT_EQ(light_of_parts, light) << size;
    }
}

TEST(Grid, LiesAroundAllThatHasAnEndAndIsNoThinnerThanACell) {
    Scene scene = dark_scene();
    scene.geometries.emplace_back(Plane{.y = -1});
    scene.geometries.emplace_back(Plane{.y = 2, .limit = 4});
    scene.materials.push_back(grey(1));
    add_node(scene, "", 0, 0, {});
    EXPECT_EQ(grid_around(scene, {7, 0, 0}, 4).box.centre(), Vec3d(7, 0, 0));
    add_node(scene, "", 1, 0, {});
    const ProbeGrid flat = grid_around(scene, Vec3d(0), 4);
    EXPECT_EQ(flat.count, glm::ivec3(4, 1, 4));
    EXPECT_EQ(flat.box.size(), Vec3d(8, 2, 8));
    EXPECT_EQ(flat.place(0), Vec3d(-3.5, 2, -3.5));
    EXPECT_EQ(flat.place(15), Vec3d(3.5, 2, 3.5));
    EXPECT_NEAR(flat.place(1).x, -3.5 + 7.0 / 3, 1e-12) << "x runs first";
}

TEST(Grid, IsTheSameOnAnyNumberOfThreads) {
    Lit one(two_rooms(), 1), many(two_rooms(), 5);
    const Params params{.probes = 5, .rays = 32, .bounces = 2};
    const ProbeGrid a = one.grid(params), b = many.grid(params);
    EXPECT_EQ(a.light, b.light);
    EXPECT_EQ(a.distances, b.distances);
    EXPECT_EQ(a.bytes(), a.size() * (sizeof(Sh9) + 2048));
}

/// Points of the two rooms' surfaces on one side, seen from its middle.
std::vector<Surface> points_of_room(Lit& lit, double side) {
    std::vector<Surface> points;
    for (std::uint64_t i = 0; i < 300; ++i) {
        const Vec3d way = Vec3d(Key(i).uniform(0), Key(i).uniform(1), Key(i).uniform(2)) - 0.5;
        points.push_back(*lit.seen({{side, 0, 0}, glm::normalize(way)}));
    }
    return points;
}

double mean_of(const ProbeGrid& grid, const std::vector<Surface>& points, Leaks leaks) {
    double sum = 0;
    for (const Surface& each : points) sum += from_probes(grid, each, leaks).x;
    return sum / static_cast<double>(points.size());
}

TEST(Leaks, ShowThroughAThinWallAndAreMended) {
    Lit lit(two_rooms());
    const auto bright = points_of_room(lit, -1), dark = points_of_room(lit, 1);
    for (const Surface& each : dark) ASSERT_EQ(lit.traced(each, 8, 3), Rgb(0)) << "no light here";
    const ProbeGrid grid = lit.grid({.probes = 8, .rays = 128});
    const double within = mean_of(grid, bright, Leaks::shown);
    const double shown = mean_of(grid, dark, Leaks::shown) / within;
    const double normals = mean_of(grid, dark, Leaks::normals) / within;
    const double distances = mean_of(grid, dark, Leaks::distances) / within;
    EXPECT_GT(shown, 0.05);
    EXPECT_LT(normals, shown);
    EXPECT_LT(distances, 0.05 * shown);
}

TEST(Grid, ComesCloserToPathsTheMoreProbesItHas) {
    Scene scene = load_scene(LUCH_SOURCE_DIR "/scenes/cornell/cornell.scene").scene;
    auto& lamp = std::get<RectLight>(scene.lights[0]);
    lamp.x_samples = lamp.y_samples = 1;
    const Screen screen(scene.camera, {400, 400});
    Lit lit(std::move(scene));
    std::vector<Surface> points;
    std::vector<Rgb> truth;
    double whole = 0;
    for (std::uint64_t i = 0; points.size() < 60; ++i) {
        const Vec2d at = Key(7).square(i) * 400.0;
        const auto seen = lit.seen(screen.ray(at.x, at.y));
        if (!seen || lit.is_lamp(*seen)) continue;
        points.push_back(*seen);
        truth.push_back(lit.traced(*seen, 512, 2));
        whole += truth.back().x + truth.back().y + truth.back().z;
    }
    double before = 1;
    for (const auto& [probes, most] : {std::pair(2, 0.35), {4, 0.16}, {8, 0.1}}) {
        const ProbeGrid grid = lit.grid({.probes = probes, .rays = 256, .bounces = 2});
        double sum = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Rgb off = glm::abs(from_probes(grid, points[i], Leaks::distances) - truth[i]);
            sum += off.x + off.y + off.z;
        }
        EXPECT_LT(sum / whole, most) << probes;
        EXPECT_LT(sum / whole, 0.8 * before) << probes;
        before = sum / whole;
    }
}

}  // namespace
}  // namespace luch::techniques::sh_ambient
