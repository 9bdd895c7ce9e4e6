#include "framework/accel/shape_packets.h"

#include "framework/accel/node_hit.h"

namespace luch {

bool meet(const Geometry& geometry, const Transform* to_object, const RayPacket& rays,
          const wide::Kernels& kernels, wide::ShapeHits& hits) {
    const Vec3d origin = to_object != nullptr ? to_object->point(rays.origin) : rays.origin;
    const wide::ShapeRays seen{&rays, to_object, shape_ray({origin}).origin};
    if (const auto* plane = std::get_if<Plane>(&geometry)) {
        kernels.meet_plane(*plane, seen, hits);
    } else if (const auto* sphere = std::get_if<Sphere>(&geometry)) {
        kernels.meet_sphere(*sphere, seen, hits);
    } else if (const auto* cube = std::get_if<Cube>(&geometry)) {
        kernels.meet_cube(*cube, seen, hits);
    } else {
        return false;
    }
    if (all_finite(rays.origin)) return true;
    std::fill_n(hits.t, rays.count, std::numeric_limits<float>::infinity());
    return true;
}

}  // namespace luch
