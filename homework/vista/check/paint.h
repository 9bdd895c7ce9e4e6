#pragma once

#include "techniques/vista/vista.h"

#include <algorithm>
#include <cmath>
#include <limits>

// A rasteriser with switches, for the mutants and variants of t6. Not written to be read beside the
// lecture, nor to be quick.
namespace luch::homework::vista {

struct PaintRules {
    enum class Tie { top_left, bottom_right, both, neither };
    double centre = 0.5;  ///< where in its pixel a pixel is looked at
    Tie tie = Tie::top_left;
    bool affine = false;    ///< z runs linearly, not 1/z
    bool farthest = false;  ///< what is farther wins
    bool always_depth = false;
    bool by_columns = false;
    int one_more = 0;  ///< columns beyond the tile, or short of it
};

template <class Real, PaintRules rules>
class Painter {
 public:
    using Tile = luch::Tile;

    static void rasterise(std::span<const techniques::vista::ScreenTri> triangles, Tile tile,
                          techniques::vista::Hidden hidden, ImageView<NodeId> ids,
                          ImageView<float> depth) {
        const bool by_depth = rules.always_depth || hidden == techniques::vista::Hidden::depth;
        constexpr float infinity = std::numeric_limits<float>::infinity();
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) {
                ids(x, y) = no_node;
                depth(x, y) = rules.farthest && by_depth ? 0 : infinity;
            }
        }
        for (const auto& triangle : triangles) {
            if (triangle.node != no_node) paint(triangle, tile, by_depth, ids, depth);
        }
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) {
                if (ids(x, y) == no_node) depth(x, y) = infinity;
            }
        }
    }

 private:
    static bool inside(Real value, Real along_x, Real along_y) {
        if (value != 0) return value > 0;
        using Tie = PaintRules::Tie;
        const bool top_left = along_y < 0 || (along_y == 0 && along_x > 0);
        if constexpr (rules.tie == Tie::both) return true;
        if constexpr (rules.tie == Tie::neither) return false;
        return (rules.tie == Tie::top_left) == top_left;
    }

    static void paint(const techniques::vista::ScreenTri& triangle, Tile tile, bool by_depth,
                      ImageView<NodeId> ids, ImageView<float> depth) {
        const auto pixel = [&](int x, int y) {
            Real value[3], sum = 0;
            bool all = true;
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec2d& a = triangle.px[(k + 1) % 3];
                const Vec2d& b = triangle.px[(k + 2) % 3];
                // From the same end for both neighbours, so that they get the same number.
                const bool swap = b.x < a.x || (b.x == a.x && b.y < a.y);
                const Vec2d& from = swap ? b : a;
                const Real sign = clockwise(triangle) ? 1 : -1;
                const Real ax = Real(b.x - a.x) * sign, ay = Real(b.y - a.y) * sign;
                value[k] = ax * (Real(y) + Real(rules.centre) - Real(from.y)) -
                           ay * (Real(x) + Real(rules.centre) - Real(from.x));
                all = all && inside(value[k], ax, ay);
                sum += value[k];
            }
            if (!all || !(sum > 0)) return;
            Real linear = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto inverse = Real(triangle.inverse_depth[k]);
                linear += value[k] / sum * (rules.affine ? 1 / inverse : inverse);
            }
            const auto z = static_cast<float>(rules.affine ? linear : 1 / linear);
            if (by_depth && !(rules.farthest ? z > depth(x, y) : z < depth(x, y))) return;
            ids(x, y) = triangle.node;
            depth(x, y) = z;
        };
        const Tile box = around(triangle, tile);
        if constexpr (rules.by_columns) {
            for (int x = box.x0; x < box.x1; ++x) {
                for (int y = box.y0; y < box.y1; ++y) pixel(x, y);
            }
        } else {
            for (int y = box.y0; y < box.y1; ++y) {
                for (int x = box.x0; x < box.x1; ++x) pixel(x, y);
            }
        }
    }

    /// The pixels of a tile that a triangle may cover.
    static Tile around(const techniques::vista::ScreenTri& triangle, Tile tile) {
        const auto& [a, b, c] = triangle.px;
        const auto at = [](double value, int least, int most) {
            return static_cast<int>(std::clamp(value, double(least), double(most)));
        };
        const int x1 = tile.x1 + rules.one_more;
        return {at(std::floor(std::min({a.x, b.x, c.x}) - 1), tile.x0, x1),
                at(std::floor(std::min({a.y, b.y, c.y}) - 1), tile.y0, tile.y1),
                at(std::ceil(std::max({a.x, b.x, c.x}) + 1), tile.x0, x1),
                at(std::ceil(std::max({a.y, b.y, c.y}) + 1), tile.y0, tile.y1)};
    }

    static bool clockwise(const techniques::vista::ScreenTri& triangle) {
        const Vec2d a = triangle.px[1] - triangle.px[0], b = triangle.px[2] - triangle.px[0];
        return a.x * b.y - a.y * b.x > 0;
    }
};

}  // namespace luch::homework::vista
