// The steps against closed forms.
#include "techniques/sh_ambient/ringing.h"
#include "techniques/sh_ambient/sh_ambient.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <numbers>

namespace luch::techniques::sh_ambient {
namespace {

constexpr double pi = std::numbers::pi;
constexpr float infinite = std::numeric_limits<float>::infinity();
const Steps steps = reference();

/// Unit vectors without a pattern.
std::vector<Vec3d> directions(int count) {
    std::vector<Vec3d> all;
    for (int i = 0; i < count; ++i) {
        const Vec2d square = Key(3).square(static_cast<std::uint64_t>(i));
        const double z = 1 - 2 * square.x, turn = 2 * pi * square.y, r = std::sqrt(1 - z * z);
        all.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
    }
    return all;
}

/// Adds light of that power from one direction.
void add_light(Sh9& light, const Vec3d& from, const Rgb& power = Rgb(1)) {
    const auto y = harmonics(from);
    for (std::size_t k = 0; k < sh_terms; ++k) light.l[k] += power * static_cast<float>(y[k]);
}

Sh9 unit_light(const Vec3d& from) {
    Sh9 light;
    add_light(light, from);
    return light;
}

Rgb irradiance(const Sh9& light, const Vec3d& normal) {
    const Vec3 n(normal);
    Rgb e;
    steps.irradiance(light, {&n, 1}, {&e, 1});
    return e;
}

Sh9 projected(const Environment& sky) {
    Sh9 light;
    steps.project(sky, light);
    return light;
}

/// A sky that is a function of the direction, at its texels.
CubemapEnvironment sky_of(int side, const std::function<Rgb(const Vec3d&)>& colour) {
    CubemapEnvironment sky;
    for (std::size_t i = 0; i < 6; ++i) {
        sky.sides[i] = Image<Rgb>({side, side});
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const CubePoint at{static_cast<CubePoint::Side>(i), 2.0 * x / (side - 1) - 1,
                                   2.0 * y / (side - 1) - 1};
                sky.sides[i](x, y) = colour(glm::normalize(at.direction()));
            }
        }
    }
    return sky;
}

/// Black but for one texel of the side that looks up.
CubemapEnvironment one_texel(int side, int x, int y, float value) {
    CubemapEnvironment sky = sky_of(2, [](const Vec3d&) { return Rgb(0); });
    sky.sides[CubemapEnvironment::pos_y] = Image<Rgb>({side, side}, Rgb(0));
    sky.sides[CubemapEnvironment::pos_y](x, y) = Rgb(value);
    return sky;
}

TEST(Harmonics, AreOrthonormal) {
    // Gauss's five heights and nine turns: exact for all products of two of them.
    constexpr std::array z{0.0, 0.5384693101056831, -0.5384693101056831, 0.9061798459386640,
                           -0.9061798459386640};
    constexpr std::array w{0.5688888888888889, 0.4786286704993665, 0.4786286704993665,
                           0.2369268850561891, 0.2369268850561891};
    std::array<std::array<double, sh_terms>, sh_terms> product{};
    for (std::size_t i = 0; i < 5; ++i) {
        for (int turn = 0; turn < 9; ++turn) {
            const double r = std::sqrt(1 - z[i] * z[i]), angle = 2 * pi * turn / 9;
            const auto y = harmonics(Vec3d(r * std::cos(angle), r * std::sin(angle), z[i]));
            for (std::size_t a = 0; a < sh_terms; ++a) {
                for (std::size_t b = 0; b < sh_terms; ++b) {
                    product[a][b] += y[a] * y[b] * w[i] * 2 * pi / 9;
                }
            }
        }
    }
    for (std::size_t a = 0; a < sh_terms; ++a) {
        for (std::size_t b = 0; b < sh_terms; ++b) {
            EXPECT_NEAR(product[a][b], a == b ? 1 : 0, 1e-14) << a << " " << b;
        }
    }
}

