#include "framework/math/rng.h"
#include "techniques/vista/vista.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <numbers>

namespace luch::techniques::vista {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Vec3d random_vector(Key key) {
    return {2 * key.uniform(0) - 1, 2 * key.uniform(1) - 1, 2 * key.uniform(2) - 1};
}

/// How many of the triangles (in view space) cover each pixel, when each goes through clip, project
/// and rasterise alone.
Image<int> coverage(const std::vector<Tri>& triangles, const Screen& screen) {
    const Size size = screen.size();
    Image<int> count(size);
    std::vector<Tri> inside;
    for (const Tri& triangle : triangles) {
        reference().clip({&triangle, 1}, frustum_of(screen), inside);
        std::vector<ScreenTri> on_screen(inside.size());
        reference().project(inside, screen, on_screen);
        for (const ScreenTri& part : on_screen) {
            Image<NodeId> ids(size);
            Image<float> depth(size);
            reference().rasterise({&part, 1}, ids.view().tile(), Hidden::painter, ids.view(),
                                  depth.view());
            for (std::size_t i = 0; i < count.pixels().size(); ++i) {
                count.pixels()[i] += ids.pixels()[i] != no_node;
            }
        }
    }
    return count;
}

std::vector<Tri> tessellated(const Geometry& geometry, int n) {
    std::vector<Tri> triangles{Tri{}};  // what was in the vector must not matter
    reference().tessellate(geometry, n, triangles);
    for (Tri& triangle : triangles) triangle.node = 1;
    return triangles;
}

void expect_covered_once(const std::vector<Tri>& triangles, const Screen& screen) {
    const Image<int> count = coverage(triangles, screen);
    for (int y = 0; y < count.height(); ++y) {
        for (int x = 0; x < count.width(); ++x) ASSERT_EQ(count(x, y), 1) << x << ", " << y;
    }
}

TEST(VistaLod, KeepsTheChordWithinAnEighthOfAPixel) {
    for (const float radius : {1.0f, 3.0f, 10.0f, 50.0f, 150.0f}) {
        const int n = reference().lod(Sphere{}, radius);
        EXPECT_LE(radius * (1 - std::cos(std::numbers::pi / n)), 0.125) << radius;
        // And no rounder than need be: n is even, so two segments fewer would be too few.
        EXPECT_GT(radius * (1 - std::cos(std::numbers::pi / (n - 2))), 0.12) << radius;
        EXPECT_EQ(n % 2, 0);
    }
}

TEST(VistaLod, StaysWithinItsRange) {
    EXPECT_EQ(reference().lod(Sphere{}, 1e-9f), least_segments);
    EXPECT_EQ(reference().lod(Sphere{}, std::numeric_limits<float>::infinity()), most_segments);
}

TEST(VistaLod, AsksNothingOfOtherShapes) {
    EXPECT_EQ(reference().lod(Plane{}, 50), 0);
    EXPECT_EQ(reference().lod(Cube{}, 50), 0);
    EXPECT_EQ(reference().lod(Mesh{}, 50), 0);
}

/// Every edge belongs to two triangles whose corners agree to the last bit.
void expect_closed(const std::vector<Tri>& triangles) {
    const auto less = [](const Vec3d& a, const Vec3d& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    };
    const auto edge_less = [&](const auto& a, const auto& b) {
        if (less(a.first, b.first) || less(b.first, a.first)) return less(a.first, b.first);
        return less(a.second, b.second);
    };
    std::map<std::pair<Vec3d, Vec3d>, int, decltype(edge_less)> edges(edge_less);
    for (const Tri& triangle : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3d a = triangle.corners[k].p, b = triangle.corners[(k + 1) % 3].p;
            ++edges[less(a, b) ? std::pair(a, b) : std::pair(b, a)];
        }
    }
    for (const auto& [edge, count] : edges) EXPECT_EQ(count, 2);
}

