#include "homework/vista/mutants/mutants.h"

#include <cmath>
#include <numbers>

namespace luch::homework::vista {
namespace {

using namespace techniques::vista;

/// The bounds are forgotten: 2 segments for a distant sphere, a million for a near one.
int unbounded(const Geometry& geometry, float radius_px) {
    if (!std::holds_alternative<Sphere>(geometry)) return 0;
    const double n = std::numbers::pi * std::sqrt(std::min(radius_px, 1e9f) / 0.25);
    return static_cast<int>(2 * std::ceil(n / 2));
}

/// n grows with the radius, not with its root.
int proportional(const Geometry& geometry, float radius_px) {
    if (!std::holds_alternative<Sphere>(geometry)) return 0;
    const double even = 2 * std::ceil(std::min(radius_px, 1e6f) / 2);
    return static_cast<int>(std::clamp(even, double(least_segments), double(most_segments)));
}

int of_every_shape(const Geometry&, float radius_px) {
    return reference().lod(Sphere{}, radius_px);
}

/// Seen from the other side: only spheres are changed, by a factor.
template <class Change>
void changed(const Geometry& geometry, int n, std::vector<Tri>& triangles, const Change& change) {
    Geometry other = geometry;
    change(other);
    reference().tessellate(other, n, triangles);
}

void smaller_spheres(const Geometry& geometry, int n, std::vector<Tri>& triangles) {
    changed(geometry, n, triangles, [](Geometry& other) {
        if (auto* sphere = std::get_if<Sphere>(&other)) sphere->radius /= 2;
    });
}

void centre_forgotten(const Geometry& geometry, int n, std::vector<Tri>& triangles) {
    changed(geometry, n, triangles, [](Geometry& other) {
        if (auto* sphere = std::get_if<Sphere>(&other)) sphere->centre = Vec3d(0);
    });
}

void side_for_half_a_side(const Geometry& geometry, int n, std::vector<Tri>& triangles) {
    changed(geometry, n, triangles, [](Geometry& other) {
        if (auto* cube = std::get_if<Cube>(&other)) cube->side *= 2;
    });
}

void finite_floor(const Geometry& geometry, int n, std::vector<Tri>& triangles) {
    changed(geometry, n, triangles, [](Geometry& other) {
        if (auto* plane = std::get_if<Plane>(&other)) plane->limit = std::min(plane->limit, 4.0);
    });
}

/// cos 2π is taken for cos 0: the last meridian is not the first to the last bit.
void open_seam(const Geometry& geometry, int n, std::vector<Tri>& triangles) {
    reference().tessellate(geometry, n, triangles);
    if (!std::holds_alternative<Sphere>(geometry)) return;
    for (std::size_t i = 0; i < triangles.size(); i += 7) {
        double& z = triangles[i].corners[1].p.z;
        z = std::nextafter(z, 2 * z + 1);
    }
}

/// Only one triangle of every two.
void half_the_triangles(const Geometry& geometry, int n, std::vector<Tri>& triangles) {
    std::vector<Tri> all;
    reference().tessellate(geometry, n, all);
    triangles.clear();
    for (std::size_t i = 0; i < all.size(); i += 2) triangles.push_back(all[i]);
}

}  // namespace

std::vector<grading::Other> shape_mutants() {
    return {
        {"lod_unbounded", "vista.t1", "least_segments and most_segments are not kept",
         with(&Steps::lod, unbounded)},
        {"lod_proportional", "vista.t1", "n grows with the radius instead of its square root",
         with(&Steps::lod, proportional)},
        {"lod_of_every_shape", "vista.t1", "shapes that are no spheres have segments, too",
         with(&Steps::lod, of_every_shape)},
        {"radius_halved", "vista.t2", "the radius is taken for the diameter",
         with(&Steps::tessellate, smaller_spheres)},
        {"centre_forgotten", "vista.t2", "the sphere's centre is forgotten",
         with(&Steps::tessellate, centre_forgotten)},
        {"cube_doubled", "vista.t2", "the cube's side is taken for half of it",
         with(&Steps::tessellate, side_for_half_a_side)},
        {"finite_floor", "vista.t2", "the infinite plane ends somewhere",
         with(&Steps::tessellate, finite_floor)},
        {"open_seam", "vista.t2", "neighbours do not share their corners to the last bit",
         with(&Steps::tessellate, open_seam)},
        {"half_the_triangles", "vista.t2", "one triangle a face instead of two",
         with(&Steps::tessellate, half_the_triangles)},
    };
}

}  // namespace luch::homework::vista
