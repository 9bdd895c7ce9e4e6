#include "framework/base/text.h"
#include "framework/scene/loader/blocks.h"
#include "framework/scene/loader/gltf/gltf.h"
#include "framework/scene/loader/obj.h"

#include <fmt/format.h>

namespace luch::loader {

void read_plane(Properties& block, Loading& loading) {
    Plane plane;
    plane.y = block.number("y", plane.y);
    plane.limit = block.number("limit", plane.limit, positive);
    loading.scene.geometries.emplace_back(plane);
}

void read_sphere(Properties& block, Loading& loading) {
    Sphere sphere;
    sphere.centre = block.vector("O", sphere.centre);
    sphere.radius = block.number("R", sphere.radius, positive);
    sphere.uv_scaling = block.number("uvscaling", sphere.uv_scaling);
    loading.scene.geometries.emplace_back(sphere);
}

void read_cube(Properties& block, Loading& loading) {
    Cube cube;
    cube.centre = block.vector("O", cube.centre);
    // The older dialects give half of the edge.
    const Property* half = block.find("halfSide");
    cube.side =
        block.number("side", half ? 2 * block.number(*half, positive) : cube.side, positive);
    loading.scene.geometries.emplace_back(cube);
}

void read_mesh(Properties& block, Loading& loading) {
    const Property& property = block.required("file");
    const std::filesystem::path file = loading.assets.path(block, property);
    MeshOptions options;
    options.faceted = block.flag("faceted", options.faceted);
    options.auto_smooth = block.flag("autoSmooth", options.auto_smooth);
    options.recenter = block.flag("recenter", options.recenter);
    const bool cull = block.flag("backfaceCulling", false);
    block.accept({"useKDTree"});

    const Place place = loading.diagnostics.place(property.line);
    const std::string ending = lower(file.extension().string());
    if (!std::filesystem::is_regular_file(file)) {
        throw Error(place, fmt::format("{}: does not exist; check the name", file.string()));
    }
    const bool is_gltf = ending == ".glb" || ending == ".gltf";
    Mesh mesh = is_gltf ? read_gltf(file, options, loading)
                        : mesh_of(read_obj(file, loading.diagnostics), options, file);
    mesh.cull_backfaces = cull;
    loading.scene.geometries.emplace_back(std::move(mesh));
}

void add_file_materials(Loading& loading) {
    std::vector<Material>& materials = loading.scene.materials;
    const auto first = static_cast<MaterialId>(materials.size());
    materials.insert(materials.end(), loading.file_materials.begin(), loading.file_materials.end());
    for (Geometry& geometry : loading.scene.geometries) {
        auto* mesh = std::get_if<Mesh>(&geometry);
        if (!mesh) continue;
        for (MaterialId& material : mesh->materials) material += first;
    }
}

void read_heightfield(Properties& block, Loading& loading) {
    constexpr Range blurs{0, 1000};
    constexpr float highest = 1e18f;
    const Property& property = block.required("file");
    const std::filesystem::path file = loading.assets.path(block, property);
    const double blur = block.number("blur", 0, blurs);
    block.accept({"useOptimization"});

    const Place place = loading.diagnostics.place(property.line);
    const Image<Rgb> picture = loading.assets.picture(file, 1, place);
    Image<float> heights(picture.size());
    for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
        const Rgb& pixel = picture.pixels()[i];
        const float height = (pixel.r + pixel.g + pixel.b) / 3;
        if (!(std::abs(height) <= highest)) {
            throw Error(place, fmt::format("{}: pixel ({}, {}) is {}; heights are numbers up to "
                                           "{:g}",
                                           file.string(), i % picture.width(), i / picture.width(),
                                           height, highest));
        }
        heights.pixels()[i] = height;
    }
    loading.scene.geometries.emplace_back(Heightfield(blurred(heights, blur)));
}

}  // namespace luch::loader