TEST(VistaTessellate, MakesAClosedPolyhedronOnTheSphere) {
    const Sphere sphere{.centre = {1, -2, 3}, .radius = 2.5};
    for (const int n : {4, 6, 8, 32}) {
        const std::vector<Tri> triangles = tessellated(sphere, n);
        EXPECT_EQ(triangles.size(), static_cast<std::size_t>(2 * n * (n / 2 - 1)));
        expect_closed(triangles);
        for (const Tri& triangle : triangles) {
            for (const Corner& corner : triangle.corners) {
                EXPECT_NEAR(glm::distance(corner.p, sphere.centre), 2.5, 1e-14);
                EXPECT_EQ(corner.w, 1);
            }
        }
    }
}

TEST(VistaTessellate, MakesAClosedCube) {
    const std::vector<Tri> triangles = tessellated(Cube{.centre = {1, 2, 3}, .side = 4}, 0);
    EXPECT_EQ(triangles.size(), 12u);
    expect_closed(triangles);
    double area = 0;
    for (const Tri& triangle : triangles) {
        const auto& [a, b, c] = triangle.corners;
        area += glm::length(glm::cross(b.p - a.p, c.p - a.p)) / 2;
        for (const Corner& corner : triangle.corners) {
            EXPECT_EQ(glm::abs(corner.p - Vec3d(1, 2, 3)), Vec3d(2));
        }
    }
    EXPECT_DOUBLE_EQ(area, 6 * 16);
}

TEST(VistaClip, KeepsWhatIsInsideBitForBit) {
    const Screen screen(Camera{}, {64, 48});
    const std::vector<Tri> triangles{{{{{{0.1, 0.2, 3}}, {{-0.3, 0.1, 2}}, {{0, 0, 7}}}}, 4}};
    std::vector<Tri> inside{Tri{}};
    reference().clip(triangles, frustum_of(screen), inside);
    EXPECT_EQ(inside, triangles);
}

TEST(VistaClip, DropsWhatIsBesideOrBehind) {
    const Screen screen(Camera{}, {64, 48});
    const std::vector<Tri> triangles{{{{{{90, 0, 1}}, {{91, 0, 2}}, {{90, 1, 1}}}}, 4},
                                     {{{{{-1, -1, -4}}, {{1, -1, -4}}, {{0, 1, -4}}}}, 4}};
    std::vector<Tri> inside{Tri{}};
    reference().clip(triangles, frustum_of(screen), inside);
    EXPECT_TRUE(inside.empty());
}

TEST(VistaClip, CutsACommonEdgeInOnePoint) {
    const Screen screen(Camera{}, {64, 48});
    for (int i = 0; i < 1000; ++i) {
        const Key key(i);
        const Corner in{0.5 * random_vector(key.branch(0)) + Vec3d(0, 0, 3)};
        const Corner out{0.5 * random_vector(key.branch(1)) + Vec3d(9, 0, 3)};
        const Corner left{0.5 * random_vector(key.branch(2)) + Vec3d(0, 0.9, 3)};
        const Corner right{0.5 * random_vector(key.branch(3)) + Vec3d(0, -0.9, 3)};
        std::vector<Tri> of_left, of_right;
        reference().clip(std::vector{Tri{{in, out, left}, 0}}, frustum_of(screen), of_left);
        reference().clip(std::vector{Tri{{out, in, right}, 0}}, frustum_of(screen), of_right);
        std::vector<Corner> common;
        for (const Tri& a : of_left) {
            for (const Corner& corner : a.corners) {
                const bool known = std::find(common.begin(), common.end(), corner) != common.end();
                for (const Tri& b : of_right) {
                    if (known ||
                        std::find(b.corners.begin(), b.corners.end(), corner) == b.corners.end())
                        continue;
                    common.push_back(corner);
                    break;
                }
            }
        }
        ASSERT_EQ(common.size(), 2u) << "edge " << i << ": its inner end, and the point of the cut";
    }
}

