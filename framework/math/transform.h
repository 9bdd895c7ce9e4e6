#pragma once

#include "framework/math/bounds.h"
#include "framework/math/ray.h"
#include "framework/math/vec.h"

namespace luch {

/// The largest entry of a matrix, by its size.
[[nodiscard]] double max_norm(const glm::dmat3& matrix);

/// p' = p · matrix + offset, the course's row-vector convention, in double.
/// glm stores columns, so `p * matrix` is the row vector times the matrix as written on paper.
struct Transform {
    glm::dmat3 matrix{1};
    Vec3d offset{0};

    [[nodiscard]] Vec3d point(const Vec3d& p) const { return p * matrix + offset; }
    [[nodiscard]] Vec3d direction(const Vec3d& d) const { return d * matrix; }
    /// A normal of the space that `inverse` leads back to: multiplied by the inverse's transpose.
    /// Call it on the *inverse* of the transform that moves the surface. Not normalised.
    [[nodiscard]] Vec3d normal_back(const Vec3d& n) const { return matrix * n; }
    [[nodiscard]] Ray ray(const Ray& r) const {
        return {point(r.origin), direction(r.direction), r.t_min, r.t_max};
    }
    /// The box around the eight moved corners; infinite sides stay infinite.
    [[nodiscard]] Boxd box(const Boxd& b) const;
    /// First this, then `next`.
    [[nodiscard]] Transform then(const Transform& next) const {
        return {matrix * next.matrix, offset * next.matrix + next.offset};
    }
    /// Throws std::domain_error when the matrix is singular or not finite.
    [[nodiscard]] Transform inverse() const;
    static Transform translation(const Vec3d& by) { return {glm::dmat3(1), by}; }
    static Transform scaling(const Vec3d& by);
    /// Rz(roll) · Rx(pitch) · Ry(yaw), angles in radians, as scene-format documents it.
    static Transform rotation(double yaw, double pitch, double roll);
};

}  // namespace luch
