// The steps against closed forms.
#include "framework/math/rng.h"
#include "techniques/shadow_map/cube.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

#include <numbers>

namespace luch::techniques::shadow_map {
namespace {

const Steps steps = reference();
constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

Texel texel_of(const Vec3& direction, int n) {
    Texel texel;
    steps.texel_of({&direction, 1}, n, {&texel, 1});
    return texel;
}

Vec3 direction_of(const Texel& texel, int n) {
    Vec3 direction;
    steps.direction_of({&texel, 1}, n, {&direction, 1});
    return direction;
}

float bias_of(const Receiver& receiver, int n) {
    float bias = -1;
    steps.bias({&receiver, 1}, n, {&bias, 1});
    return bias;
}

float share_of(void (*step)(const CubeMap&, std::span<const Receiver>, std::span<const float>,
                            std::span<float>),
               const CubeMap& map, const Receiver& receiver, float bias) {
    float share = -1;
    step(map, {&receiver, 1}, {&bias, 1}, {&share, 1});
    return share;
}

/// A whole map; each texel by a function of its centre's direction.
template <class Distance>
CubeMap map_of(int n, Distance&& distance) {
    CubeMap map{n, {}};
    for (int face = 0; face < faces_of_cube; ++face) {
        auto& [window, stored] = map.faces[static_cast<std::size_t>(face)];
        window = {0, 0, n, n};
        stored = Image<float>({n, n});
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) stored(x, y) = distance(direction_of({face, x, y}, n));
        }
    }
    return map;
}

/// How far a plane n·x = 1 is along a direction.
float to_plane(const Vec3& normal, const Vec3& direction) {
    const float along = glm::dot(normal, direction);
    return along > 0 ? 1 / along : infinite;
}

/// A direction anywhere, none preferred.
Vec3d anywhere(Key key) {
    const Vec2d u = key.square(0);
    const double y = 2 * u.x - 1, level = std::sqrt(1 - y * y), angle = 2 * std::numbers::pi * u.y;
    return {level * std::cos(angle), y, level * std::sin(angle)};
}

TEST(ShadowMapSteps, FindTheTexelOfEachDirectionThroughACentre) {
    for (const int n : {1, 2, 7, 64, 2048, 1 << 17}) {
        for (int face = 0; face < faces_of_cube; ++face) {
            for (int i = 0; i < n; i += 1 + n / 999) {
                const Texel texel{face, i, (i * 7 + 3) % n};
                ASSERT_EQ(texel_of(direction_of(texel, n), n), texel) << n << " " << face;
                EXPECT_NEAR(glm::length(direction_of(texel, n)), 1, 1e-6);
            }
        }
    }
}

TEST(ShadowMapSteps, TakeTheFirstOfTiedAxes) {
    for (const float s : {1.0f, -1.0f}) {
        const int sign = s < 0 ? 1 : 0;
        EXPECT_EQ(texel_of({s, 1, 1}, 8), (Texel{sign, 7, 7}));
        EXPECT_EQ(texel_of({s, -1, 1}, 8), (Texel{sign, 0, 7}));
        EXPECT_EQ(texel_of({0, s, 1}, 8), (Texel{2 + sign, 7, 4}));
        EXPECT_EQ(texel_of({s, 0, 1}, 8), (Texel{sign, 4, 7}));
        EXPECT_EQ(texel_of({0, 0, s}, 8), (Texel{4 + sign, 4, 4}));
    }
}

TEST(ShadowMapSteps, GiveTheMiddleOfAFaceForWhatIsNoDirection) {
    for (const Vec3& d : {Vec3(0), Vec3(nan, 1, 1), Vec3(1, infinite, 1)}) {
        EXPECT_EQ(texel_of(d, 9), (Texel{0, 4, 4}));
    }
}

TEST(ShadowMapSteps, FoldEveryTexelOfTheTwelveEdgesOntoItsNeighbourAndBack) {
    constexpr int n = 8;
    for (int face = 0; face < faces_of_cube; ++face) {
        for (int i = 0; i < n; ++i) {
            for (const Texel& past :
                 {Texel{face, -1, i}, {face, n, i}, {face, i, -1}, {face, i, n}}) {
                const auto there = folded(past, n);
                ASSERT_TRUE(there);
                EXPECT_NE(there->face, face);
                const Texel here{face, std::clamp(past.x, 0, n - 1), std::clamp(past.y, 0, n - 1)};
                // Neighbours across an edge are as near as neighbours get there.
                const float cosine = glm::dot(direction_of(*there, n), direction_of(here, n));
                EXPECT_GT(cosine, std::cos(2.1 / n)) << face << " " << past.x << " " << past.y;
                int back = 0;
                for (const Texel& of_there : {Texel{there->face, there->x - 1, there->y},
                                              {there->face, there->x + 1, there->y},
                                              {there->face, there->x, there->y - 1},
                                              {there->face, there->x, there->y + 1}}) {
                    back += folded(of_there, n) == here ? 1 : 0;
                }
                EXPECT_EQ(back, 1);
            }
        }
        EXPECT_FALSE(folded({face, -1, -1}, n));
        EXPECT_FALSE(folded({face, n, -1}, n));
    }
}

