// Moments, the spherical map, soft shadows and lights with an area.
#include "techniques/shadow_map/cube.h"
#include "techniques/shadow_map/filters.h"
#include "techniques/shadow_map/moments.h"
#include "techniques/shadow_map/raster.h"
#include "techniques/shadow_map/sphere_map.h"
#include "tests/testing/meshes.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

namespace luch::techniques::shadow_map {
namespace {

/// Moments of atoms with weights.
Powers atoms(const std::vector<std::pair<double, double>>& at) {
    Powers sum(0);
    for (const auto& [z, weight] : at) sum += weight * Powers(z, z * z, z * z * z, z * z * z * z);
    return sum;
}

TEST(Moments, KnowTwoSurfacesFromFourNumbersButNotFromTwo) {
    const Powers two = atoms({{-0.5, 0.25}, {0.2, 0.75}});
    EXPECT_NEAR(lit_by_moments(two, 0.1), 0.75, 2e-3) << "behind a quarter of it";
    EXPECT_NEAR(lit_by_moments(two, 0.8), 0, 2e-3) << "behind both";
    EXPECT_EQ(lit_by_moments(two, -0.6), 1) << "before both";
    // Chebyshev: variance 0.25·0.75·0.7², mean 0.025.
    const double variance = 0.25 * 0.75 * 0.49, off = 0.8 - 0.025;
    EXPECT_NEAR(lit_by_variance(two, 0.8), variance / (variance + off * off), 1e-9)
        << "light bleeds through where two surfaces are behind one another";
    EXPECT_GT(lit_by_variance(two, 0.8), 0.1);
}

TEST(Moments, NeverLetThroughMoreThanTheVarianceDoes) {
    for (std::uint64_t i = 0; i < 3000; ++i) {
        const Key key(i);
        std::vector<std::pair<double, double>> at;
        double total = 0;
        for (std::uint64_t k = 0; k < 5; ++k) {
            at.emplace_back(2 * key.uniform(2 * k) - 1, key.uniform(2 * k + 1));
            total += at.back().second;
        }
        double behind = 0;
        const double z = 2 * key.uniform(99) - 1;
        for (auto& [depth, weight] : at) {
            weight /= total;
            behind += depth >= z ? weight : 0;
        }
        const double four = lit_by_moments(atoms(at), z), two = lit_by_variance(atoms(at), z);
        EXPECT_GE(four, behind - 1e-3) << "neither makes a shadow darker than it is";
        EXPECT_LE(four, two + 1e-3);
    }
}

TEST(Moments, TakeAVarianceThatRoundingMadeNegativeForNone) {
    const Powers rounded(0.7, 0.7 * 0.7 - 1e-7, 0.343, 0.2401);
    EXPECT_EQ(lit_by_variance(rounded, 0.71), 0);
    EXPECT_EQ(lit_by_variance(rounded, 0.69), 1);
    for (double z = -1; z <= 1; z += 0.01) {
        EXPECT_TRUE(lit_by_moments(rounded, z) >= 0 && lit_by_moments(rounded, z) <= 1) << z;
    }
}

TEST(FaceRaster, SeesThroughEveryFaceWhatRaysSee) {
    Scene scene = testing::empty_scene();
    for (std::uint64_t i = 0; i < 12; ++i) {
        const Vec3d at = 4.0 * Vec3d(Key(i).uniform(0), Key(i).uniform(1), Key(i).uniform(2)) - 2.0;
        testing::add_shape(scene, testing::uv_sphere(9, 14, 0.2 + 0.05 * static_cast<double>(i)),
                           Transform::translation(at));
    }
    testing::add_shape(scene, Sphere{.radius = 9});
    const testing::OwnStudio studio(std::move(scene));
    const auto& [of, accelerator, workers] = studio.studio();
    Context context(accelerator, workers, {}, {});
    FaceRaster raster(of);
    constexpr int n = 48;
    const Vec3d light{0.1, -0.2, 0.3};
    for (int face = 0; face < faces_of_cube; ++face) {
        Image<float> rastered({n, n}), traced({n, n});
        raster.fill(light, face, context, rastered.view());
        reference().render_face(light, face, n, {0, 0, n, n}, context.tracer(0), traced.view());
        int off = 0;
        for (std::size_t i = 0; i < traced.pixels().size(); ++i) {
            const float a = rastered.pixels()[i], b = traced.pixels()[i];
            off += std::abs(a - b) > rounding_share * b ? 1 : 0;
        }
        EXPECT_LE(off, 2) << face << ": rims, where a rounding decides";
    }
}

TEST(SphereMap, HasItsPolesAndItsSeamWhereTheyAre) {
    constexpr int n = 16;
    EXPECT_LT(direction_in_sphere(5, 0, n).y, -0.99f);
    EXPECT_GT(direction_in_sphere(5, 2 * n - 1, n).y, 0.99f);
    const Vec3 first = direction_in_sphere(0, n, n), last = direction_in_sphere(4 * n - 1, n, n);
    EXPECT_LT(first.x, -0.99f);
    EXPECT_LT(last.x, -0.99f);
    EXPECT_LT(first.z, 0);
    EXPECT_GT(last.z, 0);
}

TEST(SphereMap, HasNoAcneAtPolesAndSeam) {
    constexpr int n = 32;
    for (std::uint64_t plane = 0; plane < 60; ++plane) {
        const Key key(plane);
        const Vec3 normal(
            glm::normalize(Vec3d(key.uniform(0), key.uniform(1), key.uniform(2)) - 0.5));
        SphereMap map{n, Image<float>({4 * n, 2 * n})};
        const auto distance = [&](const Vec3& d) {
            const float along = glm::dot(normal, d);
            return along > 0 ? 1 / along : std::numeric_limits<float>::infinity();
        };
        for (int y = 0; y < 2 * n; ++y) {
            for (int x = 0; x < 4 * n; ++x) {
                map.distance(x, y) = distance(direction_in_sphere(x, y, n));
            }
        }
        for (const Vec3& middle :
             {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(-1, 0, 0), Vec3(-1, 1, 0), Vec3(1, 0, 0)}) {
            for (std::uint64_t i = 0; i < 400; ++i) {
                const Key at = key.branch(i);
                const Vec3 d = glm::normalize(
                    middle + 0.3f * Vec3(Vec3d(at.uniform(0), at.uniform(1), at.uniform(2)) - 0.5));
                if (!(glm::dot(d, normal) > 0.05f)) continue;
                const Receiver receiver{d * distance(d), normal};
                float bias = 0, share = 0;
                sphere_bias({&receiver, 1}, n, {&bias, 1});
                bias *= 1.01f;
                sphere_shares(map, {&receiver, 1}, {&bias, 1}, false, {&share, 1});
                EXPECT_EQ(share, 1) << "at " << d.x << " " << d.y << " " << d.z;
                bias *= pcf_width;
                sphere_shares(map, {&receiver, 1}, {&bias, 1}, true, {&share, 1});
                EXPECT_EQ(share, 1) << "filtered";
            }
        }
    }
}

TEST(SphereMap, GoesRoundAtTheSeamAndOnOverThePole) {
    constexpr int n = 8;
    SphereMap map{n, Image<float>({4 * n, 2 * n}, 9)};
    for (int y = 0; y < 2 * n; ++y) map.distance(4 * n - 1, y) = 1;  // a meridian
    const auto seen_at = [&](int x, int y) {
        const Vec3 d = direction_in_sphere(x, y, n);
        const Receiver receiver{5.0f * d, d};
        const float bias = 0;
        float share = 0;
        sphere_shares(map, {&receiver, 1}, {&bias, 1}, true, {&share, 1});
        return share;
    };
    EXPECT_NEAR(seen_at(0, n), 6.0 / 9, 1e-6);
    EXPECT_NEAR(seen_at(4 * n - 2, n), 6.0 / 9, 1e-6);
    EXPECT_NEAR(seen_at(1, n), 1, 1e-6);
    EXPECT_NEAR(seen_at(2 * n - 1, 0), 8.0 / 9, 1e-6) << "the meridian goes on past the pole";
}

TEST(SoftShadows, AreAsWideAsTheLampAndTheBlockerMakeThem) {
    // A half-plane x < 0 at distance 2 along z, a receiving plane at 4, a lamp 0.5 wide: the
    // penumbra is 0.5 wide.
    constexpr int n = 512;
    CubeMap map{n, {}};
    Face& face = map.faces[4];
    face.window = {0, 0, n, n};
    face.distance = Image<float>({n, n});
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const double u = (2.0 * x + 1) / n - 1, v = (2.0 * y + 1) / n - 1;
            face.distance(x, y) =
                static_cast<float>((u < 0 ? 2 : 4) * std::sqrt(1 + u * u + v * v));
        }
    }
    const auto seen_at = [&](double x) {
        const Receiver receiver{Vec3(x, 0.3, 4), {0, 0, -1}};
        float bias = 0, share = 0;
        reference().bias({&receiver, 1}, n, {&bias, 1});
        soft_shares(map, 0.5, {&receiver, 1}, {&bias, 1}, {&share, 1});
        return share;
    };
    for (const double x : {-0.2, -0.1, 0.0, 0.1, 0.2}) {
        EXPECT_NEAR(seen_at(x), 0.5 + x / 0.5, 0.08) << x;
    }
    EXPECT_EQ(seen_at(-0.4), 0);
    EXPECT_EQ(seen_at(0.4), 1);
}

