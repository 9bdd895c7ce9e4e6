#include "framework/accel/embree.h"

#include "framework/accel/accelerator.h"
#include "framework/base/error.h"
#include "framework/measure/bench_judge.h"
#include "tests/testing/everything.h"
#include "tests/testing/meshes.h"
#include "tests/testing/scenes.h"

#include <gmock/gmock.h>

// Embree as an oracle, and as a back end.
namespace luch {
namespace {

using testing::awkward_point;
using ::testing::HasSubstr;
using testing::random_point;
using ::testing::ThrowsMessage;

class Embree : public ::testing::Test {
 protected:
    void SetUp() override {
        if (!has_embree()) GTEST_SKIP() << "this build has no Embree (libembree-dev)";
    }
};

Scene scene_of(Mesh mesh, double scale) {
    mesh.from_frame = {};
    Scene scene = testing::empty_scene();
    testing::add(scene, std::move(mesh), Lambert{}, Transform::scaling(Vec3d(scale)));
    return scene;
}

/// Rays from about a mesh to anywhere in it, corners and edges of triangles among them. Their
/// numbers are floats.
std::vector<Ray> rays_about(const Scene& scene, double scale, int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const Key key = Key(31).branch(i);
        const Vec3d origin = scale * random_point(key.branch(0), 1.5);
        const Vec3d to = i % 4 == 0 ? awkward_point(scene, key.branch(1))
                                    : scale * random_point(key.branch(2), 0.5);
        rays.push_back({Vec3d(Vec3(origin)), Vec3d(Vec3(to - origin))});
        if (i % 8 == 1) rays.back().t_max = static_cast<float>(key.uniform(3));
    }
    return rays;
}

struct Agreement {
    int hits = 0, same = 0;
    int wrong = 0;  ///< of luch or Embree, where the judge has no doubt
    int doubts = 0;
};

Agreement agreement(const Scene& scene, double scale, const std::vector<Ray>& rays) {
    const Mesh& mesh = std::get<Mesh>(scene.geometries[0]);
    const auto own = build_accelerator(scene);
    const EmbreeScene peer(mesh, static_cast<float>(scale), true, parsed_isa(""));
    const auto batch = peer.batch(rays, EmbreeMode::single, false);
    batch->reset();
    batch->shoot(0, rays.size(), false);
    WorkCounts work;
    Agreement sum;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Hit ours = own->closest(rays[i], work), theirs = batch->hit(i);
        sum.hits += ours ? 1 : 0;
        const bool both = static_cast<bool>(ours) == static_cast<bool>(theirs);
        if (both && ours.primitive == theirs.primitive) {
            sum.same += ours ? 1 : 0;
            continue;
        }
        const Judgement truth = judged(mesh, scale, rays[i]);
        if (!both) {
            ++(truth.verdict == Verdict::doubtful ? sum.doubts : sum.wrong);
        } else if (std::ranges::count(truth.nearest, ours.primitive) == 0) {
            ++sum.wrong;
        }
    }
    return sum;
}

