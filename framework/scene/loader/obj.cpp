#include "framework/scene/loader/obj.h"

#include "framework/base/files.h"
#include "framework/scene/loader/obj_statements.h"

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

Vec3d face_normal(const ObjStatements& obj, const ObjTriangle& triangle) {
    const Vec3d& a = obj.positions[triangle[0].position];
    const Vec3d& b = obj.positions[triangle[1].position];
    const Vec3d& c = obj.positions[triangle[2].position];
    return unit(glm::cross(b - a, c - a)).value_or(Vec3d(0));
}

void recenter(std::vector<Vec3d>& positions) {
    Vec3d sum{0};
    for (const Vec3d& p : positions) sum += p;
    const Vec3d mean = sum / std::max<double>(1, static_cast<double>(positions.size()));
    for (Vec3d& p : positions) p -= mean;
}

/// Per vertex the sum of the unit normals of its triangles, without weights.
void smooth(ObjStatements& obj) {
    obj.normals.assign(obj.positions.size(), Vec3d(0));
    for (ObjTriangle& triangle : obj.triangles) {
        const Vec3d normal = face_normal(obj, triangle);
        for (ObjCorner& corner : triangle) {
            corner.normal = corner.position;
            obj.normals[corner.position] += normal;
        }
    }
}

/// The mesh's normals; corners that have none, or one of no length, get their triangle's.
void set_normals(Mesh& mesh, const ObjStatements& obj) {
    std::vector<bool> usable;
    for (const Vec3d& normal : obj.normals) {
        const auto direction = unit(normal);
        usable.push_back(direction.has_value());
        mesh.normals.emplace_back(direction.value_or(Vec3d(0, 1, 0)));
    }
    for (std::size_t i = 0; i < obj.triangles.size(); ++i) {
        std::optional<std::uint32_t> of_face;
        for (int k = 0; k < 3; ++k) {
            const std::int64_t index = obj.triangles[i][k].normal;
            if (index >= 0 && usable[index]) {
                mesh.triangles[i].normal[k] = static_cast<std::uint32_t>(index);
                continue;
            }
            if (!of_face) {
                of_face = static_cast<std::uint32_t>(mesh.normals.size());
                mesh.normals.emplace_back(
                    unit(face_normal(obj, obj.triangles[i])).value_or(Vec3d(0, 1, 0)));
            }
            mesh.triangles[i].normal[k] = *of_face;
        }
    }
}

void set_uvs(Mesh& mesh, const ObjStatements& obj) {
    const auto zero = static_cast<std::uint32_t>(obj.uvs.size());
    for (const Vec2d& uv : obj.uvs) mesh.uvs.emplace_back(uv);
    mesh.uvs.emplace_back(0, 0);
    for (std::size_t i = 0; i < obj.triangles.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            const std::int64_t index = obj.triangles[i][k].uv;
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

Mesh read_obj(const std::filesystem::path& file, const ObjOptions& options,
              Diagnostics& diagnostics) {
    ObjStatements obj = read_statements(read_text(file), file.string(), diagnostics);
    if (options.recenter) recenter(obj.positions);
    check_extent(obj.positions, file);

    const bool has_normals = !obj.normals.empty();
    const bool smoothed = !has_normals && options.auto_smooth;
    if (smoothed) smooth(obj);

    Mesh mesh;
    set_positions(mesh, obj.positions);
    mesh.triangles.resize(obj.triangles.size());
    for (std::size_t i = 0; i < obj.triangles.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            mesh.triangles[i].position[k] =
                static_cast<std::uint32_t>(obj.triangles[i][k].position);
        }
    }
    mesh.faceted = smoothed ? false : options.faceted || !has_normals;
    if (has_normals || smoothed) set_normals(mesh, obj);
    if (!obj.uvs.empty()) set_uvs(mesh, obj);
    return mesh;
}

}  // namespace luch::loader
