#include "techniques/ssao/plan.h"

#include "framework/baseline/stages.h"
#include "framework/scene/census.h"
#include "techniques/ssao/slices.h"
#include "techniques/ssao/view.h"

#include <fmt/format.h>

#include <algorithm>

namespace luch::techniques::ssao {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The nodes' boxes in the world, those without an end too. A geometry's own is found once.
std::vector<Boxd> boxes_of(const Scene& scene) {
    std::vector<Boxd> own, world;
    for (const Geometry& geometry : scene.geometries) own.push_back(bounds_of(geometry));
    for (const Node& node : scene.nodes) world.push_back(node.to_world.box(own[node.geometry]));
    return world;
}

/// A quarter of what nodes usually measure, those without an end left out.
double usual_radius(const std::vector<Boxd>& boxes) {
    std::vector<double> sizes;
    for (const Boxd& box : boxes) {
        if (box.empty()) continue;
        const double size = glm::length(box.size());
        if (size > 0 && size < infinite) sizes.push_back(size);
    }
    if (sizes.empty()) return 1;
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::ranges::nth_element(sizes, middle);
    return *middle / 4;
}

/// Whether nothing of a shape can be between its outside, where the eye is, and the sky.
bool is_convex_from(const Geometry& geometry, const Vec3d& eye) {
    if (std::holds_alternative<Plane>(geometry)) return true;
    if (const auto* sphere = std::get_if<Sphere>(&geometry)) {
        return glm::length(eye - sphere->centre) > sphere->radius;
    }
    if (const auto* cube = std::get_if<Cube>(&geometry)) {
        return max_norm(eye - cube->centre) > cube->side / 2;
    }
    const auto* mesh = std::get_if<Mesh>(&geometry);
    return mesh != nullptr && mesh->triangles.size() == 1;
}

Stage occlusion_stage(const Scene& scene, const Params& params) {
    const std::string name(stage::occlusion);
    if (Show(params.show) == Show::visibility) return {name, true, Stage::exact, "it is shown"};
    if (scene.settings.ambient_light == Rgb(0)) {
        return {name, false, Stage::exact, "there is no ambient light"};
    }
    const bool lit = census_of(scene).lit > 0;
    return {
        name, lit, Stage::exact,
        lit ? fmt::format("ambient light is kept away by what is nearer than {:.3g}", params.radius)
            : "ambient light shines on nothing"};
}

Stage convex_stage(const Scene& scene, const Shot& shot, const Params& params) {
    const std::string name(stage::convex);
    const bool alone = scene.nodes.empty() ||
                       (scene.nodes.size() == 1 &&
                        is_convex_from(scene.geometries[scene.nodes[0].geometry],
                                       scene.nodes[0].to_object.point(shot.camera.position)));
    // Normals that are found in the picture are not quite those of the surface.
    const bool exact =
        Mode(params.mode) == Mode::rays || Normals(params.normals) == Normals::surface;
    return {name, !alone, alone && !exact ? Stage::heuristic : Stage::exact,
            alone
                ? "there is one convex thing at most, seen from outside: it hides nothing of itself"
                : "things may hide one another"};
}

/// The smallest depth that a node may be seen at; 0 where that is not known.
double nearest_depth(const std::vector<Boxd>& boxes, const Screen& screen) {
    double nearest = infinite;
    for (const Boxd& box : boxes) {
        if (box.empty()) continue;
        for (unsigned i = 0; i < 8; ++i) {
            const Vec3d corner{i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y,
                               i & 4 ? box.hi.z : box.lo.z};
            const double z = screen.to_view(corner).z;
            nearest = std::min(nearest, std::isfinite(z) ? std::max(z, 0.0) : 0.0);
        }
    }
    return nearest;
}

Stage small_stage(const Scene& scene, const Shot& shot, const Params& params) {
    const std::string name(stage::small);
    const Screen screen(shot.camera, shot.size);
    const double nearest = nearest_depth(boxes_of(scene), screen);
    const float px = Scale(screen).px(static_cast<float>(params.radius), float(nearest));
    constexpr float least_px = 1;
    if (px < least_px) {
        return {name, false, Stage::bounded,
                "the radius spans less than the bound, in px: no pixel farther from an edge loses "
                "any light",
                least_px};
    }
    return {name, true, Stage::exact, fmt::format("the radius spans up to {:.3g} px", px)};
}

}  // namespace

Params settled(const Params& params, const Scene& scene) {
    Params full = params;
    if (full.samples == 0) {
        switch (Mode(params.mode)) {
            case Mode::bitmask:
            case Mode::gtao:
                full.samples = samples_a_slice;
                break;
            case Mode::classic:
                full.samples = 32;
                break;
            case Mode::rays:
                full.samples = 256;
                break;
        }
    }
    if (!(full.radius > 0)) full.radius = usual_radius(boxes_of(scene));
    return full;
}

Plan plan_of(const Scene& scene, const Shot& shot, const Params& params) {
    const bool rays = Mode(params.mode) == Mode::rays;
    if (!rays && shot.camera.projection != Projection::perspective) {
        return {false, "the camera is not perspective: the picture is no section of the view", {}};
    }
    if (!rays && shot.camera.has_lens()) {
        return {false, "the camera has a lens (dof): no one picture holds what it sees", {}};
    }
    const Params full = settled(params, scene);
    Plan plan{true, rays ? "ambient light by rays" : "ambient light by what the picture shows",
              classic_stages(scene, shot)};
    plan.stages.push_back(occlusion_stage(scene, full));
    plan.stages.push_back(convex_stage(scene, shot, full));
    if (!rays) plan.stages.push_back(small_stage(scene, shot, full));
    return plan;
}

}  // namespace luch::techniques::ssao