TEST(Project, TurnsEveryHarmonicIntoAUnitVector) {
    for (std::size_t k = 0; k < sh_terms; ++k) {
        const Sh9 light = projected(
            sky_of(129, [k](const Vec3d& d) { return Rgb(static_cast<float>(harmonics(d)[k])); }));
        for (std::size_t j = 0; j < sh_terms; ++j) {
            EXPECT_NEAR(light.l[j].y, j == k ? 1 : 0, 3e-4) << k << " " << j;
        }
    }
}

TEST(Project, KnowsAConstantSkyExactly) {
    const Sh9 light = projected(ConstantEnvironment{{0.5f, 1, 2}});
    EXPECT_FLOAT_EQ(light.l[0].z, static_cast<float>(2 * std::sqrt(4 * pi)));
    for (std::size_t k = 1; k < sh_terms; ++k) EXPECT_EQ(light.l[k], Rgb(0));
    for (const Vec3d& n : directions(20)) {
        EXPECT_NEAR(irradiance(light, n).x, 0.5 * pi, 1e-6);
    }
}

TEST(Project, WeighsTexelsByTheirSolidAngleHoweverFewOrOddlyMany) {
    for (const Size size : {Size{1, 1}, Size{2, 3}, Size{64, 64}, Size{129, 17}, Size{200, 1}}) {
        CubemapEnvironment sky;
        for (Image<Rgb>& side : sky.sides) side = Image<Rgb>(size, Rgb(1));
        const Sh9 light = projected(sky);
        EXPECT_NEAR(light.l[0].x, std::sqrt(4 * pi), 1e-6) << size.width;
        for (std::size_t k = 1; k < sh_terms; ++k) EXPECT_NEAR(light.l[k].x, 0, 2e-7) << k;
    }
}

TEST(Project, GivesEverySideASixthOfTheSphere) {
    for (std::size_t i = 0; i < 6; ++i) {
        CubemapEnvironment sky = sky_of(2, [](const Vec3d&) { return Rgb(0); });
        sky.sides[i] = Image<Rgb>({64, 64}, Rgb(1));
        // ∫ z²/|d|⁵ over the side, whose mean over all directions is 1/3.
        const Sh9 light = projected(sky);
        EXPECT_NEAR(light.l[0].x, std::sqrt(4 * pi) / 6, 1e-6) << i;
        const Vec3d middle = CubePoint{static_cast<CubePoint::Side>(i), 0, 0}.direction();
        const Vec3d linear(light.l[3].x, light.l[1].x, light.l[2].x);
        EXPECT_NEAR(glm::dot(linear, middle), glm::length(linear), 1e-6) << i;
        EXPECT_GT(glm::length(linear), 0.8) << i;
    }
}

TEST(Project, GivesACornersTexelAQuarterOfItsAreaAndLessOfTheSphere) {
    const float middle = projected(one_texel(129, 64, 64, 1)).l[0].x;
    const float corner = projected(one_texel(129, 0, 0, 1)).l[0].x;
    // dω = ds·dt/|d|³ with |d|² = 3 in the corner.
    EXPECT_NEAR(corner / middle, 0.25 / std::pow(3, 1.5), 0.0015);
}

TEST(Project, CountsTexelsThatAreNotFiniteAndDoesNotSpreadThem) {
    const auto smooth = [](const Vec3d& d) { return Rgb(static_cast<float>(1 + d.x)); };
    CubemapEnvironment sky = sky_of(16, smooth), black = sky;
    sky.sides[2](3, 4) = Rgb(infinite, 1, 1);
    sky.sides[4](0, 0) = Rgb(1, std::nanf(""), 1);
    black.sides[2](3, 4) = black.sides[4](0, 0) = Rgb(0);
    Sh9 light;
    EXPECT_EQ(steps.project(sky, light), 2u);
    EXPECT_EQ(light, projected(black));
    EXPECT_EQ(steps.project(ConstantEnvironment{Rgb(infinite)}, light), 1u);
}

