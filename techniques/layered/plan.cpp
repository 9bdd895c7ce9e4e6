#include "techniques/layered/plan.h"

#include "framework/baseline/stages.h"
#include "framework/raster/item_buffer.h"
#include "techniques/layered/planes.h"

#include <fmt/format.h>

#include <algorithm>

namespace luch::techniques::layered {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Depths along the view axis that nodes may be seen at.
struct Range {
    double near = infinite, far = 0;
    void grow(double z) {
        // Where a coordinate has no end, the depth may be anything.
        near = std::min(near, std::isfinite(z) ? std::max(z, 0.0) : 0.0);
        far = std::max(far, std::isfinite(z) ? z : infinite);
    }
};

Range depths_of(const Scene& scene, const Screen& screen) {
    Range range;
    for (const Node& node : scene.nodes) {
        const Boxd box = bounds_of(scene.geometries[node.geometry]);
        if (box.empty()) continue;
        for (unsigned i = 0; i < 8; ++i) {
            const Vec3d corner{i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y,
                               i & 4 ? box.hi.z : box.lo.z};
            range.grow(screen.to_view(node.to_world.point(corner)).z);
        }
    }
    if (!sky_is_plain(scene)) range.far = infinite;
    return range;
}

Stage blur_stage(const Scene& scene, const Shot& shot) {
    const std::string name(stage::blur);
    const Lens lens = lens_of(shot.camera, shot.size);
    if (!(lens.radius > 0)) {
        return {name, false, Stage::exact, "the camera is a pinhole: the baseline's picture"};
    }
    const Range range = depths_of(scene, Screen(shot.camera, shot.size));
    if (!(range.near <= range.far)) {
        return {name, false, Stage::exact, "there is nothing but a sky of one colour"};
    }
    const double most = 2 * std::max(std::abs(signed_radius_px(range.near, lens)),
                                     std::abs(signed_radius_px(range.far, lens)));
    if (most == 0) return {name, false, Stage::exact, "all lies in the plane of focus"};
    if (most < Planes::merged_px) {
        return {name, false, Stage::bounded,
                "no circle of confusion is larger than the bound, in px",
                static_cast<float>(Planes::merged_px)};
    }
    return {
        name, true, Stage::exact,
        fmt::format("circles of confusion of up to {:.3g} px, by the boxes of the nodes", most)};
}

Stage behind_stage(const Scene& scene) {
    const bool something = !scene.nodes.empty();
    return {std::string(stage::behind), something, Stage::exact,
            something ? "the lens sees past edges" : "there is nothing to see past"};
}

/// What the item buffer takes to set up a triangle, in texels that a packet of rays traces in the
/// same time: an estimate.
constexpr double texels_a_triangle = 4;

Stage raster_stage(const Scene& scene, const Shot& shot, const Params& params) {
    std::size_t triangles = 0, meshes = 0;
    for (const Node& node : scene.nodes) {
        const auto* mesh = std::get_if<Mesh>(&scene.geometries[node.geometry]);
        if (mesh == nullptr) continue;
        ++meshes;
        triangles += mesh->triangles.size();
    }
    const double texels = static_cast<double>(shot.size.area()) * params.detail * params.detail;
    const bool mostly = 2 * meshes > scene.nodes.size();
    const bool pays = mostly && static_cast<double>(triangles) * texels_a_triangle < texels;
    return {std::string(stage::raster), pays, Stage::exact,
            pays      ? "most nodes are meshes: their front is rasterised"
            : !mostly ? "most nodes are no meshes: the front is traced"
                      : "triangles are small: the front is traced"};
}

Stage bounded(std::string_view name, std::string_view why) {
    return {std::string(name), false, Stage::bounded, std::string(why),
            static_cast<float>(Planes::merged_px)};
}

}  // namespace

bool sky_is_plain(const Scene& scene) {
    return !scene.environment || std::holds_alternative<ConstantEnvironment>(*scene.environment);
}

Plan plan_of(const Scene& scene, const Shot& shot, const Params& params) {
    if (shot.camera.projection != Projection::perspective) {
        return {false, "the camera is not perspective: it has no thin lens", {}};
    }
    Plan plan{true, "sharp layers are blurred, no rays are shot from the lens", {}};
    plan.stages = classic_stages(scene, shot);
    // The sharp picture is a pinhole's.
    std::erase_if(plan.stages, [](const Stage& each) { return each.name == "lens"; });
    plan.stages.push_back(blur_stage(scene, shot));
    if (!shot.camera.has_lens()) plan.why = "the camera is a pinhole: the baseline's picture";
    plan.stages.push_back(behind_stage(scene));
    plan.stages.push_back(raster_stage(scene, shot, params));
    plan.stages.push_back(bounded(
        stage::thin, "layers whose circles of confusion differ by less than this, in px, are one"));
    plan.stages.push_back(
        bounded(stage::small, "circles of confusion smaller than this, in px, are points"));
    plan.stages.push_back({std::string(stage::detail), false, Stage::heuristic,
                           "pixels that are blurred over more than the bound, in px, are lit once",
                           lit_once_px});
    return plan;
}

}  // namespace luch::techniques::layered