TEST(ShadowMapSteps, HaveTheBiasOfAPlaneInClosedForm) {
    constexpr int n = 512;  // h = 1/256
    const auto tilted = [](double deg) {
        const double a = deg * std::numbers::pi / 180;
        return Vec3(Vec3d(std::sin(a), 0, std::cos(a)));
    };
    EXPECT_NEAR(bias_of({{0, 0, 1}, tilted(45)}, n), 0.5 / 256, 1e-5);
    EXPECT_NEAR(bias_of({{0, 0, 1}, tilted(89)}, n), 0.5 / 256 * 57.29, 1e-4);
    EXPECT_NEAR(bias_of({{0, 0, 1}, tilted(0)}, n), 0, 1e-5);
    EXPECT_FLOAT_EQ(bias_of({{0, 0, 3}, tilted(45)}, n), 3 * bias_of({{0, 0, 1}, tilted(45)}, n));
    EXPECT_EQ(bias_of({{0, 0, 1}, tilted(45)}, n), bias_of({{0, 0, 1}, -tilted(45)}, n))
        << "a surface has two sides";
    EXPECT_EQ(bias_of({{0, 0, 1}, {1, 0, 0}}, n), infinite);
    EXPECT_EQ(bias_of({{0, 0, 0}, {1, 0, 0}}, n), 0);
}

/// Receivers anywhere on a plane that is tilted against the direction to where it is nearest to the
/// middle of a face, and how many of them a map of that plane holds for shadowed.
struct Acne {
    int asked = 0, by_lit = 0, by_pcf = 0;
};

Acne acne_of(double tilt_deg, double factor) {
    constexpr int n = 256;
    Acne acne;
    for (std::uint64_t plane = 0; plane < 6; ++plane) {
        const Key key = Key(7).branch(plane);
        const double tilt = tilt_deg * std::numbers::pi / 180;
        const Vec3d middle = anywhere(key);
        const Vec3d aside = glm::normalize(glm::cross(middle, anywhere(key.branch(1))));
        const Vec3 normal(std::cos(tilt) * middle + std::sin(tilt) * aside);
        const CubeMap map = map_of(n, [&](const Vec3& d) { return to_plane(normal, d); });
        for (std::uint64_t i = 0; i < 4000; ++i) {
            // As far from the middle as keeps it before the light.
            const Vec3d off = 0.02 * anywhere(key.branch(2 + i));
            const Vec3 d(glm::normalize(middle + off));
            if (!(glm::dot(normal, d) > 0)) continue;
            const Receiver receiver{d * to_plane(normal, d), normal};
            const float bias = static_cast<float>(factor) * bias_of(receiver, n);
            ++acne.asked;
            acne.by_lit += share_of(steps.lit, map, receiver, bias) == 1 ? 0 : 1;
            acne.by_pcf += share_of(steps.pcf, map, receiver, pcf_width * bias) == 1 ? 0 : 1;
        }
    }
    return acne;
}

TEST(ShadowMapSteps, LeaveNoAcneWithATouchMoreThanTheBiasAndMuchWithHalfOfIt) {
    for (const double tilt : {0.0, 10.0, 30.0, 45.0, 60.0, 75.0, 85.0, 88.0, 89.0}) {
        const Acne enough = acne_of(tilt, 1.01), half = acne_of(tilt, 0.5);
        EXPECT_GT(enough.asked, 10000) << tilt;
        EXPECT_EQ(enough.by_lit, 0) << tilt;
        EXPECT_EQ(enough.by_pcf, 0) << tilt;
        if (tilt < 10) continue;  // there the bias is hardly more than rounding
        EXPECT_GT(half.by_lit, half.asked / 50) << tilt;
    }
}

