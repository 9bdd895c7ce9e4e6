#include "framework/math/transform.h"

#include <glm/matrix.hpp>

#include <stdexcept>

namespace luch {
namespace {

/// The matrix with these rows, as written on paper.
glm::dmat3 from_rows(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    return glm::transpose(glm::dmat3(a, b, c));
}

/// a · b where an infinite b is not spoilt by a zero a.
double product(double a, double b) {
    return a == 0 ? 0 : a * b;
}

}  // namespace

double max_norm(const glm::dmat3& matrix) {
    return max_norm(Vec3d(max_norm(matrix[0]), max_norm(matrix[1]), max_norm(matrix[2])));
}

Boxd Transform::box(const Boxd& b) const {
    if (b.empty()) return {};
    Boxd result{offset, offset};
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            const double from_lo = product(matrix[column][row], b.lo[row]);
            const double from_hi = product(matrix[column][row], b.hi[row]);
            result.lo[column] += std::min(from_lo, from_hi);
            result.hi[column] += std::max(from_lo, from_hi);
        }
    }
    return result;
}

Transform Transform::inverse() const {
    // Scaled to entries of about 1 first, so that uniform scales of 1e-30 or 1e30 are no trouble.
    const double scale = max_norm(matrix);
    const glm::dmat3 unit = matrix * (1 / scale);
    const double determinant = glm::determinant(unit);
    const glm::dmat3 back = glm::inverse(unit) * (1 / scale);
    // Above 1/ulp the inverse would hold no correct digit.
    const double condition = max_norm(unit) * max_norm(back) * scale;
    if (!std::isfinite(scale) || !(std::abs(determinant) > 0) || !(condition < 1e15)) {
        throw std::domain_error("singular transform");
    }
    return {back, -(offset * back)};
}

Transform Transform::scaling(const Vec3d& by) {
    return {from_rows({by.x, 0, 0}, {0, by.y, 0}, {0, 0, by.z}), Vec3d(0)};
}

Transform Transform::rotation(double yaw, double pitch, double roll) {
    const double cy = std::cos(yaw), sy = std::sin(yaw);
    const double cx = std::cos(pitch), sx = std::sin(pitch);
    const double cz = std::cos(roll), sz = std::sin(roll);
    const glm::dmat3 about_x = from_rows({1, 0, 0}, {0, cx, -sx}, {0, sx, cx});
    const glm::dmat3 about_y = from_rows({cy, 0, sy}, {0, 1, 0}, {-sy, 0, cy});
    const glm::dmat3 about_z = from_rows({cz, -sz, 0}, {sz, cz, 0}, {0, 0, 1});
    return {about_z * about_x * about_y, Vec3d(0)};
}

}  // namespace luch
