#include "framework/base/error.h"
#include "framework/base/json.h"
#include "framework/base/text.h"
#include "framework/math/bounds.h"
#include "scenes/generator/big_mesh.h"

#include <fmt/format.h>

#include <cstring>
#include <fstream>

namespace luch::assets {
namespace {

void write_obj(const BigMesh& mesh, std::ostream& out) {
    out << "# " << mesh.triangles << " triangles, written by luch_assets mesh\n";
    for (std::uint64_t i = 0; i < mesh.points; ++i) {
        const Vec3 p(mesh.point(i));
        out << fmt::format("v {} {} {}\n", p.x, p.y, p.z);
    }
    for (std::uint64_t i = 0; i < mesh.triangles; ++i) {
        const auto [a, b, c] = mesh.triangle(i);
        out << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
    }
}

template <class T>
void put(std::ostream& out, const T& value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    out.write(raw, sizeof value);
}

Json three(const Vec3& v) {
    return Json::array().push(double{v.x}).push(double{v.y}).push(double{v.z});
}

Json accessor(int view, int component, const char* type, std::uint64_t count) {
    return Json::object()
        .set("bufferView", view)
        .set("componentType", component)
        .set("type", type)
        .set("count", count);
}

/// The bounds must stand before the points, so they are computed once for them alone.
std::string glb_json(const BigMesh& mesh) {
    Box box;
    for (std::uint64_t i = 0; i < mesh.points; ++i) box.grow(Vec3(mesh.point(i)));
    const auto view = [](std::uint64_t offset, std::uint64_t length) {
        return Json::object().set("buffer", 0).set("byteOffset", offset).set("byteLength", length);
    };
    const auto list = [](const Json& element) { return Json::array().push(element); };
    const Json primitive =
        Json::object().set("attributes", Json::object().set("POSITION", 0)).set("indices", 1);
    constexpr int real = 5126, unsigned_int = 5125;
    std::string text =
        Json::object()
            .set("asset", Json::object().set("version", "2.0").set("generator", "luch_assets"))
            .set("scene", 0)
            .set("scenes", list(Json::object().set("nodes", list(0))))
            .set("nodes", list(Json::object().set("mesh", 0)))
            .set("meshes", list(Json::object().set("primitives", list(primitive))))
            .set("accessors", list(accessor(0, real, "VEC3", mesh.points)
                                       .set("min", three(box.lo))
                                       .set("max", three(box.hi)))
                                  .push(accessor(1, unsigned_int, "SCALAR", 3 * mesh.triangles)))
            .set("bufferViews",
                 list(view(0, 12 * mesh.points)).push(view(12 * mesh.points, 12 * mesh.triangles)))
            .set("buffers",
                 list(Json::object().set("byteLength", 12 * (mesh.points + mesh.triangles))))
            .text();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    return text;
}

void write_glb(const BigMesh& mesh, std::ostream& out, const std::filesystem::path& file) {
    const std::string json = glb_json(mesh);
    const std::uint64_t binary = 12 * (mesh.points + mesh.triangles);
    const std::uint64_t all = 12 + 8 + json.size() + 8 + binary;
    if (all > 0xffffffff) {
        throw Error({file.string()}, "would be larger than the 4 GB of a .glb; write an .obj");
    }
    const auto u32 = [&](std::uint64_t value) { put(out, static_cast<std::uint32_t>(value)); };
    out << "glTF";
    u32(2);
    u32(all);
    u32(json.size());
    out << "JSON" << json;
    u32(binary);
    out.write("BIN\0", 4);
    for (std::uint64_t i = 0; i < mesh.points; ++i) put(out, Vec3(mesh.point(i)));
    for (std::uint64_t i = 0; i < mesh.triangles; ++i) {
        for (const std::uint64_t corner : mesh.triangle(i)) u32(corner);
    }
}

}  // namespace

void write_big_mesh(const BigMesh& mesh, const std::filesystem::path& file) {
    const std::string ending = lower(file.extension().string());
    if (ending != ".obj" && ending != ".glb") {
        throw Error({file.string()}, "is neither .obj nor .glb; choose one of them");
    }
    std::error_code ignored;
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), ignored);
    std::ofstream out(file, std::ios::binary);
    if (ending == ".obj") {
        write_obj(mesh, out);
    } else {
        write_glb(mesh, out, file);
    }
    out.close();
    if (!out) throw Error({file.string()}, "cannot be written; choose a folder with room");
}

}  // namespace luch::assets