/// What a lamp of width 1 at height 1 sends past an edge above, seen from x: the share of its
/// points right of a line. Aligned with its columns.
double seen(const std::vector<LightPoint>& points, double edge) {
    double share = 0;
    for (const LightPoint& point : points) share += point.position.x > edge ? point.share : 0;
    return share;
}

struct Spread {
    double rmse = 0;
    std::size_t levels = 0;
    int longest_run = 0;  ///< of 2000 places side by side
};

Spread spread_of(int n, Pattern pattern) {
    Spread spread;
    constexpr int places = 2000, keys = 100;
    std::vector<LightPoint> points;
    for (std::uint64_t key = 0; key < keys; ++key) {
        reference().light_points({}, n, pattern, Key(key), points);
        std::set<long> levels;
        double before = -1;
        int run = 0;
        for (int i = 0; i < places; ++i) {
            const double edge = (i + 0.5) / places - 0.5, share = seen(points, edge);
            const double off = share - (0.5 - edge);
            spread.rmse += off * off / (places * keys);
            levels.insert(std::lround(share * n));
            run = share == before ? run + 1 : 1;
            before = share;
            spread.longest_run = std::max(spread.longest_run, run);
        }
        spread.levels = std::max(spread.levels, levels.size());
    }
    spread.rmse = std::sqrt(spread.rmse);
    return spread;
}

TEST(LightPoints, BandWhereTheyAreRegularAndConvergeFasterWhereTheyAreJittered) {
    const auto slope = [](Pattern pattern) {
        return std::log(spread_of(1024, pattern).rmse / spread_of(16, pattern).rmse) / std::log(64);
    };
    const Spread regular = spread_of(64, Pattern::regular),
                 jittered = spread_of(64, Pattern::jittered);
    std::printf(
        "64 points: regular %zu levels, longest run %d, rmse %.4f; jittered %zu, %d, %.4f\n",
        regular.levels, regular.longest_run, regular.rmse, jittered.levels, jittered.longest_run,
        jittered.rmse);
    std::printf("slopes: regular %.3f jittered %.3f random %.3f\n", slope(Pattern::regular),
                slope(Pattern::jittered), slope(Pattern::random));
    EXPECT_EQ(regular.levels, 9u) << "one more than the root: bands";
    EXPECT_EQ(regular.longest_run, 250);
    EXPECT_GT(jittered.levels, 40u);
    EXPECT_NEAR(slope(Pattern::jittered), -0.75, 0.1);
    EXPECT_NEAR(slope(Pattern::random), -0.5, 0.1);
}

}  // namespace
}  // namespace luch::techniques::shadow_map
