#include "framework/math/rng.h"
#include "techniques/vista/vista.h"

#include <gtest/gtest.h>

#include <limits>

namespace luch::techniques::vista {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Ids and depths, painted by the reference.
struct Painted {
    Image<NodeId> ids;
    Image<float> depth;
    bool operator==(const Painted&) const = default;
};

/// `side` is that of the tiles; 0: one tile.
Painted painted(const std::vector<ScreenTri>& triangles, Size size, int side = 0,
                Hidden hidden = Hidden::painter) {
    // What was there before must not matter.
    Painted result{Image<NodeId>(size, 77), Image<float>(size, -1)};
    const int step = side == 0 ? std::max(size.width, size.height) : side;
    for (int y = 0; y < size.height; y += step) {
        for (int x = 0; x < size.width; x += step) {
            const Tile tile{x, y, std::min(x + step, size.width), std::min(y + step, size.height)};
            reference().rasterise(triangles, tile, hidden, result.ids.view(), result.depth.view());
        }
    }
    return result;
}

/// How many of the triangles cover each pixel, when each is painted alone.
Image<int> coverage(const std::vector<ScreenTri>& triangles, Size size) {
    Image<int> count(size);
    for (const ScreenTri& triangle : triangles) {
        const Painted alone = painted({triangle}, size);
        for (std::size_t i = 0; i < count.pixels().size(); ++i) {
            count.pixels()[i] += alone.ids.pixels()[i] != no_node;
        }
    }
    return count;
}

ScreenTri triangle(Vec2d a, Vec2d b, Vec2d c, NodeId node = 1, double z = 1) {
    return {{a, b, c}, {1 / z, 1 / z, 1 / z}, node};
}

/// A point near another, on the grid; every other time on a pixel's centre, where ties are.
Vec2d jittered(const Vec2d& p, double reach, Key key, Size size) {
    const Vec2d moved = p + reach * (2.0 * key.square(0) - 1.0);
    if (key.uniform(9) < 0.5) return glm::floor(moved) + 0.5;
    return glm::round(moved / pixel_grid(size)) * pixel_grid(size);
}

/// A sheet of triangles that covers a frame and more, cut along random diagonals, wound at random.
std::vector<ScreenTri> random_sheet(Size size, Key key) {
    constexpr int cells = 6;
    const Vec2d cell{(size.width + 8.0) / cells, (size.height + 8.0) / cells};
    const auto corner = [&](int i, int j) {
        const Vec2d p = Vec2d(-4) + cell * Vec2d(i, j);
        const bool border = i == 0 || j == 0 || i == cells || j == cells;
        return border ? p : jittered(p, 0.2 * cell.x, key.branch(j * (cells + 1) + i), size);
    };
    std::vector<ScreenTri> sheet;
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            const Vec2d a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1),
                        d = corner(i, j + 1);
            const auto random = key.bits(1000 + j * cells + i);
            if (random & 1) {
                sheet.push_back(random & 2 ? triangle(a, b, c) : triangle(a, c, b));
                sheet.push_back(triangle(a, c, d));
            } else {
                sheet.push_back(random & 2 ? triangle(a, b, d) : triangle(d, b, a));
                sheet.push_back(triangle(b, c, d));
            }
        }
    }
    return sheet;
}

std::vector<ScreenTri> random_soup(Size size, int count, Key key) {
    std::vector<ScreenTri> soup;
    for (int i = 0; i < count; ++i) {
        const Key mine = key.branch(i);
        const auto corner = [&](int k) {
            const Vec2d reach(size.width, size.height);
            return jittered(reach * (2.0 * mine.branch(k).square(5) - 0.5), 1, mine.branch(k),
                            size);
        };
        ScreenTri made = triangle(corner(0), corner(1), corner(2), static_cast<NodeId>(i));
        for (int k = 0; k < 3; ++k) made.inverse_depth[k] = 0.1 + mine.uniform(100 + k);
        soup.push_back(made);
    }
    return soup;
}

void expect_covered_once(const std::vector<ScreenTri>& triangles, Size size) {
    const Image<int> count = coverage(triangles, size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) ASSERT_EQ(count(x, y), 1) << x << ", " << y;
    }
}

TEST(VistaRasterise, CoversSharedEdgesExactlyOnce) {
    const Size size{23, 19};
    for (int i = 0; i < 500; ++i) {
        expect_covered_once(random_sheet(size, Key(i)), size);
        if (HasFatalFailure()) FAIL() << "sheet " << i;
    }
}

TEST(VistaRasterise, CoversAFanAroundAPixelsCentreExactlyOnce) {
    const Size size{16, 16};
    const Vec2d hub{7.5, 8.5};
    for (int spokes = 3; spokes < 40; ++spokes) {
        std::vector<ScreenTri> fan;
        const auto rim = [&](int i) {
            const double angle = 6.283185307179586 * (i % spokes) / spokes;
            const Vec2d p = hub + 60.0 * Vec2d(std::cos(angle), std::sin(angle));
            return glm::round(p / pixel_grid(size)) * pixel_grid(size);
        };
        for (int i = 0; i < spokes; ++i) fan.push_back(triangle(hub, rim(i), rim(i + 1)));
        expect_covered_once(fan, size);
        if (HasFatalFailure()) FAIL() << spokes << " spokes";
    }
}

