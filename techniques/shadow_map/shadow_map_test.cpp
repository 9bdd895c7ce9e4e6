// The technique against closed forms and shadow rays.
#include "techniques/shadow_map/shadow_map.h"

#include "framework/technique/catalogue.h"
#include "techniques/shadow_map/atlas.h"
#include "techniques/shadow_map/source.h"
#include "tests/testing/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace luch::baseline {
TechniqueInfo describe();
}

namespace luch::techniques::shadow_map {
namespace {

using testing::different_pixels;
using testing::OwnStudio;
using testing::plane_of;

std::unique_ptr<Technique> technique_with(const std::vector<std::string>& params) {
    std::unique_ptr<Technique> technique = make(reference());
    for (const std::string& param : params) set_param(*technique, param);
    return technique;
}

Outcome rendered(const OwnStudio& studio, const std::vector<std::string>& params = {}) {
    return studio.render(*technique_with(params));
}

Outcome truth_of(const OwnStudio& studio) {
    return studio.render(*baseline::describe().create());
}

/// Slope of a line through (log x, log y).
double slope_of(const std::vector<double>& x, const std::vector<double>& y) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    const auto n = static_cast<double>(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double lx = std::log(x[i]), ly = std::log(y[i]);
        sx += lx;
        sy += ly;
        sxx += lx * lx;
        sxy += lx * ly;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// What is wrong with a picture's shadows, in pixels.
struct Wrong {
    double shadow = 0, light = 0;
};

Wrong wrong_of(const OwnStudio& studio, std::vector<std::string> params) {
    params.emplace_back("judge=on");
    const Outcome outcome = rendered(studio, params);
    Wrong wrong;
    for (const float f : plane_of<float>(outcome, "false shadow").pixels()) wrong.shadow += f;
    for (const float f : plane_of<float>(outcome, "false light").pixels()) wrong.light += f;
    return wrong;
}

constexpr const char* modes[] = {"mode=classic", "mode=pcss",      "mode=vsm",
                                 "mode=msm",     "mode=heuristic", "mode=exact"};

/// A ball over a floor, lit from above; a mirror stands behind.
Scene ball_over_floor() {
    Scene scene = testing::empty_scene();
    scene.camera.position = {0, 2, -6};
    scene.camera.pitch_deg = -15;
    scene.lights[0] = PointLight{.position = {1, 6, -1}, .power = 60};
    testing::add_shape(scene, Cube{.side = 20}, Transform::translation({0, -10, 3}));
    testing::add_shape(scene, Sphere{.centre = {0, 1.2, 0}, .radius = 0.8});
    const NodeId mirror =
        testing::add_shape(scene, Cube{.side = 6}, Transform::translation({0, 3.01, 7}));
    scene.materials[scene.nodes[mirror].material] = Reflection{};
    return scene;
}

/// Shadow of a ball of radius 1 at (0, 0, 4), seen from the origin: by how many of a million points
/// of a plane z = 8 the map is wrong.
double misclassified(int n, const Accelerator& accelerator) {
    const Steps steps = reference();
    Tracer tracer(accelerator);
    CubeMap map{n, {}};
    Face& face = map.faces[4];
    face.window = {n / 4, n / 4, n - n / 4, n - n / 4};
    face.distance = Image<float>({face.window.width(), face.window.height()});
    steps.render_face(Vec3d(0), 4, n, face.window, tracer, face.distance.view());
    constexpr int side = 1000;
    std::vector<Receiver> receivers;
    std::vector<int> lit;
    for (std::uint64_t i = 0; i < side * side; ++i) {
        const Vec2d in_cell = Key(5).square(i);
        const double x = (i % side + in_cell.x) / side * 6 - 3,
                     y = (i / side + in_cell.y) / side * 6 - 3;
        receivers.push_back({Vec3(x, y, 8), {0, 0, -1}});
        const double sine = std::hypot(x, y) / std::sqrt(x * x + y * y + 64);
        lit.push_back(sine * 4 > 1 ? 1 : 0);
    }
    std::vector<float> biases(receivers.size()), shares(receivers.size());
    steps.bias(receivers, n, biases);
    steps.lit(map, receivers, biases, shares);
    double wrong = 0;
    for (std::size_t i = 0; i < shares.size(); ++i)
        wrong += std::abs(shares[i] - static_cast<float>(lit[i]));
    return wrong / static_cast<double>(shares.size());
}

TEST(ShadowMap, IsWrongAlongEdgesInProportionToTheTexel) {
    Scene scene = testing::empty_scene();
    testing::add_shape(scene, Sphere{.centre = {0, 0, 4}, .radius = 1});
    testing::add_shape(scene, Cube{.centre = {0, 0, 18}, .side = 20});
    const OwnStudio studio(std::move(scene));
    std::vector<double> sides, wrong, rmse;
    for (int n = 32; n <= 2048; n *= 2) {
        sides.push_back(n);
        wrong.push_back(misclassified(n, studio.studio().accelerator));
        rmse.push_back(std::sqrt(wrong.back()));
    }
    RecordProperty("slope", std::to_string(slope_of(sides, wrong)));
    std::printf("misclassified %.3g..%.3g, slope %.3f; RMSE slope %.3f\n", wrong.front(),
                wrong.back(), slope_of(sides, wrong), slope_of(sides, rmse));
    EXPECT_NEAR(slope_of(sides, wrong), -1, 0.1);
    EXPECT_NEAR(slope_of(sides, rmse), -0.5, 0.05);
}

TEST(ShadowMap, ShowsTheShadowWhereRaysShowIt) {
    const OwnStudio studio(ball_over_floor());
    const Outcome truth = truth_of(studio);
    for (const char* mode : modes) {
        const Outcome outcome = rendered(studio, {mode, "side=1024"});
        std::size_t off = 0;
        for (std::size_t i = 0; i < outcome.frame.colour.pixels().size(); ++i) {
            const Rgb& a = outcome.frame.colour.pixels()[i];
            const Rgb& b = truth.frame.colour.pixels()[i];
            off += max_norm(a - b) > 0.1f * max_norm(b) ? 1 : 0;
        }
        EXPECT_LT(off, 0.02 * outcome.frame.colour.size().area()) << mode;
        EXPECT_EQ(outcome.non_finite.count, 0u) << mode;
        if (std::string(mode) == "mode=heuristic") {
            EXPECT_LT(different_pixels(outcome, truth), 0.005 * truth.frame.size().area());
        }
        if (std::string(mode) == "mode=exact") continue;
        EXPECT_LT(outcome.counts.of(RayKind::shadow), 0.05 * truth.counts.of(RayKind::shadow))
            << mode;
    }
}

TEST(ShadowMap, ShowsTheShadowInAMirrorToo) {
    const OwnStudio studio(ball_over_floor());
    const Outcome maps = rendered(studio, {"pcf=off"}), rays = truth_of(studio);
    EXPECT_GT(rays.counts.of(RayKind::reflection), 500u);
    EXPECT_EQ(maps.counts.of(RayKind::shadow), 0u) << "not a ray, not even there";
}

TEST(ShadowMap, GivesTheSameBitsOnAnyNumberOfThreads) {
    const OwnStudio one(ball_over_floor(), 1), three(ball_over_floor(), 3);
    for (const char* mode : modes) {
        EXPECT_EQ(rendered(one, {mode}).frame.colour, rendered(three, {mode}).frame.colour) << mode;
    }
    EXPECT_EQ(rendered(one, {"layout=sphere"}).frame.colour,
              rendered(three, {"layout=sphere"}).frame.colour);
}

TEST(ShadowMap, ReportsFalseShadowAndFalseLightApart) {
    const OwnStudio studio(ball_over_floor());
    const auto with = [&](const char* bias) {
        return wrong_of(studio, {"pcf=off", "offset=off", bias});
    };
    const Wrong acne = with("bias=0.3"), right = with("bias=1.01"), leaks = with("bias=60");
    EXPECT_GT(acne.shadow, 5 * right.shadow) << "edges are left";
    EXPECT_GT(leaks.light, 2 * right.light);
    EXPECT_LE(leaks.shadow, right.shadow);
}

/// The camera looks down at a floor without an edge in sight; a small light hangs above it.
Scene grazed_floor(double height) {
    Scene scene = testing::empty_scene();
    scene.camera.position = {0, 30, 0};
    scene.camera.pitch_deg = -90;
    scene.lights[0] = PointLight{.position = {0.1, height, 0.2}, .power = 60};
    testing::add_shape(scene, Cube{.side = 2000}, Transform::translation({0, -1000, 0}));
    testing::add_shape(scene, Sphere{.centre = {0, 50, 0}});  // it is not a lone thing
    return scene;
}

TEST(ShadowMap, LeavesNoAcneOnAFloorThatIsLitUpTo89Degrees) {
    for (const double height : {20.0, 2.0, 0.3}) {  // to 63°, 87° and 89.6° to the normal
        const OwnStudio studio(grazed_floor(height));
        for (const char* offset : {"offset=on", "offset=off"}) {
            for (const char* filter : {"pcf=on", "pcf=off"}) {
                EXPECT_EQ(wrong_of(studio, {"fit=off", offset, filter}).shadow, 0)
                    << height << " " << offset << " " << filter;
            }
        }
    }
    const OwnStudio studio(grazed_floor(2));
    EXPECT_GT(wrong_of(studio, {"fit=off", "offset=off", "pcf=off", "bias=0.5"}).shadow, 100);
}

TEST(ShadowMap, LosesLessOfAShadowNear90DegreesWithTheNormalOffset) {
    Scene scene = testing::empty_scene();
    scene.camera.position = {0, 6, 11};
    scene.camera.pitch_deg = -90;
    scene.lights[0] = PointLight{.position = {0, 0.2, 0}, .power = 60};
    testing::add_shape(scene, Cube{.side = 200}, Transform::translation({0, -100, 0}));
    testing::add_shape(scene, Cube{},
                       Transform::scaling({3, 2, 0.1}).then(Transform::translation({0, 1, 8})));
    const OwnStudio studio(std::move(scene));
    const auto leaks = [&](const char* offset) {
        return wrong_of(studio, {"fit=off", "side=128", "pcf=off", offset}).light;
    };
    EXPECT_LT(leaks("offset=on"), 0.5 * leaks("offset=off"));
}

TEST(ShadowMap, KeepsItsMapsWhileNothingMoves) {
    const OwnStudio studio(ball_over_floor());
    for (const char* mode : modes) {
        const auto technique = technique_with({mode});
        const auto filled = [&] {
            const Outcome outcome = studio.render(*technique);
            const auto& stages = outcome.plan.stages;
            return std::ranges::find(stages, std::string("shadow maps"), &Stage::name)->work;
        };
        EXPECT_GT(filled(), 1000u) << mode;
        EXPECT_EQ(filled(), 0u) << mode;
    }
}

/// Texels that are filled anew when a scene becomes another, and whether the picture is then the
/// other's.
std::uint64_t refilled(const Scene& before, const Scene& after, const char* mode = "mode=classic") {
    const OwnStudio one(before), other(after);
    const auto technique = technique_with({mode, "fit=off"});
    const Outcome first = one.render(*technique);
    const Outcome second = other.render(*technique);
    EXPECT_EQ(second.frame.colour, rendered(other, {mode, "fit=off"}).frame.colour) << mode;
    return std::ranges::find(second.plan.stages, std::string("shadow maps"), &Stage::name)->work;
}

TEST(ShadowMap, MakesAnewOnlyTheFacesThatSeeWhatMoved) {
    Scene scene = testing::empty_scene();
    scene.lights[0] = PointLight{.position = {0, 0, 0}, .power = 60};
    scene.lights.emplace_back(PointLight{.position = {50, 0, 0}, .power = 60});
    testing::add_shape(scene, Cube{.side = 0.5}, Transform::translation({0, 0, 5}));
    testing::add_shape(scene, Cube{.side = 200}, Transform::translation({0, -110, 0}));
    testing::add_shape(scene, Cube{.side = 200}, Transform::translation({0, 110, 0}));
    testing::add_shape(scene, Cube{.side = 200}, Transform::translation({0, 0, 300}));
    constexpr std::uint64_t face = 512 * 512;
    const auto moved = [&](const Vec3d& to) {
        Scene other = scene;
        other.nodes[0].to_world = Transform::translation(to);
        other.nodes[0].to_object = other.nodes[0].to_world.inverse();
        return other;
    };
    for (const char* mode : modes) {
        EXPECT_EQ(refilled(scene, scene, mode), 0u) << mode;
    }
    // Seen through the face +z of the first light, and −x of the second.
    const std::uint64_t once = refilled(scene, moved({0, 0, 5.5}));
    EXPECT_LE(once, 2 * face);
    EXPECT_GT(once, 0u);
    // From one face of the first light to another; −x of the second either way.
    EXPECT_LE(refilled(scene, moved({0, 5, 0.5})), 3 * face);
    EXPECT_GT(refilled(scene, moved({0, 5, 0.5})), once);
    Scene light = scene;
    std::get<PointLight>(light.lights[1]).position.x = 51;
    const std::uint64_t of_light = refilled(scene, light);
    EXPECT_GT(of_light, 2 * face) << "all that the moved light sees";
    EXPECT_LE(of_light, 6 * face) << "and nothing of the other's";
    Scene painted = scene;
    painted.materials[0] = Lambert{.color = Rgb(0.9f)};
    EXPECT_EQ(refilled(scene, painted), 0u) << "a colour casts no shadow";
}

TEST(ShadowMap, IsLessWrongAndTakesFourTimesTheMemoryWithEveryDoublingOfItsSide) {
    const OwnStudio studio(ball_over_floor());
    double before = 1e9;
    std::uint64_t bytes_before = 0;
    for (int side = 64; side <= 1024; side *= 2) {
        const auto technique =
            technique_with({"judge=on", "pcf=off", "fit=off", "side=" + std::to_string(side)});
        const Outcome outcome = studio.render(*technique);
        double shadow = 0, light = 0, asked = 0;
        for (const float f : plane_of<float>(outcome, "false shadow").pixels()) shadow += f;
        for (const float f : plane_of<float>(outcome, "false light").pixels()) light += f;
        for (const Rgb& pixel : outcome.frame.colour.pixels()) asked += pixel == Rgb(0) ? 0 : 1;
        const auto& stages = outcome.plan.stages;
        const std::uint64_t bytes =
            std::ranges::find(stages, std::string("memory of maps"), &Stage::name)->work;
        std::printf("side %4d: false shadow %.2f %%, false light %.2f %%, %.2f MB\n", side,
                    100 * shadow / asked, 100 * light / asked, static_cast<double>(bytes) * 1e-6);
        EXPECT_LT(shadow + light, 0.75 * before) << side;
        if (bytes_before > 0) {
            EXPECT_NEAR(static_cast<double>(bytes), 4.0 * static_cast<double>(bytes_before),
                        0.2 * static_cast<double>(bytes));
        }
        before = shadow + light;
        bytes_before = bytes;
    }
}

TEST(ShadowMap, KeepsToItsMemory) {
    const OwnStudio studio(ball_over_floor());
    const Outcome outcome = rendered(studio, {"memory=0"}), truth = truth_of(studio);
    EXPECT_EQ(different_pixels(outcome, truth), 0u) << "all is left to rays";
    EXPECT_EQ(outcome.counts.of(RayKind::shadow), truth.counts.of(RayKind::shadow));
}

TEST(ShadowMap, LooksFromAFarLightAtWhatItShinesOnOnly) {
    Scene scene = ball_over_floor();
    scene.lights[0] = PointLight{.position = {1000, 6000, -1000}, .power = 6e7f};
    const OwnStudio studio(std::move(scene));
    const auto light = [&](const char* fit) { return wrong_of(studio, {"pcf=off", fit}).light; };
    EXPECT_LT(5 * light("fit=on"), light("fit=off"));
    EXPECT_LT(wrong_of(studio, {"pcf=off"}).shadow, 100);
}

TEST(ShadowMap, FillsAHoleWithTheReferenceAndNamesIt) {
    Steps steps = reference();
    steps.pcf = [](const CubeMap&, std::span<const Receiver>, std::span<const float>,
                   std::span<float>) { LUCH_TODO("shadow_map.t5"); };
    const OwnStudio studio(ball_over_floor());
    const auto technique = make(steps);
    const Outcome outcome = studio.render(*technique);
    EXPECT_THAT(outcome.unwritten, ::testing::ElementsAre("shadow_map.t5"));
    EXPECT_EQ(outcome.frame.colour, rendered(studio).frame.colour);
}

TEST(ShadowMap, UnwrapsItsFaces) {
    const OwnStudio studio(ball_over_floor());
    for (const char* layout : {"layout=cube", "layout=sphere"}) {
        const Outcome outcome = rendered(studio, {"unwrap=on", "fit=off", layout});
        std::set<float> greys;
        for (const Rgb& pixel : outcome.frame.colour.pixels()) greys.insert(pixel.r);
        EXPECT_GT(greys.size(), 50u) << layout;
        EXPECT_EQ(outcome.counts.all_rays(), 0u) << layout;
    }
}

}  // namespace
}  // namespace luch::techniques::shadow_map