TEST_F(Embree, MeetsTheTrianglesThatWeMeetAtEveryScale) {
    const Mesh meshes[] = {testing::uv_sphere(60, 90, 1),
                           testing::triangle_soup(2000, 0.2, Key(4))};
    for (const Mesh& mesh : meshes) {
        for (const double scale : {0x1p-10, 1.0, 0x1p10}) {
            const Scene scene = scene_of(mesh, scale);
            const Agreement found = agreement(scene, scale, rays_about(scene, scale, 10'000));
            EXPECT_GT(found.hits, 3000);
            EXPECT_EQ(found.wrong, 0) << "of " << found.hits << " at scale " << scale;
            EXPECT_LE(found.doubts, found.hits / 100) << "rims, at scale " << scale;
            EXPECT_GT(found.same, 0.85 * found.hits) << "edges and corners are a quarter";
        }
    }
}

TEST_F(Embree, AgreesOnTheTriangleForRaysThatAreAimedAtNothingInParticular) {
    const Scene scene = scene_of(testing::uv_sphere(100, 150, 1), 1);
    std::vector<Ray> rays;
    for (int i = 0; i < 50'000; ++i) {
        const Key key = Key(32).branch(i);
        rays.push_back({Vec3d(Vec3(random_point(key.branch(0), 0.2))),
                        Vec3d(Vec3(random_point(key.branch(1), 1)))});
    }
    rays.resize(rays.size() / 16 * 16);
    const Agreement found = agreement(scene, 1, rays);
    EXPECT_EQ(found.hits, static_cast<int>(rays.size()));
    EXPECT_EQ(found.wrong + found.doubts, 0);
    EXPECT_GE(found.same, 0.9999 * found.hits);
}

/// Rays of one origin for packets, some of them short, extreme or no rays at all. `aimed`: at
/// corners and edges.
RayPacket packet_about(const Scene& scene, bool aimed, Key key) {
    RayPacket rays;
    rays.origin = random_point(key.branch(0), 12);
    if (key.bits(1) % 4 == 0) rays.t_min = static_cast<float>(0.2 * key.uniform(2));
    while (rays.count < 200) {
        const Key own = key.branch(10 + rays.count);
        Vec3d direction = awkward_point(scene, own.branch(0)) - rays.origin;
        if (!aimed) direction += random_point(own.branch(2), 0.5);
        if (own.bits(3) % 16 == 0) direction *= own.bits(4) % 2 == 0 ? 1e-30 : 1e30;
        if (own.bits(3) % 16 == 1) direction[own.bits(4) % 3] = 0;
        if (own.bits(3) % 64 == 2) direction *= std::numeric_limits<double>::quiet_NaN();
        const bool is_short = own.bits(5) % 8 == 0;
        rays.add(direction, is_short ? static_cast<float>(1.5 * own.uniform(6))
                                     : std::numeric_limits<float>::infinity());
    }
    return rays;
}

/// Equal, or two triangles at a distance.
bool like(const Hit& a, const Hit& b) {
    if (a == b) return true;
    if (static_cast<bool>(a) != static_cast<bool>(b)) return false;
    return a && std::abs(a.t - b.t) <= 1e-5f * a.t;
}

struct Differences {
    int hits = 0;
    int other = 0;   ///< hits that are not the same
    int unlike = 0;  ///< those that are not about the same distance, or hit and miss
};

Differences differences(bool aimed) {
    const Scene scene = testing::bit_of_everything();
    const auto ours = build_accelerator(scene);
    const auto theirs = build_accelerator(scene, parsed_isa(""), Backend::embree);
    WorkCounts work;
    HitPacket hits;
    std::array<std::uint8_t, RayPacket::capacity> blocked;
    Differences sum;
    for (int i = 0; i < 150; ++i) {
        const RayPacket rays = packet_about(scene, aimed, Key(33).branch(i));
        theirs->closest(rays, hits, work);
        theirs->occluded(rays, blocked, work);
        for (int r = 0; r < rays.count; ++r) {
            const Hit truth = ours->closest(rays.ray(r), work);
            for (const Hit& hit : {theirs->closest(rays.ray(r), work), hits.hit(r)}) {
                sum.other += hit == truth ? 0 : 1;
                sum.unlike += like(hit, truth) ? 0 : 1;
            }
            for (const bool any : {theirs->occluded(rays.ray(r), work), blocked[r] != 0}) {
                sum.unlike += any == static_cast<bool>(truth) ? 0 : 1;
            }
            sum.hits += truth ? 1 : 0;
        }
    }
    return sum;
}

TEST_F(Embree, AsABackEndGivesTheSameHitsInPacketsAndAlone) {
    const Differences sum = differences(false);
    EXPECT_GT(sum.hits, 10'000);
    EXPECT_EQ(sum.other, 0);
    EXPECT_EQ(sum.unlike, 0);
}

TEST_F(Embree, AsABackEndMayDifferWhereRaysAreAimedAtEdgesAndRimsAlone) {
    const Differences sum = differences(true);
    EXPECT_GT(sum.hits, 10'000);
    EXPECT_LE(sum.other, sum.hits / 50);
    EXPECT_LE(sum.unlike, sum.hits / 200);
}

TEST_F(Embree, AsABackEndPassesBackfacesThatAreCulled) {
    Scene scene = testing::empty_scene();
    Mesh mesh = testing::triangle({-1, -1, 5}, {1, -1, 5}, {0, 1, 5});
    mesh.cull_backfaces = true;
    testing::add(scene, mesh, Lambert{});
    const auto theirs = build_accelerator(scene, parsed_isa(""), Backend::embree);
    WorkCounts work;
    EXPECT_FALSE(theirs->closest({{0, 0, 0}, {0, 0, 1}}, work));
    EXPECT_FALSE(theirs->occluded({{0, 0, 0}, {0, 0, 1}}, work));
    EXPECT_TRUE(theirs->closest({{0, 0, 9}, {0, 0, -1}}, work));
    EXPECT_TRUE(theirs->occluded({{0, 0, 9}, {0, 0, -1}}, work));

    RayPacket rays;
    rays.add({0, 0, 1}, std::numeric_limits<float>::infinity());
    HitPacket hits;
    std::array<std::uint8_t, RayPacket::capacity> blocked;
    theirs->closest(rays, hits, work);
    theirs->occluded(rays, blocked, work);
    EXPECT_FALSE(hits.hit(0));
    EXPECT_EQ(blocked[0], 0);
}

TEST_F(Embree, AsABackEndFindsWhatLiesBehindABackfaceThatIsCulled) {
    Mesh mesh =
        testing::mesh_of({{-1, -1, 5}, {1, -1, 5}, {0, 1, 5}, {-1, -1, 7}, {1, -1, 7}, {0, 1, 7}},
                         {0, 1, 2, 3, 5, 4});
    mesh.cull_backfaces = true;
    Scene scene = testing::empty_scene();
    testing::add(scene, mesh, Lambert{});
    const auto theirs = build_accelerator(scene, parsed_isa(""), Backend::embree);
    WorkCounts work;
    RayPacket rays;
    rays.add({0, 0, 1}, std::numeric_limits<float>::infinity());
    HitPacket hits;
    theirs->closest(rays, hits, work);
    for (const Hit& hit : {theirs->closest(rays.ray(0), work), hits.hit(0)}) {
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit.primitive, 1u);
    }
}

TEST_F(Embree, AsABackEndFindsTheHitsOfSolids) {
    Scene scene = testing::empty_scene();
    scene.geometries.emplace_back(testing::uv_sphere(10, 14, 1));
    scene.geometries.emplace_back(Cube{.centre = {0.5, 0, 0}, .side = 1});
    testing::add(scene, make_csg(Csg::Operation::subtract, 0, 1, scene.geometries), Lambert{});
    const auto ours = build_accelerator(scene);
    const auto theirs = build_accelerator(scene, parsed_isa(""), Backend::embree);
    WorkCounts work;
    for (int i = 0; i < 2000; ++i) {
        const Ray ray{random_point(Key(34).branch(i), 3), random_point(Key(35).branch(i), 1)};
        ASSERT_EQ(theirs->closest(ray, work), ours->closest(ray, work)) << i;
    }
}

TEST(Backend, IsOneOfTwoOrAnError) {
    EXPECT_EQ(parsed_backend("luch"), Backend::luch);
    EXPECT_THAT([] { parsed_backend("embre"); },
                ThrowsMessage<Error>(HasSubstr("--backend embre: did you mean embree or luch?")));
    if (has_embree()) {
        EXPECT_EQ(parsed_backend("embree"), Backend::embree);
    } else {
        EXPECT_THAT([] { parsed_backend("embree"); },
                    ThrowsMessage<Error>(HasSubstr("install libembree-dev")));
    }
}

}  // namespace
}  // namespace luch
