#include "framework/accel/accelerator.h"
#include "framework/accel/mesh_bvh.h"
#include "framework/accel/node_hit.h"
#include "framework/accel/shapes.h"

namespace luch {
namespace {

void closest_in_geometry(const Mesh& mesh, const Ray& ray, NodeId node, Hit& best) {
    const ObjectRay object = object_ray(ray);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        improve(object, mesh.corner(i, 0), mesh.corner(i, 1), mesh.corner(i, 2),
                mesh.cull_backfaces, node, i, best);
    }
}

template <class Shape>
void closest_in_geometry(const Shape& shape, const Ray& ray, NodeId node, Hit& best) {
    improve_with_shape(shape, ray, node, best);
}

}  // namespace

Hit closest_brute(const Scene& scene, const Ray& ray) {
    if (!is_sound(ray)) return {};
    Hit best = no_hit_before(ray);
    for (NodeId id = 0; id < scene.nodes.size(); ++id) {
        const Node& node = scene.nodes[id];
        const Ray object = to_object(ray, node);
        std::visit([&](const auto& shape) { closest_in_geometry(shape, object, id, best); },
                   scene.geometries[node.geometry]);
    }
    return best ? best : Hit{};
}

}  // namespace luch
