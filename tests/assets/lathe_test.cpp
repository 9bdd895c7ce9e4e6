#include "scenes/generator/lathe.h"

#include "scenes/generator/masonry.h"
#include "scenes/generator/stationery.h"

#include <gtest/gtest.h>

#include <cmath>

namespace luch::assets {
namespace {

TEST(Lathe, TurnsACylinderThatLooksOutwards) {
    const Surface tube = lathe({{{2, 0}, {2, 1}, {2, 5}}}, 24).at(0);
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
}

TEST(Masonry, RepeatsTexturesAroundTheHallWithTheirTopUp) {
    for (const Surface& surface : wall()) {
        for (const auto& [a, b, c] : surface.triangles) {
            for (const auto& [point, uv] : {a, b, c}) {
                EXPECT_EQ(surface.uvs[uv].y, surface.points[point].y > 3 ? 0 : 1);
                EXPECT_GE(surface.uvs[uv].x, 0);
                EXPECT_LE(surface.uvs[uv].x, 12);
            }
        }
        EXPECT_EQ(surface.uvs.at(48).x, 12);
    }
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