TEST(Project, StaysFiniteUnderASunOf1e30) {
    const Sh9 light = projected(one_texel(64, 20, 30, 1e30f));
    for (const Vec3d& n : directions(50)) EXPECT_TRUE(all_finite(irradiance(light, n)));
    EXPECT_GT(max_norm(light.l[0]), 1e25f);
}

TEST(Irradiance, OfAUnitLightIsTheKnownPolynomial) {
    const Vec3d up(0, 1, 0);
    // A texel in the middle of the side above, small enough to be a point.
    Sh9 light = projected(one_texel(257, 128, 128, 1));
    const float power = light.l[0].x * static_cast<float>(std::sqrt(4 * pi));
    for (Rgb& l : light.l) l /= power;
    for (const Sh9& each : {light, unit_light(up)}) {
        const auto at = [&](double cosine) {
            return irradiance(each, {std::sqrt(1 - cosine * cosine), cosine, 0}).x;
        };
        EXPECT_NEAR(at(1), 1.0625, 1e-4);
        EXPECT_NEAR(at(0), 0.09375, 1e-4);
        EXPECT_NEAR(at(-8.0 / 15), -0.03958, 1e-5);
        for (double cosine = -1; cosine <= 1; cosine += 1.0 / 64) {
            EXPECT_GE(at(cosine), at(-8.0 / 15) - 1e-6) << cosine;
            const double expected = 0.25 + cosine / 2 + 5.0 / 32 * (3 * cosine * cosine - 1);
            EXPECT_NEAR(at(cosine), expected, 1e-4) << cosine;
        }
    }
}

TEST(Irradiance, TurnsWithTheLight) {
    const Transform turn = Transform::rotation(0.7, -1.1, 2.3);
    Sh9 light, turned;
    for (const Vec3d& from : directions(7)) {
        add_light(light, from);
        add_light(turned, turn.direction(from));
    }
    const auto sky = [](const Vec3d& d) {
        return Rgb(static_cast<float>(std::exp(2 * d.x - d.y)), static_cast<float>(d.z * d.z), 1);
    };
    const Sh9 whole = projected(sky_of(97, sky)),
              whole_turned = projected(
                  sky_of(97, [&](const Vec3d&d) { return sky(turn.inverse().direction(d)); }));
    for (const Vec3d& n : directions(40)) {
        EXPECT_NEAR(irradiance(light, n).x, irradiance(turned, turn.direction(n)).x, 3e-6);
        const Rgb a = irradiance(whole, n), b = irradiance(whole_turned, turn.direction(n));
        EXPECT_LT(max_norm(a - b), 2e-3f * max_norm(a));
    }
}

TEST(Irradiance, LooksAtNoTermAboveItsDegree) {
    Sh9 light = unit_light({0.6, 0, 0.8});
    for (const int degree : {0, 1}) {
        Sh9 cut = light, wild = light;
        cut.degree = wild.degree = degree;
        for (int k = (degree + 1) * (degree + 1); k < sh_terms; ++k) {
            wild.l[static_cast<std::size_t>(k)] = Rgb(infinite);
        }
        EXPECT_EQ(irradiance(cut, {0, 1, 0}), irradiance(wild, {0, 1, 0})) << degree;
    }
    light.l[2] = light.l[3] = Rgb(0);
    Sh9 full = light;
    full.degree = 1;
    for (std::size_t k = 4; k < sh_terms; ++k) light.l[k] = Rgb(0);
    EXPECT_EQ(irradiance(light, {0, 0.6, 0.8}), irradiance(full, {0, 0.6, 0.8}))
        << "terms that are 0 change no bit";
}

