#include "techniques/shadow_map/plan.h"

#include "framework/baseline/stages.h"
#include "techniques/shadow_map/content.h"
#include "techniques/shadow_map/raster.h"

#include <fmt/format.h>

#include <algorithm>

namespace luch::techniques::shadow_map {
namespace {

/// Where a light that has a place shines from.
std::optional<Vec3d> place_of(const Light& light) {
    if (const auto* point = std::get_if<PointLight>(&light)) return point->position;
    if (const auto* spot = std::get_if<SpotLight>(&light)) return spot->position;
    if (const auto* rect = std::get_if<RectLight>(&light)) return rect->to_world.offset;
    return std::nullopt;
}

/// What the lights of a scene are to maps.
struct LightCount {
    std::size_t points = 0;   ///< that maps are made around
    std::size_t by_rays = 0;  ///< that have none
};

LightCount lights_of(const Scene& scene, const Params& params) {
    LightCount count;
    for (const Light& light : scene.lights) {
        const bool area = std::holds_alternative<RectLight>(light);
        const bool exact = Mode(params.mode) == Mode::exact;
        if (!place_of(light) || (area && exact)) {
            ++count.by_rays;
        } else {
            const bool many = area && Mode(params.mode) != Mode::pcss;
            count.points += many ? static_cast<std::size_t>(params.points) : 1;
        }
    }
    return count;
}

/// Certainly outside of a convex shape.
bool is_outside(const Geometry& geometry, const Vec3d& local) {
    constexpr double margin = 1 + 1e-6;
    if (const auto* sphere = std::get_if<Sphere>(&geometry)) {
        return glm::length(local - sphere->centre) > margin * sphere->radius;
    }
    const auto* cube = std::get_if<Cube>(&geometry);
    return cube != nullptr && max_norm(local - cube->centre) > margin * cube->side / 2;
}

Stage maps_stage(const Scene& scene, const Params& params) {
    const std::string name(stage::maps);
    const LightCount lights = lights_of(scene, params);
    if (lights.points == 0) {
        return {name, false, Stage::exact, "no light has a place that a map can look from"};
    }
    if (scene.nodes.empty()) return {name, false, Stage::exact, "nothing casts a shadow"};
    if (!has_receivers(scene)) {
        return {name, false, Stage::exact,
                "light falls on nothing: all is unlit, mirrors or clear"};
    }
    std::string why = fmt::format("{} points of light", lights.points);
    if (lights.by_rays > 0) {
        why += fmt::format("; {} lights are left to shadow rays: {}", lights.by_rays,
                           Mode(params.mode) == Mode::exact
                               ? "they are infinitely far, or have an area"
                               : "they are infinitely far");
    }
    return {name, true, Stage::exact, why};
}

Stage convex_stage(const Scene& scene, const Params& params) {
    const Mode mode = Mode(params.mode);
    const bool bleeds = mode == Mode::vsm || mode == Mode::msm;
    const bool lone = is_lone_convex(scene);
    return {std::string(stage::convex), !lone, lone && bleeds ? Stage::heuristic : Stage::exact,
            lone ? "one convex thing: what faces the light is lit"
                 : "there is not just one convex thing"};
}

/// Upper bound of a texel's width in pixels, on what faces the light as much as the camera.
double widest_texel_px(const Scene& scene, const Content& content, const Shot& shot, int side) {
    const Screen screen(shot.camera, shot.size);
    const double px_per_unit = shot.size.height / (2 * screen.half_height());
    double widest = 0;
    for (const Content::Thing& thing : content.things()) {
        if (!thing.receives || thing.box.empty()) continue;
        double nearest = std::numeric_limits<double>::infinity();
        for (unsigned i = 0; i < 8; ++i) {
            const Boxd& box = thing.box;
            const Vec3d corner{i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y,
                               i & 4 ? box.hi.z : box.lo.z};
            const double z = screen.to_view(corner).z;
            nearest = std::min(nearest, std::isfinite(z) ? std::max(z, 0.0) : 0.0);
        }
        for (const Light& light : scene.lights) {
            const std::optional<Vec3d> place = place_of(light);
            if (!place) continue;
            const Vec3d off =
                glm::max(glm::abs(thing.box.lo - *place), glm::abs(thing.box.hi - *place));
            widest = std::max(widest, 2.0 / side * glm::length(off) * px_per_unit / nearest);
        }
    }
    return widest;
}

Stage filter_stage(const Scene& scene, const Shot& shot, const Params& params) {
    const std::string name(stage::filter);
    if (Mode(params.mode) != Mode::classic || !params.pcf) {
        return {name, false, Stage::heuristic, "it is not asked for"};
    }
    if (shot.camera.projection != Projection::perspective) {
        return {name, true, Stage::exact, "the camera is not perspective"};
    }
    const double widest = widest_texel_px(scene, Content(scene), shot, params.side);
    if (widest < filtered_px) {
        return {name, false, Stage::bounded,
                "no texel is wider than the bound, in px, so a shadow's edge moves by less",
                filtered_px};
    }
    return {name, true, Stage::exact,
            std::isfinite(widest) ? fmt::format("texels are up to {:.2g} px wide", widest)
                                  : "texels may be of any width in pixels"};
}

/// Packets of rays and the rasteriser see the same surfaces; distances differ in their last bits.
Stage raster_stage(const Scene& scene, const Params& params) {
    const bool pays = Mode(params.mode) != Mode::exact && raster_pays(scene, params.side);
    return {std::string(stage::raster), pays, Stage::bounded,
            pays ? "most nodes are meshes of few triangles: whole faces are rasterised, about "
                   "twice as fast as packets of rays"
                 : "packets of rays fill the maps: things are no meshes, or their triangles are "
                   "small; the bound is of a distance",
            rounding_share};
}

/// Shadow rays in packets are about as quick as a look at a map where they meet no more nodes than
/// this (measured: 13 to 61 nodes 0.6–1.1 ×, 9,000 nodes 1.3–1.5 × as quick with maps).
constexpr std::size_t few_nodes = 200;

/// Shadow rays are as many as pixels, a light; maps that stand still are made once.
std::string worth(const Scene& scene, const Shot& shot, const Params& params) {
    const LightCount lights = lights_of(scene, params);
    const auto maps = static_cast<double>(scene.lights.size() - lights.by_rays);
    const double texels = maps * faces_of_cube * params.side * params.side;
    const double rays = static_cast<double>(shot.size.area()) *
                        static_cast<double>(scene.lights.size()) * std::max(shot.spp, 1);
    const bool moving = std::ranges::any_of(scene.nodes, &Node::moving);
    if (moving && texels > rays) {
        return fmt::format(
            "does not pay: things move, and of up to {:.3g} M texels those that see them are "
            "filled anew each frame, against {:.3g} M shadow rays",
            texels * 1e-6, rays * 1e-6);
    }
    if (scene.nodes.size() <= few_nodes) {
        return fmt::format(
            "does not pay by time: among {} nodes packets of shadow rays are as quick as maps, but "
            "up to {:.3g} M rays a frame are spared",
            scene.nodes.size(), rays * 1e-6);
    }
    return fmt::format(
        "up to {:.3g} M texels are filled once, in the place of {:.3g} M shadow rays a frame: it "
        "{} where things stand still",
        texels * 1e-6, rays * 1e-6,
        texels > rays ? fmt::format("pays after {:.0f} frames", std::ceil(texels / rays))
                      : "pays from the first frame");
}

}  // namespace

bool is_lone_convex(const Scene& scene) {
    if (scene.nodes.size() != 1) return false;
    const Node& node = scene.nodes[0];
    const Geometry& geometry = scene.geometries[node.geometry];
    const bool convex =
        std::holds_alternative<Sphere>(geometry) || std::holds_alternative<Cube>(geometry);
    if (!convex || node.bump != no_texture) return false;
    return std::ranges::all_of(scene.lights, [&](const Light& light) {
        const std::optional<Vec3d> place = place_of(light);
        return !place || is_outside(geometry, node.to_object.point(*place));
    });
}

bool has_receivers(const Scene& scene) {
    return std::ranges::any_of(Content(scene).things(), &Content::Thing::receives);
}

Plan plan_of(const Scene& scene, const Shot& shot, const Params& params) {
    Plan plan{true, "", classic_stages(scene, shot)};
    plan.stages.push_back(maps_stage(scene, params));
    if (plan.stages.back().needed) {
        plan.why = worth(scene, shot, params);
    } else {
        plan.why = "does not pay: " + plan.stages.back().why + "; the baseline's picture";
    }
    plan.stages.push_back(convex_stage(scene, params));
    plan.stages.push_back({std::string(stage::empty_faces), false, Stage::exact,
                           "nothing receives light through them"});
    plan.stages.push_back(filter_stage(scene, shot, params));
    plan.stages.push_back(raster_stage(scene, params));
    plan.stages.push_back(
        {std::string(stage::memory), true, Stage::exact,
         fmt::format("lights whose maps do not fit into {} MB are left to rays", params.memory)});
    return plan;
}

}  // namespace luch::techniques::shadow_map
