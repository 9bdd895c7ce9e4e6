#include "scenes/generator/bezier.h"

namespace luch::assets {
namespace {

using Weights = std::array<double, 4>;

/// The cubic Bernstein polynomials at t.
Weights bernstein(double t) {
    const double s = 1 - t;
    return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

/// Their derivatives.
Weights bernstein_slope(double t) {
    const double s = 1 - t;
    return {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
}

Vec3d weighted(const Patch& patch, const Weights& along_v, const Weights& along_u) {
    Vec3d sum(0);
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) sum += patch.rows[i][j] * (along_v[i] * along_u[j]);
    }
    return sum;
}

}  // namespace

Vec3d Patch::point(double u, double v) const {
    return weighted(*this, bernstein(v), bernstein(u));
}
Vec3d Patch::du(double u, double v) const {
    return weighted(*this, bernstein(v), bernstein_slope(u));
}
Vec3d Patch::dv(double u, double v) const {
    return weighted(*this, bernstein_slope(v), bernstein(u));
}
Vec3d Patch::duv(double u, double v) const {
    return weighted(*this, bernstein_slope(v), bernstein_slope(u));
}

Vec3d Patch::normal(double u, double v) const {
    const auto is_point = [](const Row& row) {
        return row[0] == row[1] && row[0] == row[2] && row[0] == row[3];
    };
    Vec3d across = du(u, v);
    if (v == 0 && is_point(rows[0])) across = duv(u, v);
    if (v == 1 && is_point(rows[3])) across = -duv(u, v);
    return glm::normalize(glm::cross(dv(u, v), across));
}

}  // namespace luch::assets
