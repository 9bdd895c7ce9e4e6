#include "framework/accel/accelerator.h"
#include "framework/math/rng.h"
#include "tests/testing/everything.h"
#include "tests/testing/meshes.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

// Single rays, packets and brute force give the same bits, at every level of the processor.
namespace luch {
namespace {

using testing::awkward_point;
using testing::random_point;

/// How the rays of a packet are chosen.
enum class Aim { coherent, random, awkward, along_axes, extreme };
constexpr Aim aims[] = {Aim::coherent, Aim::random, Aim::awkward, Aim::along_axes, Aim::extreme};

double extreme_number(Key key) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double inf = std::numeric_limits<double>::infinity();
    constexpr double numbers[] = {nan,   inf,  -inf, 0.0,   -0.0, 1e-310, 1e-45, -1e-39, 1e-30,
                                  1e-19, 1e19, 1e30, -1e38, 1e45, 1,      -1,    0.5,    0.25};
    return numbers[key.bits(0) % std::size(numbers)];
}

Vec3d direction_of(const Scene& scene, Aim aim, const Vec3d& origin, const Vec3d& ahead, int i,
                   Key key) {
    switch (aim) {
        case Aim::coherent:
            return ahead +
                   Vec3d(0.03 * (i % 4 + i / 16 % 4 * 4), 0.03 * (i / 4 % 4 + i / 64 * 4), 0);
        case Aim::random:
            return random_point(key.branch(1), 1);
        case Aim::awkward:
            return awkward_point(scene, key.branch(2)) - origin;
        case Aim::along_axes: {
            Vec3d d(0);
            d[key.bits(3) % 3] = key.bits(4) % 2 == 0 ? 1 : -1;
            if (key.bits(5) % 2 == 0) d[key.bits(6) % 3] = key.bits(4) % 2 == 0 ? 0.0 : -0.0;
            if (key.bits(5) % 3 == 0) d[key.bits(6) % 3] += key.uniform(7);
            return d;
        }
        case Aim::extreme:
            break;
    }
    if (i % 2 == 0) return awkward_point(scene, key.branch(2)) - origin;
    return {extreme_number(key.branch(8)), extreme_number(key.branch(9)),
            extreme_number(key.branch(10))};
}

RayPacket packet_of(const Scene& scene, Aim aim, Key key) {
    RayPacket rays;
    rays.origin = random_point(key.branch(0), 12);
    if (key.bits(1) % 4 == 0) rays.origin = awkward_point(scene, key.branch(2));
    if (aim == Aim::extreme && key.bits(3) % 8 == 0) rays.origin.y = extreme_number(key.branch(4));
    if (key.bits(5) % 4 == 0) rays.t_min = static_cast<float>(0.1 * key.uniform(6));
    if (aim == Aim::extreme && key.bits(7) % 8 == 0) {
        rays.t_min = static_cast<float>(extreme_number(key.branch(8)));
    }
    const Vec3d ahead = awkward_point(scene, key.branch(9)) - rays.origin;
    const int count = key.bits(10) % 3 == 0 ? 1 + static_cast<int>(key.bits(11) % 256) : 256;
    while (rays.count < count) {
        const Key own = key.branch(100 + rays.count);
        float t_max = std::numeric_limits<float>::infinity();
        if (own.bits(20) % 8 == 0) t_max = static_cast<float>(2 * own.uniform(21));
        if (aim == Aim::extreme && own.bits(20) % 8 == 1) {
            t_max = static_cast<float>(extreme_number(own.branch(22)));
        }
        rays.add(direction_of(scene, aim, rays.origin, ahead, rays.count, own), t_max);
    }
    return rays;
}

/// Compares packet, single rays and brute force; gives the number of hits.
int checked_hits(const Scene& scene, const Accelerator& accelerator, const RayPacket& rays) {
    WorkCounts work;
    HitPacket hits;
    std::array<std::uint8_t, RayPacket::capacity> blocked;
    accelerator.closest(rays, hits, work);
    accelerator.occluded(rays, blocked, work);
    int found = 0;
    for (int i = 0; i < rays.count; ++i) {
        const Ray ray = rays.ray(i);
        const Hit truth = closest_brute(scene, ray);
        EXPECT_EQ(hits.hit(i), truth) << "ray " << i;
        EXPECT_EQ(accelerator.closest(ray, work), truth) << "ray " << i;
        EXPECT_EQ(blocked[i] != 0, static_cast<bool>(truth)) << "ray " << i;
        EXPECT_EQ(accelerator.occluded(ray, work), static_cast<bool>(truth)) << "ray " << i;
        found += truth ? 1 : 0;
    }
    return found;
}

class Levels : public ::testing::TestWithParam<Isa> {};

TEST_P(Levels, FindTheHitsOfBruteForceInPacketsAndAloneHoweverTheRaysAreAimed) {
    const Scene scene = testing::bit_of_everything();
    const auto accelerator = build_accelerator(scene, GetParam());
    for (const Aim aim : aims) {
        int hits = 0;
        for (int i = 0; i < 30; ++i) {
            hits += checked_hits(
                scene, *accelerator,
                packet_of(scene, aim, Key(21).branch(static_cast<int>(aim)).branch(i)));
            ASSERT_FALSE(HasFailure()) << "aim " << static_cast<int>(aim) << ", packet " << i;
        }
        EXPECT_GT(hits, 500) << static_cast<int>(aim);
    }
}

TEST_P(Levels, AgreeOnTriangleSoupAndOnDuplicates) {
    Mesh soup = testing::triangle_soup(300, 0.5, Key(3));
    for (std::uint32_t i = 0; i < 300; i += 3) soup.triangles.push_back(soup.triangles[i]);
    Scene scene = testing::empty_scene();
    testing::add(scene, soup, Lambert{});
    testing::add(scene, soup, Lambert{});
    soup.cull_backfaces = true;
    testing::add(scene, soup, Lambert{}, Transform::translation({0.5, 0.25, 0}));
    const auto accelerator = build_accelerator(scene, GetParam());
    int hits = 0;
    for (const Aim aim : aims) {
        for (int i = 0; i < 12; ++i) {
            hits += checked_hits(
                scene, *accelerator,
                packet_of(scene, aim, Key(22).branch(static_cast<int>(aim)).branch(i)));
            ASSERT_FALSE(HasFailure()) << "aim " << static_cast<int>(aim) << ", packet " << i;
        }
    }
    EXPECT_GT(hits, 2000);
}

TEST_P(Levels, LeaveNoGapInAClosedMeshNearOrFarFromTheOrigin) {
    for (const Vec3d& centre : {Vec3d(0), Vec3d(148376, 1234, -223423)}) {
        Scene scene = testing::empty_scene();
        testing::add(scene, testing::uv_sphere(20, 30, 1), Lambert{},
                     Transform::translation(centre));
        const auto accelerator = build_accelerator(scene, GetParam());
        WorkCounts work;
        HitPacket hits;
        std::array<std::uint8_t, RayPacket::capacity> blocked;
        for (int i = 0; i < 120; ++i) {
            const Key key = Key(23).branch(i);
            RayPacket rays;
            rays.origin = centre + random_point(key.branch(0), 0.4);
            for (int r = 0; r < RayPacket::capacity; ++r) {
                const Key own = key.branch(r + 1);
                const Vec3d to =
                    i % 3 == 0 ? random_point(own, 1) : awkward_point(scene, own) - rays.origin;
                rays.add(to, std::numeric_limits<float>::infinity());
            }
            accelerator->closest(rays, hits, work);
            accelerator->occluded(rays, blocked, work);
            for (int r = 0; r < RayPacket::capacity; ++r) {
                ASSERT_TRUE(hits.hit(r)) << "packet " << i << ", ray " << r;
                ASSERT_TRUE(blocked[r]);
                ASSERT_TRUE(accelerator->closest(rays.ray(r), work));
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, Levels, ::testing::ValuesIn(usable_isas()),
                         [](const auto& level) { return std::string(to_string(level.param)); });

}  // namespace
}  // namespace luch
