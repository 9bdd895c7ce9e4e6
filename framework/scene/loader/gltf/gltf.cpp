#include "framework/scene/loader/gltf/gltf.h"

#include "framework/scene/loader/gltf/accessor.h"
#include "framework/scene/loader/gltf/hierarchy.h"
#include "framework/scene/loader/gltf/materials.h"

#include <fmt/format.h>

namespace luch::loader {
namespace {

using namespace gltf;

enum Mode : std::uint64_t { triangle_list = 4, triangle_strip = 5, triangle_fan = 6 };

/// The corners of triangle `i` in the order of the vertices (specification, section 3.7.2.1).
std::array<std::size_t, 3> corners_of(std::uint64_t mode, std::size_t i) {
    if (mode == triangle_strip) return {i, i + 1 + i % 2, i + 2 - i % 2};
    if (mode == triangle_fan) return {i + 1, i + 2, 0};
    return {3 * i, 3 * i + 1, 3 * i + 2};
}

std::size_t triangle_count(std::uint64_t mode, std::size_t vertices) {
    if (mode == triangle_list) return vertices / 3;
    return vertices < 3 ? 0 : vertices - 2;
}

/// Gathers all placed meshes of one file.
class Gatherer {
 public:
    Gatherer(Document& document, Loading& loading)
        : document_(document), loading_(loading), materials_(document, loading) {}

    void take(const Placed& placed) {
        const Part& mesh = placed.mesh;
        if (mesh.size("primitives") == 0) mesh.fail("has no primitives; export the model again");
        for (std::size_t i = 0; i < mesh.size("primitives"); ++i) {
            take_primitive(mesh.element("primitives", i), placed.to_scene);
        }
    }

    RawMesh& raw() { return raw_; }
    std::vector<MaterialId>& materials() { return of_triangles_; }

 private:
    void take_primitive(const Part& primitive, const Transform& to_scene) {
        const std::uint64_t mode = primitive.whole("mode").value_or(triangle_list);
        if (mode > triangle_fan) primitive.fail("its mode is not 0 to 6; correct the file");
        if (mode < triangle_list) {
            loading_.diagnostics.warn(Place{primitive.title()}, "points and lines are passed over");
            return;
        }
        if (primitive.size("targets") > 0) {
            loading_.diagnostics.warn(Place{primitive.title()}, "morph targets are passed over");
        }
        const RawCorner first{static_cast<std::int64_t>(raw_.positions.size()),
                              static_cast<std::int64_t>(raw_.uvs.size()),
                              static_cast<std::int64_t>(raw_.normals.size())};
        const Part attributes = primitive.required("attributes");
        const std::size_t vertices = take_positions(attributes, to_scene);
        const bool has_normals = take_normals(attributes, vertices, to_scene);
        const bool has_uvs = take_uvs(attributes, vertices);
        const auto corner = [&](std::size_t vertex) {
            const auto v = static_cast<std::int64_t>(vertex);
            return RawCorner{first.position + v, has_uvs ? first.uv + v : -1,
                             has_normals ? first.normal + v : -1};
        };
        const bool mirrored = glm::determinant(to_scene.matrix) < 0;
        take_triangles(primitive, mode, vertices, mirrored, corner);
    }

    std::size_t take_positions(const Part& attributes, const Transform& to_scene) {
        const auto positions =
            read_vectors(document_, attributes.required_whole("POSITION"), "VEC3", attributes);
        check_size(attributes, raw_.positions.size() + positions.size(), "vertices");
        for (const Vec3d& p : positions) raw_.positions.push_back(to_scene.point(p));
        return positions.size();
    }

    bool take_normals(const Part& attributes, std::size_t vertices, const Transform& to_scene) {
        const auto index = attributes.whole("NORMAL");
        if (!index) return false;
        const auto normals = read_vectors(document_, *index, "VEC3", attributes);
        check_count(attributes, "NORMAL", normals.size(), vertices);
        const Transform inverse = to_scene.inverse();
        for (const Vec3d& n : normals) raw_.normals.push_back(inverse.normal_back(n));
        return true;
    }

    bool take_uvs(const Part& attributes, std::size_t vertices) {
        const auto index = attributes.whole("TEXCOORD_0");
        if (!index) return false;
        const auto uvs = read_vectors(document_, *index, "VEC2", attributes);
        check_count(attributes, "TEXCOORD_0", uvs.size(), vertices);
        for (const Vec3d& uv : uvs) raw_.uvs.emplace_back(uv);
        return true;
    }

    template <class Corner>
    void take_triangles(const Part& primitive, std::uint64_t mode, std::size_t vertices,
                        bool mirrored, const Corner& corner) {
        std::vector<std::uint32_t> indices;
        if (const auto index = primitive.whole("indices")) {
            indices = read_indices(document_, *index, primitive);
            for (const std::uint32_t i : indices) {
                if (i >= vertices) {
                    primitive.fail(fmt::format("its indices name vertex {} of {}; correct the mesh",
                                               i, vertices));
                }
            }
        }
        const bool indexed = primitive.has("indices");
        const std::size_t count = triangle_count(mode, indexed ? indices.size() : vertices);
        check_size(primitive, raw_.triangles.size() + count, "triangles");
        const MaterialId material = materials_.of(primitive);
        for (std::size_t i = 0; i < count; ++i) {
            std::array<std::size_t, 3> at = corners_of(mode, i);
            // A mirrored triangle shows its other side, unless its corners run the other way.
            if (mirrored) std::swap(at[1], at[2]);
            RawTriangle triangle;
            for (int k = 0; k < 3; ++k) triangle[k] = corner(indexed ? indices[at[k]] : at[k]);
            raw_.triangles.push_back(triangle);
            of_triangles_.push_back(material);
        }
    }

    /// A small file may place one mesh many times; what it unfolds to must fit the memory.
    void check_size(const Part& part, std::uint64_t count, std::string_view what) const {
        constexpr std::uint64_t always = 1 << 24, most = (std::uint64_t{1} << 31) - 1;
        if (count > std::min(most, std::max(always, document_.bytes_read()))) {
            part.fail(
                fmt::format("brings the model to {} {}; place it by Nodes of the scene "
                            "instead",
                            count, what));
        }
    }

    static void check_count(const Part& attributes, std::string_view name, std::size_t found,
                            std::size_t vertices) {
        if (found != vertices) {
            attributes.fail(
                fmt::format("{} has {} elements and POSITION {}; export the model again", name,
                            found, vertices));
        }
    }

    Document& document_;
    Loading& loading_;
    Materials materials_;
    RawMesh raw_;
    std::vector<MaterialId> of_triangles_;
};

void warn_about_motion(const Document& document, Loading& loading) {
    for (const char* key : {"skins", "animations"}) {
        if (document.root().size(key) > 0) {
            loading.diagnostics.warn(Place{document.file().string()},
                                     fmt::format("{} are passed over", key));
        }
    }
}

}  // namespace

Mesh read_gltf(const std::filesystem::path& file, const MeshOptions& options, Loading& loading) {
    Document document(file, loading.assets);
    warn_about_motion(document, loading);
    Gatherer gatherer(document, loading);
    for (const Placed& placed : placed_meshes(document)) gatherer.take(placed);
    if (gatherer.raw().triangles.empty()) {
        document.root().fail("its scene shows no triangles; export one with a mesh");
    }
    Mesh mesh = mesh_of(std::move(gatherer.raw()), options, file);
    mesh.materials = std::move(gatherer.materials());
    return mesh;
}

}  // namespace luch::loader
