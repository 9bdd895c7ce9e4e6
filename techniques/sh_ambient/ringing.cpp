#include "techniques/sh_ambient/ringing.h"

#include <glm/matrix.hpp>

#include <limits>

namespace luch::techniques::sh_ambient {
namespace {

/// One colour's irradiance as c + b·n + nᵀAn for unit n; A has no trace.
struct Quadratic {
    double c;
    Vec3d b;
    glm::dmat3 a;
};

Quadratic quadratic_of(const Sh9& light, int channel) {
    const auto term = [&](int k) {
        return cosine_lobe[static_cast<std::size_t>(degree_of(k))] *
               static_cast<double>(light.l[static_cast<std::size_t>(k)][channel]);
    };
    // The harmonics' own factors, read off where the others vanish.
    const double y0 = harmonics(Vec3d(0, 0, 1))[0], y1 = harmonics(Vec3d(0, 0, 1))[2];
    const double y20 = harmonics(Vec3d(0, 0, 1))[6] / 2, y22 = harmonics(Vec3d(1, 0, 0))[8];
    const double xx = y22 * term(8), zz = y20 * term(6);
    const double xy = y22 * term(4), yz = y22 * term(5), xz = y22 * term(7);
    return {y0 * term(0),
            y1 * Vec3d(term(3), term(1), term(2)),
            {xx - zz, xy, xz, xy, -xx - zz, yz, xz, yz, 2 * zz}};
}

/// The least eigenvalue of a symmetric matrix without a trace (O. K. Smith, "Eigenvalues of a
/// Symmetric 3 × 3 Matrix", CACM 1961).
double least_eigenvalue(const glm::dmat3& a) {
    double squares = 0;
    for (int i = 0; i < 3; ++i) squares += glm::dot(a[i], a[i]);
    const double p = std::sqrt(squares / 6);
    if (!(p > 0)) return 0;
    const double turned = std::clamp(glm::determinant(a / p) / 2, -1.0, 1.0);
    return 2 * p * std::cos((std::acos(turned) + 2 * std::numbers::pi) / 3);
}

/// The dual's value where A + λ is positive: a lower bound of the least irradiance.
double dual(const Quadratic& q, double lambda) {
    return q.c - lambda - 0.25 * glm::dot(q.b, glm::inverse(q.a + glm::dmat3(lambda)) * q.b);
}

double least_of(const Quadratic& q) {
    const double least = least_eigenvalue(q.a), length = glm::length(q.b);
    if (!(length > 0)) return q.c + least;
    // The dual is concave, and the best λ is no further than |b|/2 above where A + λ is positive.
    // Very near that end the inverse is all rounding.
    double low = -least + 1e-7 * std::abs(least), high = low + length / 2;
    constexpr double golden = 0.6180339887498949;
    for (int i = 0; i < 80; ++i) {
        const double left = high - golden * (high - low), right = low + golden * (high - low);
        (dual(q, left) < dual(q, right) ? low : high) =
            dual(q, left) < dual(q, right) ? left : right;
    }
    return dual(q, high);
}

}  // namespace

double least_irradiance(const Sh9& light) {
    double least = std::numeric_limits<double>::infinity();
    for (int channel = 0; channel < 3; ++channel) {
        least = std::min(least, least_of(quadratic_of(light, channel)));
    }
    return least;
}

double least_scaling(const Sh9& light) {
    // Irradiance is summed in float: that far above 0 it cannot come out below.
    const double rounding = 4e-6 * max_norm(Vec3d(light.l[0]));
    const auto rings = [&](double factor) {
        Sh9 scaled = light;
        scale_linear_terms(scaled, factor);
        return least_irradiance(scaled) < rounding;
    };
    if (light.degree == 0 || !rings(1)) return 1;
    // The least irradiance is even and concave in the factor, so it falls from 0 on.
    double low = ringing_scale * (1 - 1e-4), high = 1;
    for (int i = 0; i < 30; ++i) {
        const double middle = (low + high) / 2;
        (rings(middle) ? high : low) = middle;
    }
    return low;
}

void scale_linear_terms(Sh9& light, double factor) {
    for (std::size_t k = 1; k < 4; ++k) light.l[k] *= static_cast<float>(factor);
}

}  // namespace luch::techniques::sh_ambient
