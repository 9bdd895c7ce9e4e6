#include "scenes/generator/big_mesh.h"

#include "framework/base/error.h"
#include "framework/math/rng.h"
#include "scenes/generator/noise.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace luch::assets {
namespace {

/// Columns and rows of quads, of about the wanted number of triangles and `shape` times as many
/// columns as rows.
struct Quads {
    std::uint64_t columns, rows;
};

Quads quads_for(std::uint64_t triangles, double shape) {
    const double half = static_cast<double>(triangles) / 2;
    const auto start = static_cast<std::uint64_t>(std::sqrt(half * shape));
    Quads best{1, 1};
    double least = half;
    // Near the square root some number of columns divides it nearly without a rest.
    for (std::uint64_t columns = start; columns < start + 64; ++columns) {
        const auto rows =
            static_cast<std::uint64_t>(std::llround(half / static_cast<double>(columns)));
        const double off = std::abs(static_cast<double>(columns * rows) - half);
        if (off < least) {
            least = off;
            best = {columns, rows};
        }
    }
    return best;
}

BigMesh terrain(std::uint64_t wanted) {
    const auto [columns, rows] = quads_for(wanted, 1);
    BigMesh mesh;
    mesh.points = (columns + 1) * (rows + 1);
    mesh.triangles = 2 * columns * rows;
    mesh.point = [columns = columns, rows = rows](std::uint64_t i) {
        const double u = static_cast<double>(i % (columns + 1)) / static_cast<double>(columns);
        const double v = static_cast<double>(i / (columns + 1)) / static_cast<double>(rows);
        // The noise repeats at 1; a part of it is shown.
        const double height = Noise(301).fractal(0.9 * u, 0.9 * v, 4, 4, 9);
        return Vec3d(2 * u - 1, 0.6 * height, 2 * v - 1);
    };
    mesh.triangle = [columns = columns](std::uint64_t i) -> std::array<std::uint64_t, 3> {
        const std::uint64_t quad = i / 2, a = quad / columns * (columns + 1) + quad % columns;
        const std::uint64_t b = a + 1, c = a + columns + 1, d = c + 1;
        if (i % 2 == 0) return {a, d, b};
        return {a, c, d};
    };
    return mesh;
}

/// Rings of points between two poles; the pole triangles make up for one row of quads.
BigMesh sphere(std::uint64_t wanted) {
    const auto [columns, rows] = quads_for(wanted, 2);
    const std::uint64_t rings = rows;  // rows − 1 rows of quads, and two of triangles
    BigMesh mesh;
    mesh.points = columns * rings + 2;
    mesh.triangles = 2 * columns * rings;
    mesh.point = [columns = columns, rings](std::uint64_t i) {
        const std::uint64_t ring = i == 0                ? 0
                                   : i > columns * rings ? rings + 1
                                                         : 1 + (i - 1) / columns;
        const double down = std::numbers::pi * static_cast<double>(ring) / double(rings + 1);
        const double around = 2 * std::numbers::pi *
                              static_cast<double>(i == 0 ? 0 : (i - 1) % columns) / double(columns);
        const bool pole = ring == 0 || ring == rings + 1;
        const double s = pole ? 0 : std::sin(down);
        const double radius = 1 + 0.03 * s * s * std::sin(9 * around) * std::cos(12 * down);
        return radius * Vec3d(s * std::cos(around), std::cos(down), s * std::sin(around));
    };
    mesh.triangle = [columns = columns, rings](std::uint64_t i) -> std::array<std::uint64_t, 3> {
        const std::uint64_t row = i / (2 * columns), column = i / 2 % columns;
        const std::uint64_t next = (column + 1) % columns, south = columns * rings + 1;
        const auto at = [&](std::uint64_t ring, std::uint64_t k) { return 1 + ring * columns + k; };
        if (row + 1 == rings) {  // the two caps, taking turns
            if (i % 2 == 0) return {0, at(0, next), at(0, column)};
            return {south, at(rings - 1, column), at(rings - 1, next)};
        }
        if (i % 2 == 0) return {at(row, column), at(row, next), at(row + 1, next)};
        return {at(row, column), at(row + 1, next), at(row + 1, column)};
    };
    return mesh;
}

BigMesh tangle(std::uint64_t wanted) {
    BigMesh mesh;
    mesh.points = 3 * wanted;
    mesh.triangles = wanted;
    mesh.point = [wanted](std::uint64_t i) {
        const Key key = Key(303).branch(i / 3);
        const auto in = [&](std::uint64_t purpose, double half) {
            return half * (2 * key.uniform(purpose) - 1);
        };
        const Vec3d middle(in(0, 0.5), in(1, 0.5), in(2, 0.5));
        const Vec3d along(in(3, 0.5), in(4, 0.5), in(5, 0.5));
        // As many as there are, together they have an area of about 10.
        const double width = 20 / static_cast<double>(wanted);
        const Vec3d across(in(6, width), in(7, width), in(8, width));
        if (i % 3 == 2) return middle + along;
        return middle - along + (i % 3 == 0 ? across : -across);
    };
    mesh.triangle = [](std::uint64_t i) {
        return std::array<std::uint64_t, 3>{3 * i, 3 * i + 1, 3 * i + 2};
    };
    return mesh;
}

}  // namespace

BigMesh big_mesh(std::string_view kind, std::uint64_t triangles) {
    constexpr std::uint64_t least = 200, most = (std::uint64_t{1} << 31) - 1;
    if (triangles < least || triangles > most) {
        throw Error(fmt::format("--triangles is {}; choose {} to {}", triangles, least, most));
    }
    if (kind == "terrain") return terrain(triangles);
    if (kind == "sphere") return sphere(triangles);
    if (kind == "tangle") return tangle(triangles);
    throw Error(fmt::format("--kind is \"{}\"; choose terrain, sphere or tangle", kind));
}

}  // namespace luch::assets
