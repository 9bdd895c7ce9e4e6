#include "scenes/generator/teapot.h"

#include "framework/math/bounds.h"
#include "scenes/generator/newell.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace luch::assets {
namespace {

constexpr int segments = 6;

std::vector<Surface> pot() {
    return teapot(segments);
}

Vec3d face_normal(const Surface& s, const Surface::Triangle& t) {
    const Vec3d& a = s.points[t[0].point];
    return glm::cross(s.points[t[1].point] - a, s.points[t[2].point] - a);
}

/// How often each directed edge occurs.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed_edges(const Surface& s) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const Surface::Triangle& t : s.triangles) {
        for (int k = 0; k < 3; ++k) ++edges[{t[k].point, t[(k + 1) % 3].point}];
    }
    return edges;
}

std::size_t border_edges(const Surface& s) {
    const auto edges = directed_edges(s);
    return std::count_if(edges.begin(), edges.end(), [&](const auto& edge) {
        return !edges.contains({edge.first.second, edge.first.first});
    });
}

/// Points − edges + triangles: 1 for a disc, 0 for a tube.
int euler_characteristic(const Surface& s) {
    const std::size_t directed = directed_edges(s).size();
    const std::size_t edges = (directed + border_edges(s)) / 2;
    return static_cast<int>(s.points.size() + s.triangles.size()) - static_cast<int>(edges);
}

TEST(Newell, HasThirtyTwoPatchesAndTheirPublishedPoints) {
    std::size_t patches = 0;
    std::set<std::array<double, 3>> points;
    for (const Sheet& sheet : newell_teapot()) {
        patches += sheet.patches.size();
        for (const Patch& patch : sheet.patches) {
            for (const Patch::Row& row : patch.rows) {
                for (const Vec3d& p : row) points.insert({p.x + 0.0, p.y + 0.0, p.z + 0.0});
            }
        }
    }
    EXPECT_EQ(patches, 32u);
    // Of the 306 published points four, around the knob's top, belong to no patch, and twelve of
    // the foot stand twice in the list.
    EXPECT_EQ(points.size(), 306u - 4u - 12u);
    // Sums over those of the published list, taken from the list itself.
    Vec3d sum(0), squares(0);
    for (const auto& [x, y, z] : points) {
        sum += Vec3d(x, y, z);
        squares += Vec3d(x * x, y * y, z * z);
    }
    EXPECT_NEAR(sum.x, 15.275, 1e-9);
    EXPECT_NEAR(sum.y, 496.55625, 1e-9);
    EXPECT_NEAR(squares.x, 846.519196, 1e-9);
    EXPECT_NEAR(squares.y, 1127.1976171875, 1e-9);
    EXPECT_NEAR(squares.z, 269.032121, 1e-9);
}

TEST(Newell, NeighbouringPatchesMeetSmoothly) {
    for (const Sheet& sheet : newell_teapot()) {
        for (int i = 0; i < sheet.along * sheet.across; ++i) {
            const Patch& patch = sheet.patches[i];
            const int place = i % sheet.across;
            const Patch& beside = sheet.patches[i - place + (place + 1) % sheet.across];
            for (const double t : {0.1, 0.5, 0.9}) {
                EXPECT_EQ(patch.point(1, t), beside.point(0, t)) << sheet.name << i;
                EXPECT_GT(glm::dot(patch.normal(1, t), beside.normal(0, t)), 0.9999) << sheet.name;
            }
            if (i + sheet.across >= sheet.along * sheet.across) continue;
            const Patch& below = sheet.patches[i + sheet.across];
            for (const double t : {0.1, 0.5, 0.9}) {
                EXPECT_EQ(patch.point(t, 1), below.point(t, 0)) << sheet.name << i;
                EXPECT_GT(glm::dot(patch.normal(t, 1), below.normal(t, 0)), 0.999) << sheet.name;
            }
        }
    }
}

TEST(Teapot, HasAsManyTrianglesAsItsHeaderSays) {
    for (const int n : {1, 4, 10}) {
        std::size_t triangles = 0;
        for (const Surface& s : teapot(n)) triangles += s.triangles.size();
        EXPECT_EQ(triangles, 64u * n * n - 8u * n);
    }
}

TEST(Teapot, FillsTheBoxOfItsData) {
    Boxd box;
    for (const Surface& s : teapot(20)) {
        for (const Vec3d& p : s.points) box.grow(p);
    }
    EXPECT_DOUBLE_EQ(box.lo.x, -3);
    EXPECT_NEAR(box.hi.x, 3.434, 5e-4);
    EXPECT_DOUBLE_EQ(box.lo.y, 0);
    EXPECT_DOUBLE_EQ(box.hi.y, 3.15);
    EXPECT_DOUBLE_EQ(box.lo.z, -2);
    EXPECT_DOUBLE_EQ(box.hi.z, 2);
}

