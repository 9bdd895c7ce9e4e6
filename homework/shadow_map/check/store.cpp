#include "homework/shadow_map/check/store.h"

#include "framework/base/error.h"
#include "framework/image/planes.h"

namespace luch::homework::shadow_map {
namespace {

/// A list of so many numbers an element, as a file has it.
class Rows {
 public:
    Rows(int columns, std::size_t rows) : plane_({columns, static_cast<int>(rows)}) {}
    explicit Rows(Image<float> plane) : plane_(std::move(plane)) {}

    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(plane_.height()); }
    [[nodiscard]] float& at(int column, std::size_t row) {
        return plane_(column, static_cast<int>(row));
    }
    void put(int column, std::size_t row, const Vec3& v) {
        for (int k = 0; k < 3; ++k) at(column + k, row) = v[k];
    }
    [[nodiscard]] Vec3 vec(int column, std::size_t row) {
        return {at(column, row), at(column + 1, row), at(column + 2, row)};
    }
    [[nodiscard]] const Image<float>& plane() const { return plane_; }

 private:
    Image<float> plane_;
};

Image<float> texels_plane(const Sample& sample) {
    Rows rows(9, sample.directions.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto& [face, x, y] = sample.texels[i];
        rows.put(0, i, sample.directions[i]);
        rows.put(3, i, Vec3(face, x, y));
        rows.put(6, i, sample.centres[i]);
    }
    return rows.plane();
}

void read_texels(Rows rows, Sample& sample) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Vec3 texel = rows.vec(3, i);
        sample.directions.push_back(rows.vec(0, i));
        sample.texels.push_back(
            {static_cast<int>(texel.x), static_cast<int>(texel.y), static_cast<int>(texel.z)});
        sample.centres.push_back(rows.vec(6, i));
    }
}

Image<float> seen_plane(const Sample& sample) {
    const Receivers& seen = sample.seen;
    Rows rows(9, seen.points.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows.put(0, i, seen.points[i].from_light);
        rows.put(3, i, seen.points[i].normal);
        rows.put(6, i, {seen.biases[i], seen.lit[i], seen.pcf[i]});
    }
    return rows.plane();
}

void read_seen(Rows rows, Receivers& seen) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        seen.points.push_back({rows.vec(0, i), rows.vec(3, i)});
        seen.biases.push_back(rows.at(6, i));
        seen.lit.push_back(rows.at(7, i));
        seen.pcf.push_back(rows.at(8, i));
    }
}

Image<float> spots_plane(const Sample& sample) {
    Rows rows(4, sample.spots.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows.put(0, i, sample.spots[i].from_light);
        rows.at(3, i) = sample.spot_shares[i];
    }
    return rows.plane();
}

void read_spots(Rows rows, Sample& sample) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Vec3 spot = rows.vec(0, i);
        sample.spots.push_back({spot, -glm::normalize(spot)});
        sample.spot_shares.push_back(rows.at(3, i));
    }
}

/// Where a face begins on the sheet.
std::pair<int, int> corner_of(int face, int n) {
    return {face % 3 * n, face / 3 * n};
}

template <class T>
void put(const Image<T>& face, std::pair<int, int> corner, Image<T>& sheet) {
    for (int y = 0; y < face.height(); ++y) {
        for (int x = 0; x < face.width(); ++x) {
            sheet(corner.first + x, corner.second + y) = face(x, y);
        }
    }
}

template <class T>
Image<T> cut_out(const Image<T>& sheet, int n, int number) {
    const auto [x0, y0] = corner_of(number, n);
    Image<T> face({n, n});
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) face(x, y) = sheet(x0 + x, y0 + y);
    }
    return face;
}

}  // namespace

Image<std::uint32_t> sheet_of(const std::array<Image<std::uint32_t>, faces_of_cube>& faces) {
    const int n = faces[0].width();
    Image<std::uint32_t> sheet({3 * n, 2 * n});
    for (std::size_t i = 0; i < faces.size(); ++i) {
        put(faces[i], corner_of(static_cast<int>(i), n), sheet);
    }
    return sheet;
}

Image<float> sheet_of(const CubeMap& map) {
    Image<float> sheet({3 * map.n, 2 * map.n});
    for (std::size_t i = 0; i < map.faces.size(); ++i) {
        put(map.faces[i].distance, corner_of(static_cast<int>(i), map.n), sheet);
    }
    return sheet;
}

std::vector<grading::StoredPlane> planes_of(const Sample& sample) {
    Image<std::uint32_t> pixels({1, static_cast<int>(sample.pixels.size())});
    pixels.pixels() = sample.pixels;
    Rows grid(3, sample.grid.size());
    for (std::size_t i = 0; i < grid.size(); ++i) grid.put(0, i, sample.grid[i]);
    return {{"texels.exr", texels_plane(sample)},
            {"map.exr", sheet_of(sample.map)},
            {"nodes.exr", sheet_of(sample.nodes)},
            {"seen.exr", seen_plane(sample)},
            {"pixels.exr", pixels},
            {"spots.exr", spots_plane(sample)},
            {"grid.exr", grid.plane()}};
}

void read_planes(const std::filesystem::path& folder, Sample& sample) {
    const int n = sample.map.n;
    const auto fits = [&](const char* file, Size size, Size expected) {
        if (size == expected) return;
        throw Error({(folder / file).string()},
                    "does not fit; luch check shadow_map --regenerate makes it again");
    };
    const auto rows = [&](const char* file, int columns) {
        Image<float> plane = read_float_plane(folder / file);
        fits(file, plane.size(), {columns, plane.height()});
        return Rows(std::move(plane));
    };
    read_texels(rows("texels.exr", 9), sample);
    const Image<float> map = read_float_plane(folder / "map.exr");
    fits("map.exr", map.size(), {3 * n, 2 * n});
    const Image<std::uint32_t> nodes = read_id_plane(folder / "nodes.exr");
    fits("nodes.exr", nodes.size(), map.size());
    for (int face = 0; face < faces_of_cube; ++face) {
        const auto i = static_cast<std::size_t>(face);
        sample.map.faces[i] = {{0, 0, n, n}, cut_out(map, n, face)};
        sample.nodes[i] = cut_out(nodes, n, face);
    }
    read_seen(rows("seen.exr", 9), sample.seen);
    const Image<std::uint32_t> pixels = read_id_plane(folder / "pixels.exr");
    fits("pixels.exr", pixels.size(), {1, static_cast<int>(sample.seen.points.size())});
    sample.pixels = pixels.pixels();
    read_spots(rows("spots.exr", 4), sample);
    fits("spots.exr", {1, static_cast<int>(sample.spots.size())},
         {1, static_cast<int>(spots_inside + spots_on_rims + spots_in_corners)});
    Rows grid = rows("grid.exr", 3);
    for (std::size_t i = 0; i < grid.size(); ++i) sample.grid.push_back(grid.vec(0, i));
}

}  // namespace luch::homework::shadow_map
