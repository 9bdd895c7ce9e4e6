#pragma once

#include "framework/accel/heightfield_hit.h"

namespace luch {

/// Where a ray first passes from inside to outside of a solid, or the other way round, with
/// t_min < t < t_max. A ray is inside a part when it has an odd number of crossings with it ahead,
/// beyond t_max too; crossings at the same t count as one event. Sorts the crossings. The hit's
/// node is left open; its primitive tells the part and the part's own primitive.
std::optional<Hit> first_change(const Csg& csg, Crossings& crossings, const Ray& ray);

/// Adds the crossings of a geometry that is neither a mesh nor a solid.
void find_crossings(const Geometry& geometry, const Ray& ray, Crossings& crossings,
                    WorkCounts& work);

/// Where a ray meets a solid. in_mesh(geometry, mesh, object ray, crossings) adds all crossings of
/// a mesh, however it finds them.
template <class InMesh>
std::optional<Hit> intersect(const Csg& csg, const std::vector<Geometry>& geometries,
                             const Ray& ray, WorkCounts& work, InMesh&& in_mesh) {
    if (csg.bounds.empty()) return std::nullopt;
    Crossings crossings(ray);
    for (std::uint32_t i = 0; i < csg.parts.size(); ++i) {
        crossings.begin(i);
        const Csg::Part& part = csg.parts[i];
        const Geometry& geometry = geometries[part.geometry];
        if (const auto* mesh = std::get_if<Mesh>(&geometry)) {
            ObjectRay in_frame = object_ray(part.to_frame.ray(ray));
            in_frame.t_max = std::numeric_limits<float>::infinity();
            in_mesh(part.geometry, *mesh, in_frame, crossings);
        } else {
            find_crossings(geometry, ray, crossings, work);
        }
    }
    return first_change(csg, crossings, ray);
}

}  // namespace luch
