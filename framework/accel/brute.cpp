#include "framework/accel/accelerator.h"
#include "framework/accel/mesh_bvh.h"
#include "framework/accel/node_hit.h"
#include "framework/accel/shapes.h"

namespace luch {
namespace {

void closest_in_mesh(const Mesh& mesh, const Ray& ray, NodeId node, Hit& best) {
    const ObjectRay object = object_ray(ray);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        improve(object, mesh.corner(i, 0), mesh.corner(i, 1), mesh.corner(i, 2),
                mesh.cull_backfaces, node, i, best);
    }
}

void all_crossings(GeometryId, const Mesh& mesh, const ObjectRay& ray, Crossings& crossings) {
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        TriangleHit hit;
        if (cross_triangle(ray, mesh.corner(i, 0), mesh.corner(i, 1), mesh.corner(i, 2), hit)) {
            crossings.add(hit, i);
        }
    }
}

}  // namespace

Hit closest_brute(const Scene& scene, const Ray& ray) {
    if (!is_sound(ray)) return {};
    Hit best = no_hit_before(ray);
    WorkCounts work;
    for (NodeId id = 0; id < scene.nodes.size(); ++id) {
        const Node& node = scene.nodes[id];
        const Ray object = to_object(ray, node);
        if (const auto* mesh = std::get_if<Mesh>(&scene.geometries[node.geometry])) {
            closest_in_mesh(*mesh, object, id, best);
        } else {
            improve_with_shape(scene, node.geometry, object, id, best, work, all_crossings);
        }
    }
    return best ? best : Hit{};
}

}  // namespace luch
