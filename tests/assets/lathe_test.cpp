#include "scenes/generator/lathe.h"

#include <gtest/gtest.h>

#include <cmath>

namespace luch::assets {
namespace {

TEST(Lathe, TurnsACylinderThatLooksOutwards) {
    const Profile profiles[] = {{"tube", {{2, 0}, {2, 1}, {2, 5}}, {3, 2}}};
    const Surface tube = turned(profiles, 24).at(0);
    EXPECT_EQ(tube.triangles.size(), 2u * 2 * 24);
    for (std::size_t i = 0; i < tube.points.size(); ++i) {
        EXPECT_NEAR(std::hypot(tube.points[i].x, tube.points[i].z), 2, 1e-12);
        EXPECT_NEAR(glm::dot(tube.normals[i], tube.points[i]), 2, 1e-12);
    }
    for (const auto& [a, b, c] : tube.triangles) {
        const Vec3d p = tube.points[a.point];
        const Vec3d face = glm::cross(tube.points[b.point] - p, tube.points[c.point] - p);
        EXPECT_GT(glm::dot(face, tube.normals[a.point]), 0);
    }
    EXPECT_EQ(tube.uvs.front(), Vec2d(0, 2));
    EXPECT_EQ(tube.uvs.back(), Vec2d(3, 0));
    EXPECT_NEAR(tube.uvs[25].y, 2 * (1 - 0.2), 1e-12) << "v follows the profile's length";
}

TEST(Lathe, LeavesOutTheTrianglesOfAPoint) {
    const Profile profiles[] = {{"cone", {{1, 0}, {0, 1}}}};
    EXPECT_EQ(turned(profiles, 10).at(0).triangles.size(), 10u);
}

TEST(OpenBook, BulgesBesideTheMiddleWithItsNormalsAcrossThePaper) {
    const Surface book = open_book().at(0);
    double deepest = 0;
    for (std::size_t i = 0; i + 1 < book.points.size() / 2; ++i) {
        deepest = std::min(deepest, book.points[i].z);
        const Vec3d along = book.points[i + 1] - book.points[i];
        const Vec3d normal = glm::normalize(book.normals[i] + book.normals[i + 1]);
        const bool fold =
            std::abs(book.points[i].x) < 0.01 || std::abs(along.x + book.points[i].x) < 0.01;
        if (fold) continue;
        EXPECT_NEAR(glm::dot(glm::normalize(along), normal), 0, 0.03) << i;
    }
    EXPECT_NEAR(deepest, -2, 0.02);
    EXPECT_EQ(book.uvs.front(), Vec2d(0, 1));
    EXPECT_EQ(book.uvs.back(), Vec2d(1, 0));
    for (const auto& [a, b, c] : book.triangles) {
        const Vec3d p = book.points[a.point];
        const Vec3d face = glm::cross(book.points[b.point] - p, book.points[c.point] - p);
        EXPECT_GT(glm::dot(face, book.normals[a.point]), 0);
    }
}

}  // namespace
}  // namespace luch::assets
