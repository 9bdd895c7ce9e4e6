#include "scenes/generator/teapot.h"

#include "scenes/generator/newell.h"
#include "scenes/generator/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace luch::assets {
namespace {

/// A sheet's points in rows of `columns`, which close to rings; an end that is one point is one
/// point. Its uvs lie in rows of columns + 1.
class Grid {
 public:
    Grid(const Sheet& sheet, int segments)
        : sheet_(sheet),
          segments_(segments),
          columns_(sheet.across * segments),
          rows_(sheet.along * segments) {}

    Surface surface() const {
        Surface surface{sheet_.name, {}, {}, {}, {}};
        for (int row = 0; row <= rows_; ++row) {
            for (int column = 0; column <= columns_; ++column) add_sample(row, column, surface);
        }
        for (int row = 0; row < rows_; ++row) {
            for (int column = 0; column < columns_; ++column) add_quad(row, column, surface);
        }
        return surface;
    }

 private:
    bool is_pole(int row) const {
        return (row == 0 && sheet_.starts_in_point) || (row == rows_ && sheet_.ends_in_point);
    }

    void add_sample(int row, int column, Surface& surface) const {
        // Columns run to the viewer's left.
        surface.uvs.push_back({1 - double(column) / columns_, double(row) / rows_});
        if (column == columns_ || (is_pole(row) && column > 0)) return;
        const int ring = std::min(row / segments_, sheet_.along - 1);
        const int place = column / segments_;
        const Patch& patch = sheet_.patches[ring * sheet_.across + place];
        const double u = double(column - place * segments_) / segments_;
        const double v = double(row - ring * segments_) / segments_;
        surface.points.push_back(patch.point(u, v));
        surface.normals.push_back(patch.normal(u, v));
    }

    Surface::Corner corner(int row, int column) const {
        const int before =
            sheet_.starts_in_point && row > 0 ? (row - 1) * columns_ + 1 : row * columns_;
        const int within = is_pole(row) ? 0 : column % columns_;
        return {static_cast<std::uint32_t>(before + within),
                static_cast<std::uint32_t>(row * (columns_ + 1) + column)};
    }

    void add_quad(int row, int column, Surface& surface) const {
        const auto a = corner(row, column), b = corner(row, column + 1);
        const auto c = corner(row + 1, column + 1), d = corner(row + 1, column);
        if (!is_pole(row)) surface.triangles.push_back({a, c, b});
        if (!is_pole(row + 1)) surface.triangles.push_back({a, d, c});
    }

    const Sheet& sheet_;
    int segments_, columns_, rows_;
};

void append_vectors(const char* key, const std::vector<Vec3d>& vectors, int decimals,
                    std::string& text) {
    for (const Vec3d& p : vectors) {
        text += key;
        for (int axis = 0; axis < 3; ++axis) text += ' ' + number(p[axis], decimals);
        text += '\n';
    }
}

}  // namespace

std::vector<Surface> teapot(int segments) {
    std::vector<Surface> surfaces;
    for (const Sheet& sheet : newell_teapot()) surfaces.push_back(Grid(sheet, segments).surface());
    return surfaces;
}

std::string obj_text(const std::vector<Surface>& surfaces, std::string_view comment) {
    std::string text = "# " + std::string(comment) + '\n';
    std::size_t first_point = 1, first_uv = 1;
    for (const Surface& surface : surfaces) {
        text += "o " + std::string(surface.name) + '\n';
        append_vectors("v", surface.points, 5, text);
        append_vectors("vn", surface.normals, 4, text);
        for (const Vec2d& uv : surface.uvs) {
            text += fmt::format("vt {} {}\n", number(uv.x, 4), number(uv.y, 4));
        }
        for (const Surface::Triangle& triangle : surface.triangles) {
            text += 'f';
            for (const auto [point, uv] : triangle) {
                const std::size_t p = first_point + point;
                text += fmt::format(" {}/{}/{}", p, first_uv + uv, p);
            }
            text += '\n';
        }
        first_point += surface.points.size();
        first_uv += surface.uvs.size();
    }
    return text;
}

}  // namespace luch::assets
