#include "homework/vista/check/store.h"

#include "framework/base/error.h"
#include "framework/image/planes.h"

namespace luch::homework::vista {
namespace {

constexpr int tri_columns = 13, screen_columns = 10;

Image<float> rows_of(const std::vector<Tri>& triangles) {
    Image<float> rows({tri_columns, static_cast<int>(triangles.size())});
    for (int row = 0; row < rows.height(); ++row) {
        const Tri& triangle = triangles[static_cast<std::size_t>(row)];
        int column = 0;
        for (const auto& [p, w] : triangle.corners) {
            for (const double value : {p.x, p.y, p.z, w}) {
                rows(column++, row) = static_cast<float>(value);
            }
        }
        rows(column, row) = static_cast<float>(triangle.node);
    }
    return rows;
}

std::vector<Tri> triangles_of(const Image<float>& rows) {
    std::vector<Tri> triangles(static_cast<std::size_t>(rows.height()));
    for (int row = 0; row < rows.height(); ++row) {
        Tri& triangle = triangles[static_cast<std::size_t>(row)];
        for (int k = 0; k < 3; ++k) {
            const auto at = [&](int i) { return rows(4 * k + i, row); };
            triangle.corners[static_cast<std::size_t>(k)] = {{at(0), at(1), at(2)}, at(3)};
        }
        triangle.node = static_cast<NodeId>(rows(tri_columns - 1, row));
    }
    return triangles;
}

Image<float> rows_of(const std::vector<ScreenTri>& triangles) {
    Image<float> rows({screen_columns, static_cast<int>(triangles.size())});
    for (int row = 0; row < rows.height(); ++row) {
        const ScreenTri& triangle = triangles[static_cast<std::size_t>(row)];
        for (int k = 0; k < 3; ++k) {
            const auto i = static_cast<std::size_t>(k);
            rows(3 * k, row) = static_cast<float>(triangle.px[i].x);
            rows(3 * k + 1, row) = static_cast<float>(triangle.px[i].y);
            rows(3 * k + 2, row) = static_cast<float>(triangle.inverse_depth[i]);
        }
        rows(screen_columns - 1, row) =
            triangle.node == no_node ? -1.0f : static_cast<float>(triangle.node);
    }
    return rows;
}

std::vector<ScreenTri> screen_triangles_of(const Image<float>& rows) {
    std::vector<ScreenTri> triangles(static_cast<std::size_t>(rows.height()));
    for (int row = 0; row < rows.height(); ++row) {
        ScreenTri& triangle = triangles[static_cast<std::size_t>(row)];
        for (int k = 0; k < 3; ++k) {
            const auto i = static_cast<std::size_t>(k);
            triangle.px[i] = {rows(3 * k, row), rows(3 * k + 1, row)};
            triangle.inverse_depth[i] = rows(3 * k + 2, row);
        }
        const float node = rows(screen_columns - 1, row);
        triangle.node = node < 0 ? no_node : static_cast<NodeId>(node);
    }
    return triangles;
}

Image<std::uint32_t> column_of(const std::vector<std::uint32_t>& values) {
    Image<std::uint32_t> column({1, static_cast<int>(values.size())});
    column.pixels() = values;
    return column;
}

}  // namespace

std::vector<grading::StoredPlane> planes_of(const Sample& sample) {
    return {
        {"shape_ids.exr", sample.shape_ids},         {"shape_depth.exr", sample.shape_depth},
        {"around.exr", rows_of(sample.around)},      {"in_view.exr", rows_of(sample.in_view)},
        {"order.exr", column_of(sample.order)},      {"on_screen.exr", rows_of(sample.on_screen)},
        {"painter_ids.exr", sample.painter_ids},     {"nearest_ids.exr", sample.nearest_ids},
        {"nearest_depth.exr", sample.nearest_depth}, {"named.exr", sample.named},
        {"hit_nodes.exr", sample.hit_nodes},         {"fell_back.exr", sample.fell_back}};
}

std::vector<grading::StoredPlane> planes_of(const LodSample& sample) {
    Image<float> radii({1, static_cast<int>(sample.radii.size())});
    radii.pixels() = sample.radii;
    const std::vector<std::uint32_t> segments(sample.segments.begin(), sample.segments.end());
    return {{"lod_radii.exr", radii}, {"lod_segments.exr", column_of(segments)}};
}

void read_planes(const std::filesystem::path& folder, Sample& sample) {
    const Size size = sample.scene->settings.frame;
    const auto ids = [&](const char* name) {
        Image<std::uint32_t> plane = read_id_plane(folder / name);
        if (plane.size() != size) {
            throw Error({(folder / name).string()},
                        "is not of its scene's size; luch check vista --regenerate makes it again");
        }
        return plane;
    };
    sample.shape_ids = ids("shape_ids.exr");
    sample.shape_depth = read_float_plane(folder / "shape_depth.exr");
    sample.around = triangles_of(read_float_plane(folder / "around.exr"));
    sample.in_view = triangles_of(read_float_plane(folder / "in_view.exr"));
    sample.order = read_id_plane(folder / "order.exr").pixels();
    sample.on_screen = screen_triangles_of(read_float_plane(folder / "on_screen.exr"));
    sample.painter_ids = ids("painter_ids.exr");
    sample.nearest_ids = ids("nearest_ids.exr");
    sample.nearest_depth = read_float_plane(folder / "nearest_depth.exr");
    sample.named = ids("named.exr");
    sample.hit_nodes = ids("hit_nodes.exr");
    sample.fell_back = ids("fell_back.exr");
}

LodSample read_lod(const std::filesystem::path& folder) {
    LodSample sample;
    sample.radii = read_float_plane(folder / "lod_radii.exr").pixels();
    const Image<std::uint32_t> segments = read_id_plane(folder / "lod_segments.exr");
    for (const std::uint32_t n : segments.pixels()) {
        sample.segments.push_back(static_cast<int>(n));
    }
    return sample;
}

}  // namespace luch::homework::vista
