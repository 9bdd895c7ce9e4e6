#include "framework/math/transform.h"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

namespace luch {
namespace {

constexpr double right_angle = std::numbers::pi / 2;

void expect_near(const Vec3d& a, const Vec3d& b, double tolerance = 1e-12) {
    EXPECT_LE(max_norm(a - b), tolerance)
        << a.x << " " << a.y << " " << a.z << " is not " << b.x << " " << b.y << " " << b.z;
}

// A row vector times [c 0 s; 0 1 0; −s 0 c] with a = 90°: z = (0, 0, 1) becomes (−1, 0, 0).
TEST(Rotation, ByYawTurnsForwardToTheLeft) {
    expect_near(Transform::rotation(right_angle, 0, 0).direction({0, 0, 1}), {-1, 0, 0});
}

// Times [1 0 0; 0 c −s; 0 s c]: z becomes y.
TEST(Rotation, ByPitchTurnsForwardUp) {
    expect_near(Transform::rotation(0, right_angle, 0).direction({0, 0, 1}), {0, 1, 0});
}

// Times [c −s 0; s c 0; 0 0 1]: x becomes −y.
TEST(Rotation, ByRollTurnsRightDown) {
    expect_near(Transform::rotation(0, 0, right_angle).direction({1, 0, 0}), {0, -1, 0});
}

TEST(Rotation, RollsFirstThenPitchesThenYaws) {
    const Transform all = Transform::rotation(0.3, 0.5, 0.7);
    const Transform in_turn = Transform::rotation(0, 0, 0.7)
                                  .then(Transform::rotation(0, 0.5, 0))
                                  .then(Transform::rotation(0.3, 0, 0));
    for (const Vec3d v : {Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)}) {
        expect_near(all.direction(v), in_turn.direction(v));
    }
}

TEST(Transform, AppliesTheFirstBeforeTheNext) {
    const Transform moved_then_scaled =
        Transform::translation({1, 0, 0}).then(Transform::scaling(Vec3d(2)));
    expect_near(moved_then_scaled.point({1, 1, 1}), {4, 2, 2});
}

TEST(Transform, IsUndoneByItsInverse) {
    const Transform t = Transform::scaling({2, 0.5, -3})
                            .then(Transform::rotation(1, 2, 3))
                            .then(Transform::translation({5, -6, 7}));
    expect_near(t.inverse().point(t.point({1, 2, 3})), {1, 2, 3});
}

TEST(Transform, IsInvertedAtExtremeScales) {
    for (const double scale : {1e-30, 1e-8, 1e8, 1e30}) {
        const Transform t = Transform::scaling(Vec3d(scale)).then(Transform::rotation(1, 2, 3));
        expect_near(t.inverse().point(t.point({1, 2, 3})), {1, 2, 3});
    }
}

TEST(Transform, RefusesToInvertWhatIsFlat) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Vec3d scale : {Vec3d(1, 0, 1), Vec3d(0), Vec3d(1, 1e-17, 1), Vec3d(1, nan, 1)}) {
        EXPECT_THROW((void)Transform::scaling(scale).inverse(), std::domain_error);
    }
}

TEST(Transform, KeepsNormalsPerpendicular) {
    const Transform t = Transform::scaling({1, 5, 1}).then(Transform::rotation(0.4, 0.2, 0.1));
    const Vec3d normal = t.inverse().normal_back({1, 1, 0});
    EXPECT_NEAR(glm::dot(normal, t.direction({1, -1, 0})), 0, 1e-12);
    EXPECT_NEAR(glm::dot(normal, t.direction({0, 0, 1})), 0, 1e-12);
}

TEST(Transform, LeavesTheParameterOfARayAlone) {
    const Transform t = Transform::scaling({2, 3, 4}).then(Transform::translation({1, 1, 1}));
    const Ray ray{{1, 2, 3}, {1, 0, -1}, 0.5f, 9};
    const Ray moved = t.ray(ray);
    expect_near(moved.at(2.5), t.point(ray.at(2.5)));
    EXPECT_EQ(moved.t_min, ray.t_min);
    EXPECT_EQ(moved.t_max, ray.t_max);
}

TEST(Transform, BoxesHoldTheirMovedCorners) {
    const Boxd box{{-1, 0, 2}, {1, 4, 3}};
    const Transform t = Transform::rotation(1, 2, 3).then(Transform::translation({1, 2, 3}));
    Boxd corners;
    for (int i = 0; i < 8; ++i) {
        corners.grow(t.point({i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y,
                              i & 4 ? box.hi.z : box.lo.z}));
    }
    expect_near(t.box(box).lo, corners.lo);
    expect_near(t.box(box).hi, corners.hi);
}

TEST(Transform, KeepsInfiniteBoxesFreeOfNan) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Boxd plane{{-infinity, 0, -infinity}, {infinity, 0, infinity}};
    const Boxd moved = Transform::translation({0, 3, 0}).box(plane);
    EXPECT_EQ(moved.lo, Vec3d(-infinity, 3, -infinity));
    EXPECT_EQ(moved.hi, Vec3d(infinity, 3, infinity));
}

}  // namespace
}  // namespace luch
