#include "framework/measure/bench_judge.h"

#include <gmock/gmock.h>

namespace luch {
namespace {

using ::testing::Contains;
using ::testing::Each;

/// A square around the z axis at z = 1, of two triangles that share a diagonal.
Mesh square() {
    Mesh mesh;
    mesh.positions = {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
    mesh.triangles.push_back({.position = {0, 1, 2}, .normal = {}, .uv = {}});
    mesh.triangles.push_back({.position = {0, 2, 3}, .normal = {}, .uv = {}});
    return mesh;
}

Ray ahead(double x, double y) {
    return {{x, y, 0}, {0, 0, 1}};
}

TEST(Judge, IsSureAwayFromTheRimAndOnAnEdgeInside) {
    EXPECT_EQ(judged(square(), 1, ahead(0.5, 0.25)).verdict, Verdict::hit);
    EXPECT_EQ(judged(square(), 1, ahead(0.5, 0.5)).verdict, Verdict::hit);
    EXPECT_EQ(judged(square(), 1, ahead(1.001, 0.5)).verdict, Verdict::miss);
    EXPECT_EQ(judged(square(), 0.25, ahead(0.5, 0.25)).verdict, Verdict::miss);
}

TEST(Judge, DoubtsAtTheRim) {
    EXPECT_EQ(judged(square(), 1, ahead(1, 0.5)).verdict, Verdict::doubtful);
    EXPECT_EQ(judged(square(), 1, ahead(1 + 1e-7, 0.5)).verdict, Verdict::doubtful);
    EXPECT_EQ(judged(square(), 0.25, ahead(0.25, 0.1)).verdict, Verdict::doubtful);
}

TEST(Judge, DoubtsAtTheEndsOfTheRayOnly) {
    Ray ray = ahead(0.5, 0.25);
    for (const auto& [t_min, t_max, verdict] :
         {std::tuple{0.0f, 1.0f, Verdict::doubtful}, std::tuple{0.0f, 1.001f, Verdict::hit},
          std::tuple{0.0f, 0.999f, Verdict::miss}, std::tuple{1.0f, 2.0f, Verdict::doubtful},
          std::tuple{1.001f, 2.0f, Verdict::miss}}) {
        ray.t_min = t_min;
        ray.t_max = t_max;
        EXPECT_EQ(judged(square(), 1, ray).verdict, verdict) << t_min << " " << t_max;
    }
}

TEST(Judge, NamesEveryTriangleThatMayBeTheNearest) {
    EXPECT_THAT(judged(square(), 1, ahead(0.5, 0.5)).nearest, Contains(0u));
    EXPECT_THAT(judged(square(), 1, ahead(0.5, 0.5)).nearest, Contains(1u));
    EXPECT_THAT(judged(square(), 1, ahead(0.5, 0.25)).nearest, Each(0u));
    Mesh twice = square();
    twice.triangles.push_back(twice.triangles[0]);
    EXPECT_THAT(judged(twice, 1, ahead(0.5, 0.25)).nearest, Contains(2u));
    for (Vec3& p : twice.positions) p.z = 2;
    twice.positions.insert(twice.positions.end(), {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}});
    twice.triangles.push_back({.position = {4, 5, 6}, .normal = {}, .uv = {}});
    EXPECT_THAT(judged(twice, 1, ahead(0.5, 0.25)).nearest, Each(3u));
}

}  // namespace
}  // namespace luch
