#include "framework/accel/crossings.h"

namespace luch {
namespace {

/// A sum of doubles without any rounding, as parts that do not overlap, least first (Shewchuk,
/// "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997,
/// GROW-EXPANSION).
class ExactSum {
 public:
    void add(double x) {
        for (int i = 0; i < count_; ++i) {
            const double part = parts_[i], sum = x + part, of_part = sum - x;
            parts_[i] = (x - (sum - of_part)) + (part - of_part);
            x = sum;
        }
        parts_[count_++] = x;
    }
    void add_product(double a, double b) {
        const double product = a * b;
        add(std::fma(a, b, -product));
        add(product);
    }
    /// That of the largest part.
    [[nodiscard]] int sign() const {
        for (int i = count_; i-- > 0;) {
            if (parts_[i] != 0) return parts_[i] > 0 ? 1 : -1;
        }
        return 0;
    }

 private:
    std::array<double, 12> parts_;
    int count_ = 0;
};

/// Products of two floats are exact in double, and those of three are the sum of two doubles.
int exact_edge_sign(const Vec3d& a, const Vec3d& b, const Vec3d& d) {
    ExactSum sum;
    for (int x = 0; x < 3; ++x) {
        const int y = (x + 1) % 3, z = (x + 2) % 3;
        sum.add_product(a[y] * b[z], d[x]);
        sum.add_product(a[z] * b[y], -d[x]);
    }
    return sum.sign();
}

}  // namespace

int tilted_edge_sign(const Vec3& a, const Vec3& b, const Vec3& d) {
    if (const int sign = edge_sign(a, b, d); sign != 0) return sign;
    const Vec3d a64(a), b64(b);
    if (const int sign = exact_edge_sign(a64, b64, Vec3d(d)); sign != 0) return sign;
    // d + (ε, ε², ε³): the first component of a × b that is not zero decides.
    for (int x = 0; x < 3; ++x) {
        const int y = (x + 1) % 3, z = (x + 2) % 3;
        const double one = a64[y] * b64[z], other = a64[z] * b64[y];
        if (one != other) return one > other ? 1 : -1;
    }
    return 0;
}

bool cross_triangle(const ObjectRay& ray, const Vec3& p0, const Vec3& p1, const Vec3& p2,
                    TriangleHit& hit) {
    const Vec3 a0 = p0 - ray.origin, a1 = p1 - ray.origin, a2 = p2 - ray.origin;
    const int side = tilted_edge_sign(a1, a2, ray.direction);
    return side != 0 && side == tilted_edge_sign(a2, a0, ray.direction) &&
           side == tilted_edge_sign(a0, a1, ray.direction) &&
           intersect_triangle(ray, p0, p1, p2, false, hit);
}

}  // namespace luch
