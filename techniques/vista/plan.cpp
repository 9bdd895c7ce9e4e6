#include "techniques/vista/plan.h"

#include "framework/baseline/classic.h"
#include "techniques/vista/exact.h"

#include <fmt/format.h>

namespace luch::techniques::vista {
namespace {

template <class Shape>
std::size_t nodes_with(const Scene& scene) {
    return std::count_if(scene.nodes.begin(), scene.nodes.end(), [&](const Node& node) {
        return std::holds_alternative<Shape>(scene.geometries[node.geometry]);
    });
}

/// The corners of the box around a node, in view space.
std::array<Vec3d, 8> corners_in_view(const Scene& scene, const Node& node, const Screen& screen) {
    const Boxd box = bounds_of(scene.geometries[node.geometry]);
    std::array<Vec3d, 8> corners;
    for (unsigned i = 0; i < 8; ++i) {
        const Vec3d corner{i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y,
                           i & 4 ? box.hi.z : box.lo.z};
        corners[i] = screen.to_view(node.to_world.point(corner));
    }
    return corners;
}

/// Certainly inside: by more than what rounding may do to a corner.
bool certainly_inside(const Scene& scene, const Node& node, const Screen& screen,
                      const Frustum& frustum) {
    constexpr double margin = 1e-9;
    for (const Vec3d& corner : corners_in_view(scene, node, screen)) {
        if (!all_finite(corner)) return false;
        for (const Vec3d& inward : frustum.inward) {
            if (!(glm::dot(inward, corner) > margin * max_norm(corner) * max_norm(inward))) {
                return false;
            }
        }
    }
    return true;
}

std::size_t crossing_nodes(const Scene& scene, const Screen& screen) {
    const Frustum frustum = frustum_of(screen);
    return std::count_if(scene.nodes.begin(), scene.nodes.end(), [&](const Node& node) {
        return !certainly_inside(scene, node, screen, frustum);
    });
}

/// Triangles of all meshes, once for every node that shows them.
std::uint64_t instanced_triangles(const Scene& scene) {
    std::uint64_t count = 0;
    for (const Node& node : scene.nodes) {
        const auto* mesh = std::get_if<Mesh>(&scene.geometries[node.geometry]);
        if (mesh != nullptr) count += mesh->triangles.size();
    }
    return count;
}

Stage lod_stage(const Scene& scene, const Params& params) {
    const std::size_t spheres = nodes_with<Sphere>(scene);
    if (params.segments != 0) {
        return {"lod", false, Stage::exact, fmt::format("segments = {}", params.segments)};
    }
    return {"lod", spheres > 0, Stage::exact,
            spheres > 0 ? fmt::format("{} spheres", spheres)
                        : "no spheres: every shape has triangles of its own"};
}

Stage clip_stage(const Scene& scene, const Screen& screen, const Params& params) {
    const std::size_t crossing = crossing_nodes(scene, screen);
    if (crossing == 0 && Repair(params.repair) != Repair::none && nodes_with<Sphere>(scene) > 0) {
        return {"clip", true, Stage::exact, "polyhedra around spheres may leave the view volume"};
    }
    return {"clip", crossing > 0, Stage::exact,
            crossing > 0 ? fmt::format("{} nodes are not wholly in the view volume", crossing)
                         : "every node is wholly in the view volume"};
}

Stage sort_stage(const Scene& scene, const Params& params) {
    const std::size_t nodes = scene.nodes.size();
    if (Hidden(params.hidden) == Hidden::depth) {
        return {"sort", false, Stage::exact, "depths are compared, in any order"};
    }
    return {"sort", nodes > 1, Stage::exact,
            nodes > 1 ? fmt::format("{} nodes may hide one another", nodes)
                      : "there is nothing for one node to hide (the depth plane is not sorted)"};
}

/// A solid that the sides of its box cannot stand for.
const Node* boundless_solid(const Scene& scene) {
    for (const Node& node : scene.nodes) {
        const auto* csg = std::get_if<Csg>(&scene.geometries[node.geometry]);
        if (csg && !csg->bounds.empty() &&
            !(all_finite(csg->bounds.lo) && all_finite(csg->bounds.hi))) {
            return &node;
        }
    }
    return nullptr;
}

/// What the framework's buffer takes to set up a triangle, in pixels that a packet of rays traces
/// in the time that it has left for that: measured, see README.md.
constexpr double pixels_a_triangle = 30;
/// The same of the classic steps, roughly.
constexpr double classic_pixels_a_triangle = 8;

Stage buffer_stage(const Scene& scene, const Shot& shot) {
    const std::size_t others = scene.nodes.size() - nodes_with<Mesh>(scene);
    const auto triangles = static_cast<double>(instanced_triangles(scene));
    const double ratio = triangles / static_cast<double>(shot.size.area());
    if (others > 0) {
        return {"item buffer", false, Stage::exact,
                fmt::format("does not pay: {} nodes are no meshes, which packets of rays meet as "
                            "fast as their hulls are drawn",
                            others)};
    }
    const bool pays = ratio * pixels_a_triangle < 1;
    return {
        "item buffer", pays, Stage::exact,
        pays ? fmt::format("{:.2g} triangles a pixel", ratio)
             : fmt::format("does not pay: {:.2g} triangles a pixel to set up, instances counted, "
                           "take longer than tracing the pixels",
                           ratio)};
}

Stage stand_in_stage(const Scene& scene) {
    const std::size_t others = scene.nodes.size() - nodes_with<Mesh>(scene);
    return {"stand-ins", others > 0, Stage::exact,
            others > 0 ? fmt::format("{} nodes are no meshes: hulls stand for them", others)
                       : "every node is a mesh"};
}

Plan exact_plan(const Scene& scene, const Shot& shot, const Params& params) {
    if (instanced_triangles(scene) > ExactBuffer::most_triangles) {
        return {false, "more than 2^31 triangles, instances counted: they have no numbers", {}};
    }
    Plan plan{true, "", classic_stages(scene, shot)};
    const Stage buffer = buffer_stage(scene, shot);
    plan.why = buffer.needed ? "the baseline's picture; primary hits without a search" : buffer.why;
    plan.stages.push_back(buffer);
    plan.stages.push_back(stand_in_stage(scene));
    plan.stages.push_back(lod_stage(scene, params));
    return plan;
}

Plan classic_plan(const Scene& scene, const Shot& shot, const Params& params) {
    constexpr std::uint64_t most_triangles = 1 << 23;
    const std::uint64_t count = instanced_triangles(scene);
    if (count > most_triangles) {
        return {false,
                fmt::format("{} triangles, instances counted: the buffer holds each of them, and "
                            "more than {} are too many",
                            count, most_triangles),
                {}};
    }
    if (const Node* node = boundless_solid(scene)) {
        return {
            false,
            fmt::format("the solid \"{}\" has no end: no triangles can stand for it", node->name),
            {}};
    }
    const Screen screen(shot.camera, shot.size);
    Plan plan{true, "one object test a covered pixel instead of a search", {}};
    const double ratio = static_cast<double>(count) / static_cast<double>(shot.size.area());
    if (ratio * classic_pixels_a_triangle > 1) {
        plan.why = fmt::format("does not pay: {:.2g} triangles a pixel, instances counted", ratio);
    }
    plan.stages = classic_stages(scene, shot);
    plan.stages.push_back(lod_stage(scene, params));
    plan.stages.push_back(clip_stage(scene, screen, params));
    plan.stages.push_back(sort_stage(scene, params));
    return plan;
}

}  // namespace

float radius_px(const Scene& scene, const Node& node, const Screen& screen) {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    const Boxd box = bounds_of(scene.geometries[node.geometry]);
    if (box.empty()) return 0;
    if (!all_finite(box.lo) || !all_finite(box.hi)) return infinite;
    double longest_axis = 0;
    for (const Vec3d& axis : {Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)}) {
        longest_axis = std::max(longest_axis, glm::length(node.to_world.direction(axis)));
    }
    const double radius = max_norm(box.size()) / 2 * longest_axis;
    const Vec3d centre = screen.to_view(node.to_world.point(box.centre()));
    const double tangent_squared = glm::dot(centre, centre) - radius * radius;
    if (!(tangent_squared > 0)) return infinite;
    const double pixels_at_one = screen.size().width / (2 * screen.half_width());
    return static_cast<float>(radius / std::sqrt(tangent_squared) * pixels_at_one);
}

Plan plan_of(const Scene& scene, const Shot& shot, const Params& params) {
    if (shot.camera.projection != Projection::perspective) {
        return {false,
                "the camera is not perspective: only there are the edges of triangles straight on "
                "the screen, and their rays from one point",
                {}};
    }
    if (shot.camera.has_lens()) {
        return {
            false,
            "depth of field: rays leave from all over the lens, the buffer is seen from one point",
            {}};
    }
    if (shot.spp > 1) {
        return {false,
                fmt::format("{} samples a pixel: the buffer knows what the pixels' centres see",
                            shot.spp),
                {}};
    }
    return Mode(params.mode) == Mode::exact ? exact_plan(scene, shot, params)
                                            : classic_plan(scene, shot, params);
}

}  // namespace luch::techniques::vista
