#include "framework/scene/loader/mesh_builder.h"

#include "framework/base/error.h"

#include <fmt/format.h>

#include <optional>

namespace luch::loader {
namespace {

/// Of unit length, also where the square of the length would overflow or vanish.
std::optional<Vec3d> unit(const Vec3d& v) {
    const double size = max_norm(v);
    if (!(size > 0) || !std::isfinite(size)) return std::nullopt;
    return glm::normalize(v / size);
}

Vec3d face_normal(const RawMesh& raw, const RawTriangle& triangle) {
    const Vec3d& a = raw.positions[triangle[0].position];
    const Vec3d& b = raw.positions[triangle[1].position];
    const Vec3d& c = raw.positions[triangle[2].position];
    return unit(glm::cross(b - a, c - a)).value_or(Vec3d(0));
}

void recenter(std::vector<Vec3d>& positions) {
    Vec3d sum{0};
    for (const Vec3d& p : positions) sum += p;
    const Vec3d mean = sum / std::max<double>(1, static_cast<double>(positions.size()));
    for (Vec3d& p : positions) p -= mean;
}

/// Per vertex the sum of the unit normals of its triangles, without weights.
void smooth(RawMesh& raw) {
    raw.normals.assign(raw.positions.size(), Vec3d(0));
    for (RawTriangle& triangle : raw.triangles) {
        const Vec3d normal = face_normal(raw, triangle);
        for (RawCorner& corner : triangle) {
            corner.normal = corner.position;
            raw.normals[corner.position] += normal;
        }
    }
}

/// The mesh's normals; corners that have none, or one of no length, get their triangle's.
void set_normals(Mesh& mesh, const RawMesh& raw) {
    std::vector<bool> usable;
    for (const Vec3d& normal : raw.normals) {
        const auto direction = unit(normal);
        usable.push_back(direction.has_value());
        mesh.normals.emplace_back(direction.value_or(Vec3d(0, 1, 0)));
    }
    for (std::size_t i = 0; i < raw.triangles.size(); ++i) {
        std::optional<std::uint32_t> of_face;
        for (int k = 0; k < 3; ++k) {
            const std::int64_t index = raw.triangles[i][k].normal;
            if (index >= 0 && usable[index]) {
                mesh.triangles[i].normal[k] = static_cast<std::uint32_t>(index);
                continue;
            }
            if (!of_face) {
                of_face = static_cast<std::uint32_t>(mesh.normals.size());
                mesh.normals.emplace_back(
                    unit(face_normal(raw, raw.triangles[i])).value_or(Vec3d(0, 1, 0)));
            }
            mesh.triangles[i].normal[k] = *of_face;
        }
    }
}

void set_uvs(Mesh& mesh, const RawMesh& raw) {
    const auto zero = static_cast<std::uint32_t>(raw.uvs.size());
    for (const Vec2d& uv : raw.uvs) mesh.uvs.emplace_back(uv);
    mesh.uvs.emplace_back(0, 0);
    for (std::size_t i = 0; i < raw.triangles.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            const std::int64_t index = raw.triangles[i][k].uv;
            mesh.triangles[i].uv[k] = index >= 0 ? static_cast<std::uint32_t>(index) : zero;
        }
    }
}

/// Below this a mesh cannot be scaled to its frame by a power of two.
void check_extent(const std::vector<Vec3d>& positions, const std::filesystem::path& file) {
    constexpr double least = 1e-60;
    Boxd box;
    for (const Vec3d& p : positions) box.grow(p);
    const double extent = box.empty() ? 0 : max_norm(box.size());
    if (extent > 0 && extent < least) {
        throw Error({file.string()}, fmt::format("is only {} across; make it larger", extent));
    }
}

}  // namespace

Mesh mesh_of(RawMesh raw, const MeshOptions& options, const std::filesystem::path& file) {
    if (options.recenter) recenter(raw.positions);
    check_extent(raw.positions, file);

    const bool has_normals = !raw.normals.empty();
    const bool smoothed = !has_normals && options.auto_smooth;
    if (smoothed) smooth(raw);

    Mesh mesh;
    set_positions(mesh, raw.positions);
    mesh.triangles.resize(raw.triangles.size());
    for (std::size_t i = 0; i < raw.triangles.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            mesh.triangles[i].position[k] =
                static_cast<std::uint32_t>(raw.triangles[i][k].position);
        }
    }
    mesh.faceted = smoothed ? false : options.faceted || !has_normals;
    if (has_normals || smoothed) set_normals(mesh, raw);
    if (!raw.uvs.empty()) set_uvs(mesh, raw);
    return mesh;
}

}  // namespace luch::loader