TEST(ShadowMapSteps, LeaveNoAcneAtTheTwelveEdgesAndEightCorners) {
    constexpr int n = 64;
    for (std::uint64_t plane = 0; plane < 40; ++plane) {
        const Vec3 normal(anywhere(Key(plane)));
        const CubeMap map = map_of(n, [&](const Vec3& d) { return to_plane(normal, d); });
        for (int edge = 0; edge < 27; ++edge) {
            const Vec3 middle(edge % 3 - 1, edge / 3 % 3 - 1, edge / 9 - 1);
            for (std::uint64_t i = 0; i < 300; ++i) {
                const Vec3 d = middle + Vec3(0.05 * anywhere(Key(edge).branch(i)));
                if (!(glm::dot(normal, glm::normalize(d)) > 0.1f)) continue;
                const Receiver receiver{glm::normalize(d) * to_plane(normal, glm::normalize(d)),
                                        normal};
                const float bias = 1.01f * bias_of(receiver, n);
                EXPECT_EQ(share_of(steps.lit, map, receiver, bias), 1);
                EXPECT_EQ(share_of(steps.pcf, map, receiver, pcf_width * bias), 1);
            }
        }
    }
}

TEST(ShadowMapSteps, AreLitUpToWhatIsStoredAndDarkBehindIt) {
    const CubeMap map = map_of(16, [](const Vec3&) { return 2.0f; });
    for (std::uint64_t i = 0; i < 500; ++i) {
        const Vec3 d(anywhere(Key(i)));
        for (const auto step : {steps.lit, steps.pcf}) {
            EXPECT_EQ(share_of(step, map, {1.99f * d, d}, 0), 1);
            EXPECT_EQ(share_of(step, map, {2.01f * d, d}, 0), 0);
            EXPECT_EQ(share_of(step, map, {2.01f * d, d}, 0.02f), 1);
        }
    }
    EXPECT_EQ(share_of(steps.lit, map, {{0, 0, 0}, {0, 1, 0}}, 0), 1) << "in the light";
    EXPECT_EQ(share_of(steps.pcf, map, {{0, 0, 0}, {0, 1, 0}}, 0), 1);
    const CubeMap nothing = map_of(4, [](const Vec3&) { return infinite; });
    EXPECT_EQ(share_of(steps.pcf, nothing, {{9, 1e30f, 0}, {0, 1, 0}}, 0), 1);
}

TEST(ShadowMapSteps, FilterOverTheEdgesOfAFaceAsWithinIt) {
    // One face is near; a receiver behind it, in the middle of a texel of the rim, sees 3 of 9.
    constexpr int n = 16;
    for (int face = 0; face < faces_of_cube; ++face) {
        CubeMap map = map_of(n, [](const Vec3&) { return infinite; });
        std::ranges::fill(map.faces[static_cast<std::size_t>(face)].distance.pixels(), 1.0f);
        const auto share = [&](const Texel& texel) {
            const Vec3 d = direction_of(texel, n);
            return share_of(steps.pcf, map, {5.0f * d, d}, 0);
        };
        EXPECT_NEAR(share({face, 0, 8}), 3.0 / 9, 1e-6);
        EXPECT_NEAR(share({face, n - 1, 3}), 3.0 / 9, 1e-6);
        EXPECT_NEAR(share({face, 5, 0}), 3.0 / 9, 1e-6);
        EXPECT_NEAR(share({face, 5, 1}), 0, 1e-6);
        const auto across = folded({face, 4, n}, n);
        ASSERT_TRUE(across);
        EXPECT_NEAR(share(*across), 6.0 / 9, 1e-6) << "as seen from the other side";
        EXPECT_NEAR(share({face, 0, 0}), 4.0 / 8, 1e-6) << "there is no ninth texel";
        EXPECT_NEAR(share({face, n - 1, 0}), 4.0 / 8, 1e-6);
    }
}

/// A ball before a wall.
Scene ball_and_wall() {
    Scene scene = testing::empty_scene();
    testing::add_shape(scene, Sphere{.centre = {0, 0, 4}, .radius = 1});
    testing::add_shape(scene, Cube{.centre = {0, 0, 30}, .side = 40});
    return scene;
}