TEST(VistaClip, CutsPointsAtInfinityInTheirPlane) {
    const Screen screen(Camera{}, {64, 48});
    // The plane y = −2, a quarter of it, seen from above its origin.
    const Tri quarter{{{{{0, -2, 0}}, {{1, 0, 0}, 0}, {{0, 0, 1}, 0}}}, 0};
    std::vector<Tri> inside;
    reference().clip({&quarter, 1}, frustum_of(screen), inside);
    EXPECT_GE(inside.size(), 1u);
    for (const Tri& triangle : inside) {
        for (const auto& [p, w] : triangle.corners) EXPECT_NEAR(p.y, -2 * w, 1e-15);
    }
}

/// The smallest of the three edge functions of a ray through the eye, by the size of their parts;
/// positive inside, whichever way the triangle is wound; negative also when the triangle is behind.
double inside_by(const Tri& triangle, const Vec3d& d) {
    const auto& [a, b, c] = triangle.corners;
    const double volume = glm::dot(glm::cross(a.p, b.p), c.p);
    double least = infinity;
    for (const auto& [p, q] : {std::pair(a.p, b.p), {b.p, c.p}, {c.p, a.p}}) {
        const Vec3d normal = glm::cross(p, q);
        const double sign = volume > 0 ? 1 : -1;
        least = std::min(least, sign * glm::dot(normal, d) / glm::length(normal));
    }
    return least;
}

TEST(VistaClip, ShowsATriangleAroundTheEyeWhereRaysHitIt) {
    const Screen screen(Camera{.fov_deg = 100}, {40, 30});
    int covered = 0, behind = 0;
    for (int i = 0; i < 2000; ++i) {
        Tri triangle{{}, 1};
        for (std::size_t k = 0; k < 3; ++k) {
            triangle.corners[k].p = 5.0 * random_vector(Key(i).branch(k));
        }
        const bool any_behind = std::min({triangle.corners[0].p.z, triangle.corners[1].p.z,
                                          triangle.corners[2].p.z}) < 0;
        const Image<int> count = coverage({triangle}, screen);
        for (int y = 0; y < 30; ++y) {
            for (int x = 0; x < 40; ++x) {
                const double by = inside_by(triangle, screen.ray(x + 0.5, y + 0.5).direction);
                if (std::abs(by) < 1e-5) continue;
                ASSERT_EQ(count(x, y), by > 0 ? 1 : 0)
                    << "triangle " << i << " at " << x << ", " << y;
                covered += by > 0;
                behind += by > 0 && any_behind;
            }
        }
    }
    EXPECT_GT(covered, 1000);
    EXPECT_GT(behind, 1000);
}

TEST(VistaClip, LeavesNoCrackInASphereAroundTheEye) {
    for (const int n : {4, 8, 18}) {
        for (int i = 0; i < 6; ++i) {
            const Vec3d centre = 0.3 * random_vector(Key(i));
            const Screen screen(Camera{.fov_deg = 20.0 + 28 * i}, {37, 29});
            expect_covered_once(tessellated(Sphere{.centre = centre}, n), screen);
        }
    }
    expect_covered_once(tessellated(Cube{.centre = {0.1, 0.2, 0.3}}, 0),
                        Screen(Camera{}, {40, 30}));
}

TEST(VistaClip, LosesNothingOfAnInfinitePlane) {
    for (int i = 0; i < 40; ++i) {
        const Key key(i);
        const Camera camera{.position = {1e3 * key.uniform(0), 1 + key.uniform(1), 3},
                            .yaw_deg = 360 * key.uniform(2),
                            .pitch_deg = 180 * key.uniform(3) - 90,
                            .roll_deg = 360 * key.uniform(4),
                            .fov_deg = 20 + 120 * key.uniform(5)};
        const Screen screen(camera, {40, 30});
        std::vector<Tri> plane = tessellated(Plane{.y = -2}, 0);
        for (Tri& triangle : plane) {
            for (auto& [p, w] : triangle.corners) {
                p = w > 0 ? screen.to_view(p) : camera.to_world().normal_back(p);
            }
        }
        const Image<int> count = coverage(plane, screen);
        for (int y = 0; y < 30; ++y) {
            for (int x = 0; x < 40; ++x) {
                const double down = -screen.ray(x + 0.5, y + 0.5).direction.y;
                if (std::abs(down) < 1e-6) continue;
                ASSERT_EQ(count(x, y), down > 0 ? 1 : 0)
                    << "camera " << i << " at " << x << ", " << y;
            }
        }
    }
}