TEST(VistaRasterise, LeavesNoCrackBesideASliver) {
    const Size size{32, 32};
    const double thin = pixel_grid(size);
    for (const double x : {10.5, 10.5 - thin, 10.25}) {
        // Two half planes with a sliver of one grid step between them.
        const Vec2d top{x, -10}, bottom{x + 3 * thin, 50}, bottom_right{x + 4 * thin, 50};
        expect_covered_once(
            {triangle({-90, -10}, top, bottom), triangle({-90, -10}, bottom, {-90, 50}),
             triangle(top, bottom, bottom_right), triangle(top, {90, -10}, bottom_right),
             triangle({90, -10}, {90, 50}, bottom_right)},
            size);
    }
}

TEST(VistaRasterise, CoversAHugeTriangleAndItsNeighbourExactlyOnce) {
    const Size size{64, 48};
    const Vec2d a{-1e7, -0.9e7}, b{1.1e7, -1e7}, c{0.95e7, 1.05e7}, d{-1.03e7, 0.97e7};
    expect_covered_once({triangle(a, b, c), triangle(a, c, d)}, size);
    expect_covered_once({triangle(b, d, a), triangle(b, c, d)}, size);
}

/// Beyond the grid edge functions are rounded; neighbours must still agree about their common edge.
/// The spokes run through many pixels' centres, but for the rounding of their far ends.
TEST(VistaRasterise, CoversAHugeFanExactlyOnce) {
    const Size size{48, 48};
    const Vec2d hub{23.5, 24.5};
    const std::array<Vec2d, 9> directions{
        {{3, 1}, {2, 3}, {-1, 2}, {-3, 2}, {-7, 1}, {-5, -2}, {-1, -3}, {1, -7}, {5, -3}}};
    for (int i = 0; i < 100; ++i) {
        std::vector<ScreenTri> fan;
        const auto rim = [&](std::size_t k) {
            k %= directions.size();
            return hub + 1e7 * (0.1 + Key(i).uniform(k)) * directions[k];
        };
        for (std::size_t k = 0; k < directions.size(); ++k) {
            fan.push_back(triangle(hub, rim(k), rim(k + 1)));
        }
        expect_covered_once(fan, size);
        if (HasFatalFailure()) FAIL() << "fan " << i;
    }
}

TEST(VistaRasterise, PaintsNothingForATriangleWithoutArea) {
    const Size size{8, 8};
    for (const ScreenTri& flat : {ScreenTri{}, triangle({1, 1}, {5, 5}, {3, 3}),
                                  triangle({0.5, 0.5}, {6.5, 0.5}, {3.5, 0.5})}) {
        const Painted result = painted({flat}, size);
        for (const NodeId id : result.ids.pixels()) EXPECT_EQ(id, no_node);
    }
}

TEST(VistaRasterise, ClearsItsTileOnly) {
    Image<NodeId> ids({8, 8}, 5);
    Image<float> depth({8, 8}, 5);
    reference().rasterise({}, {2, 3, 6, 5}, Hidden::painter, ids.view(), depth.view());
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) {
            const bool inside = x >= 2 && x < 6 && y >= 3 && y < 5;
            EXPECT_EQ(ids(x, y), inside ? no_node : 5u);
            EXPECT_EQ(depth(x, y), inside ? infinity : 5.0f);
        }
    }
}

TEST(VistaRasterise, GivesTheSameBitsForAnyTiling) {
    const Size size{50, 37};
    for (const Hidden hidden : {Hidden::painter, Hidden::depth}) {
        const auto soup = random_soup(size, 60, Key(3));
        const Painted whole = painted(soup, size, 0, hidden);
        EXPECT_EQ(painted(soup, size, 1, hidden), whole);
        EXPECT_EQ(painted(soup, size, 16, hidden), whole);
    }
}

TEST(VistaRasterise, LetsThePainterCoverAndTheDepthDecide) {
    const Size size{4, 4};
    const auto near = triangle({-1, -1}, {9, -1}, {-1, 9}, 1, 2);
    const auto far = triangle({-1, -1}, {9, -1}, {-1, 9}, 2, 3);
    EXPECT_EQ(painted({near, far}, size).ids(1, 1), 2u);
    EXPECT_EQ(painted({far, near}, size).ids(1, 1), 1u);
    EXPECT_EQ(painted({near, far}, size, 0, Hidden::depth).ids(1, 1), 1u);
    EXPECT_EQ(painted({far, near}, size, 0, Hidden::depth).ids(1, 1), 1u);
    EXPECT_EQ(painted({far, near}, size, 0, Hidden::depth).depth(1, 1), 2.0f);
}

/// The plane through (−2, y, 1), (2, y, 1) and the far line z = 9 at y = −1: z = 1/(linear in
/// pixels).
TEST(VistaRasterise, InterpolatesDepthInPerspective) {
    const Size size{64, 64};
    const Camera camera{.fov_deg = 90, .aspect = 1};
    const Screen screen(camera, size);
    std::vector<Tri> floor{{{{{{-9, -1, 1}}, {{9, -1, 1}}, {{0, -1, 40}}}}, 1}};
    std::vector<ScreenTri> on_screen(1);
    reference().project(floor, screen, on_screen);
    const Painted result = painted(on_screen, size);
    int covered = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (result.ids(x, y) == no_node) continue;
            ++covered;
            const double slope = (2 * (y + 0.5) / size.height - 1) * screen.half_height();
            EXPECT_NEAR(result.depth(x, y) * slope, 1, 1e-4) << x << ", " << y;
        }
    }
    EXPECT_GT(covered, 500);
}

}  // namespace
}  // namespace luch::techniques::vista