TEST(Irradiance, GivesTheSameBitsForAnyDivision) {
    const Sh9 light = unit_light(directions(1)[0]);
    std::vector<Vec3> normals;
    for (const Vec3d& n : directions(100)) normals.emplace_back(n);
    std::vector<Rgb> whole(100), parts(100);
    steps.irradiance(light, normals, whole);
    for (const std::size_t size : {1u, 7u, 16u}) {
        for (std::size_t i = 0; i < 100; i += size) {
            const std::size_t n = std::min<std::size_t>(size, 100 - i);
            steps.irradiance(light, std::span(normals).subspan(i, n),
                             std::span(parts).subspan(i, n));
        }
        EXPECT_EQ(parts, whole) << size;
    }
}

/// The least irradiance by looking at many normals.
double least_seen(const Sh9& light) {
    double least = infinite;
    for (const Vec3d& n : directions(20000)) {
        const Rgb e = irradiance(light, n);
        least = std::min<double>(least, std::min({e.x, e.y, e.z}));
    }
    return least;
}

TEST(Ringing, IsFoundWhereItIsWorst) {
    EXPECT_NEAR(least_irradiance(unit_light({0, 0, 1})), -0.0395833, 1e-6);
    EXPECT_NEAR(least_irradiance(unit_light(directions(1)[0])), -0.0395833, 1e-6);
    EXPECT_NEAR(least_irradiance(projected(ConstantEnvironment{Rgb(2)})), 2 * pi, 1e-5);
    for (std::uint64_t i = 0; i < 20; ++i) {
        Sh9 light;
        for (std::size_t k = 0; k < sh_terms; ++k) {
            for (int c = 0; c < 3; ++c) {
                light.l[k][c] =
                    static_cast<float>(Key(i).uniform(3 * k + static_cast<std::uint64_t>(c)) - 0.5);
            }
        }
        const double least = least_irradiance(light), seen = least_seen(light);
        EXPECT_LE(least, seen + 1e-6) << "a lower bound";
        EXPECT_NEAR(least, seen, 3e-3) << "that is met";
    }
}

TEST(Ringing, EndsWhenDegreeOneIsScaled) {
    Sh9 light = unit_light({0, 0, 1});
    EXPECT_NEAR(ringing_scale, 0.8385, 5e-5);
    EXPECT_NEAR(least_scaling(light), ringing_scale, 2e-4);
    scale_linear_terms(light, ringing_scale);
    EXPECT_NEAR(least_irradiance(light), 0, 1e-7);
    scale_linear_terms(light, 1.01);
    EXPECT_LT(least_irradiance(light), -1e-3) << "no more is possible";
}

TEST(Ringing, GoesOnUnderTheUsualWindows) {
    const auto windowed = [](double first, double second) {
        Sh9 light = unit_light({0, 0, 1});
        for (std::size_t k = 1; k < sh_terms; ++k) {
            light.l[k] *= static_cast<float>(k < 4 ? first : second);
        }
        return least_irradiance(light);
    };
    EXPECT_LT(windowed(0.75, 0.25), -0.03) << "Hann's, (1 + cos(πl/3))/2";
    EXPECT_LT(windowed(0.827, 0.4135), -0.02) << "Lanczos's, sin(πl/3)/(πl/3)";
}

TEST(Ringing, IsLeftAloneWhereIrradianceIsNowhereBelowZero) {
    Sh9 light = unit_light({0, 0, 1});
    light.l[0] += Rgb(1);
    EXPECT_EQ(least_scaling(light), 1);
    light.l[0] -= Rgb(0.98f);
    EXPECT_GT(least_scaling(light), ringing_scale);
    EXPECT_LT(least_scaling(light), 1);
}

TEST(Ringing, EndsForLightOfAnySizeWhateverRoundingDoes) {
    for (const float power : {1e-30f, 1.0f, 1e30f}) {
        Sh9 light;
        for (const Vec3d& from : directions(2)) add_light(light, from, Rgb(power, power / 2, 0));
        scale_linear_terms(light, least_scaling(light));
        EXPECT_GE(least_seen(light), 0) << power;
    }
}

}  // namespace
}  // namespace luch::techniques::sh_ambient