TEST(ShadowMapSteps, StoreTheDistanceToTheNearestSurface) {
    const testing::OwnStudio studio(ball_and_wall());
    Tracer tracer(studio.studio().accelerator);
    constexpr int n = 64;
    for (int face = 0; face < faces_of_cube; ++face) {
        Image<float> distance({n, n}, -1);
        steps.render_face(Vec3d(0), face, n, {0, 0, n, n}, tracer, distance.view());
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                const Vec3d d(direction_of({face, x, y}, n));
                const double beside = std::sqrt(16 - 16 * d.z * d.z);
                const double aside = std::max(std::abs(d.x), std::abs(d.y)) / d.z;
                const double wall = d.z > 0 && aside < 2 ? 10 / d.z : infinite;
                const double ball =
                    d.z > 0 && beside < 1 ? 4 * d.z - std::sqrt(1 - beside * beside) : infinite;
                if (std::abs(beside - 1) < 1e-3 || std::abs(aside - 2) < 1e-3) continue;
                const double expected = std::min(ball, wall);
                if (std::isinf(expected)) {
                    EXPECT_EQ(distance(x, y), infinite) << face;
                } else {
                    EXPECT_NEAR(distance(x, y), expected, 1e-4 * expected) << face;
                }
            }
        }
    }
    EXPECT_EQ(tracer.counts().of(RayKind::shadow), 6u * n * n);
}

TEST(ShadowMapSteps, GiveTheSameBitsInAnyTiling) {
    const testing::OwnStudio studio(ball_and_wall());
    Tracer tracer(studio.studio().accelerator);
    constexpr int n = 33;
    const Vec3d light{0.3, 0.2, 0.1};
    Image<float> whole({n, n}), tiled({n, n});
    steps.render_face(light, 4, n, {0, 0, n, n}, tracer, whole.view());
    for (const int side : {1, 16}) {
        for (int y = 0; y < n; y += side) {
            for (int x = 0; x < n; x += side) {
                const Tile tile{x, y, std::min(x + side, n), std::min(y + side, n)};
                Image<float> part({tile.width(), tile.height()});
                steps.render_face(light, 4, n, tile, tracer, part.view());
                for (int j = tile.y0; j < tile.y1; ++j) {
                    for (int i = tile.x0; i < tile.x1; ++i) tiled(i, j) = part(i - x, j - y);
                }
            }
        }
        EXPECT_EQ(tiled, whole) << side;
    }
}

RectLight lamp() {
    return {.to_world = Transform::scaling({2, 1, 3}).then(Transform::translation({0, 9, 0}))};
}

std::vector<LightPoint> points_of(int n, Pattern pattern, Key key = Key(3)) {
    std::vector<LightPoint> points{{}, {}};
    steps.light_points(lamp(), n, pattern, key, points);
    return points;
}

TEST(ShadowMapSteps, PutPointsIntoTheCellsOfALamp) {
    for (const Pattern pattern : {Pattern::regular, Pattern::jittered}) {
        const auto points = points_of(12, pattern);  // 4 columns by 3 rows
        ASSERT_EQ(points.size(), 12u);
        for (std::size_t i = 0; i < 12; ++i) {
            const double x = points[i].position.x / 2 + 0.5, z = points[i].position.z / 3 + 0.5;
            EXPECT_EQ(static_cast<int>(x * 4), static_cast<int>(i % 4)) << i;
            EXPECT_EQ(static_cast<int>(z * 3), static_cast<int>(i / 4)) << i;
            EXPECT_LT(points[i].position.y, 9) << "off its visible face";
            EXPECT_NEAR(points[i].position.y, 9, 1e-10);
            EXPECT_FLOAT_EQ(points[i].share, 1.0f / 12);
            if (pattern != Pattern::regular) continue;
            EXPECT_NEAR(x * 4, i % 4 + 0.5, 1e-12);
            EXPECT_NEAR(z * 3, i / 4 + 0.5, 1e-12);
        }
    }
    EXPECT_EQ(points_of(7, Pattern::regular).size(), 7u);
    EXPECT_EQ(points_of(1, Pattern::regular)[0].position.x, 0);
}

TEST(ShadowMapSteps, SpreadRandomPointsOverTheLampByTheirKey) {
    const auto points = points_of(1000, Pattern::random);
    double x = 0, z = 0;
    for (const LightPoint& point : points) {
        EXPECT_LE(std::abs(point.position.x), 1);
        EXPECT_LE(std::abs(point.position.z), 1.5);
        x += point.position.x / 1000;
        z += point.position.z / 1000;
    }
    EXPECT_NEAR(x, 0, 0.06);
    EXPECT_NEAR(z, 0, 0.09);
    EXPECT_EQ(points[5].position, points_of(1000, Pattern::random)[5].position);
    EXPECT_NE(points[5].position, points_of(1000, Pattern::random, Key(4))[5].position);
    EXPECT_EQ(points[5].position, points_of(6, Pattern::random)[5].position)
        << "a point's number is its own";
}

}  // namespace
}  // namespace luch::techniques::shadow_map