TEST(VistaSort, PutsTheFarthestCornerFirst) {
    const auto at = [](double z, NodeId node, double w = 1) {
        return Tri{{{{{0, 0, 1}}, {{0, 1, 1}}, {{0, 0, z}, w}}}, node};
    };
    std::vector<Tri> triangles{at(3, 0), at(9, 1), at(3, 2), at(1, 3, 0), at(4, 4, 0.25)};
    reference().sort(triangles);
    std::vector<NodeId> order;
    for (const Tri& triangle : triangles) order.push_back(triangle.node);
    EXPECT_EQ(order, (std::vector<NodeId>{3, 4, 1, 0, 2}));
}

TEST(VistaProject, IsTheInverseOfTheCamerasRay) {
    const Camera camera{.position = {100, -20, 3}, .yaw_deg = 33, .pitch_deg = -12, .roll_deg = 71};
    const Size size{641, 7};
    const Screen screen(camera, size);
    for (int i = 0; i < 300; ++i) {
        const Key key(i);
        const Vec2d px{size.width * key.uniform(0), size.height * key.uniform(1)};
        Corner corner{screen.to_view(screen.ray(px.x, px.y).at(1 + 50 * key.uniform(2)))};
        const double z = corner.p.z;
        ScreenTri image;
        reference().project(std::vector{Tri{{corner, corner, corner}, 3}}, screen, {&image, 1});
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(image.px[k].x, px.x, 0.51 * pixel_grid(size));
            EXPECT_NEAR(image.px[k].y, px.y, 0.51 * pixel_grid(size));
            EXPECT_DOUBLE_EQ(image.inverse_depth[k], 1 / z);
            EXPECT_EQ(std::remainder(image.px[k].x, pixel_grid(size)), 0);
        }
        EXPECT_EQ(image.node, 3u);
    }
}

TEST(VistaProject, HasTheFinestGridOnWhichEdgeFunctionsAreExact) {
    EXPECT_EQ(pixel_grid({640, 480}), 0x1p-16);
    EXPECT_EQ(pixel_grid({480, 1024}), 0x1p-16);
    EXPECT_EQ(pixel_grid({1025, 1}), 0x1p-15);
    EXPECT_EQ(pixel_grid({16384, 16384}), 0x1p-12);
}

TEST(VistaProject, HasNoImageOfTheEyesOwnPlane) {
    const Screen screen(Camera{}, {64, 48});
    for (const double z : {0.0, -0.0, -1.0}) {
        const Tri triangle{{{{{0, 0, 1}}, {{0.5, 0, 1}}, {{0, 0.5, z}}}}, 3};
        ScreenTri image{.node = 9};
        reference().project({&triangle, 1}, screen, {&image, 1});
        EXPECT_EQ(image, ScreenTri{});
    }
}

TEST(VistaProject, PutsAPointAtInfinityOnTheHorizon) {
    const Screen screen(Camera{}, {64, 48});
    const Corner end{{0.5, 0, 1}, 0};
    const Tri triangle{{end, end, end}, 3};
    ScreenTri image;
    reference().project({&triangle, 1}, screen, {&image, 1});
    EXPECT_EQ(image.px[0].y, 24);
    EXPECT_EQ(image.inverse_depth[0], 0);
}

}  // namespace
}  // namespace luch::techniques::vista