TEST(Teapot, HasUnitNormalsOnTheSideOfItsTriangles) {
    for (const Surface& s : pot()) {
        ASSERT_EQ(s.normals.size(), s.points.size());
        for (const Vec3d& n : s.normals) EXPECT_NEAR(glm::length(n), 1, 1e-12) << s.name;
        for (const Surface::Triangle& t : s.triangles) {
            const Vec3d face = face_normal(s, t);
            EXPECT_GT(glm::length(face), 0) << s.name;
            for (const auto corner : t) {
                EXPECT_GT(glm::dot(face, s.normals[corner.point]), 0) << s.name;
            }
        }
    }
}

TEST(Teapot, TurnsItsNormalsOutwards) {
    // One outer point decides for a whole surface, since its triangles are consistently oriented.
    const auto outermost = [](const Surface& s, const Vec3d& direction) {
        const auto by_reach = [&](const Vec3d& a, const Vec3d& b) {
            return glm::dot(a, direction) < glm::dot(b, direction);
        };
        const auto best = std::max_element(s.points.begin(), s.points.end(), by_reach);
        return glm::dot(s.normals[best - s.points.begin()], direction);
    };
    const auto surfaces = pot();
    EXPECT_GT(outermost(surfaces[0], {1, 0, 0}), 0.9);
    EXPECT_GT(outermost(surfaces[0], {0, -1, 0}), 0.9);
    EXPECT_GT(outermost(surfaces[1], {0, 1, 0}), 0.9);
    EXPECT_GT(outermost(surfaces[2], {-1, 0, 0}), 0.9);
    EXPECT_GT(outermost(surfaces[3], {1, 0, 0}), 0.5);
}

TEST(Teapot, HasTheLimitNormalAtItsPoles) {
    const auto surfaces = pot();
    EXPECT_EQ(surfaces[1].points.front(), Vec3d(0, 3.15, 0));
    EXPECT_EQ(surfaces[1].normals.front(), Vec3d(0, 1, 0));
    EXPECT_EQ(surfaces[0].points.back(), Vec3d(0, 0, 0));
    EXPECT_EQ(surfaces[0].normals.back(), Vec3d(0, -1, 0));
}

TEST(Teapot, HasNoCracks) {
    for (const Surface& s : pot()) {
        for (const auto& [edge, times] : directed_edges(s)) {
            EXPECT_EQ(times, 1) << s.name << " edge " << edge.first << ' ' << edge.second;
        }
    }
    const auto surfaces = pot();
    // Body and lid are discs with one open rim, handle and spout are tubes with two open ends.
    EXPECT_EQ(border_edges(surfaces[0]), 4u * segments);
    EXPECT_EQ(border_edges(surfaces[1]), 4u * segments);
    EXPECT_EQ(border_edges(surfaces[2]), 2u * 2 * segments);
    EXPECT_EQ(border_edges(surfaces[3]), 2u * 2 * segments);
    EXPECT_EQ(euler_characteristic(surfaces[0]), 1);
    EXPECT_EQ(euler_characteristic(surfaces[1]), 1);
    EXPECT_EQ(euler_characteristic(surfaces[2]), 0);
    EXPECT_EQ(euler_characteristic(surfaces[3]), 0);
}

TEST(Teapot, KeepsItsPointsApartAndItsUvsInTheUnitSquare) {
    for (const Surface& s : pot()) {
        std::set<std::array<double, 3>> places;
        for (const Vec3d& p : s.points) places.insert({p.x, p.y, p.z});
        EXPECT_EQ(places.size(), s.points.size()) << s.name;
        for (const Surface::Triangle& t : s.triangles) {
            const auto uv = [&](int k) { return s.uvs.at(t[k].uv); };
            const Vec2d b = uv(1) - uv(0), c = uv(2) - uv(0);
            EXPECT_GT(b.x * c.y - b.y * c.x, 0) << s.name << ": mirrored or empty in the texture";
            for (int k = 0; k < 3; ++k) {
                EXPECT_TRUE(uv(k).x >= 0 && uv(k).x <= 1 && uv(k).y >= 0 && uv(k).y <= 1);
            }
        }
    }
}

TEST(Teapot, WritesWavefrontText) {
    Surface corner{"corner", {{0, 0, 0}, {1.25, 0, 0}, {0, -0.000001, 2}}, {}, {{0, 1}}, {}};
    corner.normals.assign(3, {0, 1, 0});
    corner.triangles.push_back({{{0, 0}, {1, 0}, {2, 0}}});
    EXPECT_EQ(obj_text({corner, corner}, "two"),
              "# two\n"
              "o corner\nv 0 0 0\nv 1.25 0 0\nv 0 0 2\nvn 0 1 0\nvn 0 1 0\nvn 0 1 0\nvt 0 1\n"
              "f 1/1/1 2/1/2 3/1/3\n"
              "o corner\nv 0 0 0\nv 1.25 0 0\nv 0 0 2\nvn 0 1 0\nvn 0 1 0\nvn 0 1 0\nvt 0 1\n"
              "f 4/2/4 5/2/5 6/2/6\n");
}

}  // namespace
}  // namespace luch::assets
