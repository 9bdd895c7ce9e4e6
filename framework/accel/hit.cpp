#include "framework/accel/hit.h"

namespace luch {
namespace {

/// (a × b) · d in float with a bound on its rounding error.
struct TripleProduct {
    float value;
    bool certain;  ///< the sign of value is that of the exact product
};

/// Five roundings lie on every path from an input to the result, so |error| ≤ γ₅ · Σ|products|
/// (Higham, "Accuracy and Stability of Numerical Algorithms", 2002, ch. 3); 8u covers the rounding
/// of the sum itself. The second term covers results that underflow, or are flushed to zero.
TripleProduct triple_product(const Vec3& a, const Vec3& b, const Vec3& d) {
    const float yz = a.y * b.z, zy = a.z * b.y;
    const float zx = a.z * b.x, xz = a.x * b.z;
    const float xy = a.x * b.y, yx = a.y * b.x;
    const Vec3 size = glm::abs(d);
    const float value = (yz - zy) * d.x + (zx - xz) * d.y + (xy - yx) * d.z;
    const float products = (std::abs(yz) + std::abs(zy)) * size.x +
                           (std::abs(zx) + std::abs(xz)) * size.y +
                           (std::abs(xy) + std::abs(yx)) * size.z;
    constexpr float smallest = std::numeric_limits<float>::min();
    const float bound = 8 * 0x1p-24f * products + 8 * smallest * (1 + size.x + size.y + size.z);
    return {value, std::abs(value) > bound};
}

/// (a × b) · d as (a × (b − a)) · d, whose terms are smaller by the ratio of edge to distance, and
/// with them the error; the subtraction adds one rounding to the five. The last term makes sure
/// that what is certain here is certain in double as well.
TripleProduct edge_product(const Vec3& a, const Vec3& b, const Vec3& d) {
    TripleProduct product = triple_product(a, b - a, d);
    const float size = std::max(max_norm(a), max_norm(b));
    const Vec3 lengths = glm::abs(d);
    const float least = 0x1p-46f * size * size * (lengths.x + lengths.y + lengths.z);
    product.certain = product.certain && std::abs(product.value) > least;
    return product;
}

/// The same in double: products of two floats are exact there.
TripleProduct certain_triple_product(const Vec3d& a, const Vec3d& b, const Vec3d& d) {
    const double yz = a.y * b.z, zy = a.z * b.y;
    const double zx = a.z * b.x, xz = a.x * b.z;
    const double xy = a.x * b.y, yx = a.y * b.x;
    const double value = (yz - zy) * d.x + (zx - xz) * d.y + (xy - yx) * d.z;
    const double products = (std::abs(yz) + std::abs(zy)) * std::abs(d.x) +
                            (std::abs(zx) + std::abs(xz)) * std::abs(d.y) +
                            (std::abs(xy) + std::abs(yx)) * std::abs(d.z);
    const bool certain = std::abs(value) > 8 * 0x1p-53 * products;
    return {static_cast<float>(value > 0 ? 1 : -1), certain};
}

/// The t at which a ray meets a triangle's plane; NaN where n · d = 0. In float when the signs of
/// both numerator and denominator are certain, else in double.
float plane_t(const ObjectRay& ray, const Vec3& p0, const Vec3& p1, const Vec3& p2,
              const Vec3& a0) {
    const Vec3 edge1 = p1 - p0, edge2 = p2 - p0;
    const TripleProduct above = triple_product(edge1, edge2, a0);
    const TripleProduct along = triple_product(edge1, edge2, ray.direction);
    if (above.certain && along.certain) return above.value / along.value;
    const Vec3d normal = glm::cross(Vec3d(p1) - Vec3d(p0), Vec3d(p2) - Vec3d(p0));
    const double slope = glm::dot(normal, Vec3d(ray.direction));
    if (slope == 0) return std::numeric_limits<float>::quiet_NaN();
    return static_cast<float>(glm::dot(normal, Vec3d(p0) - Vec3d(ray.origin)) / slope);
}

/// The value of the edge from a to b.
float edge_value(const Vec3& a, const Vec3& b, const Vec3& d) {
    const Vec3 e = b - a;
    return (a.y * e.z - a.z * e.y) * d.x + (a.z * e.x - a.x * e.z) * d.y +
           (a.x * e.y - a.y * e.x) * d.z;
}

/// The least of |x|, |y|, |z|.
float min_norm(const Vec3& v) {
    return std::min(std::abs(v.x), std::min(std::abs(v.y), std::abs(v.z)));
}

}  // namespace

ObjectRay object_ray(const Ray& ray) {
    ObjectRay object{Vec3(ray.origin), Vec3(ray.direction), {}, least_t(ray.t_min), ray.t_max};
    const float most = max_norm(object.direction);
    const float least = std::min(min_norm(object.origin), min_norm(object.direction));
    if (least >= std::numeric_limits<float>::min() && most <= 0x1p100f) {
        object.inverse = 1.0f / object.direction;
        return object;
    }
    for (int axis = 0; axis < 3; ++axis) {
        object.origin[axis] = normal_or_zero(object.origin[axis]);
        object.direction[axis] = normal_or_zero(object.direction[axis]);
        const float inverse = 1 / object.direction[axis];
        object.inverse[axis] =
            std::abs(inverse) >= 0x1p-100f ? inverse : std::copysign(0.0f, object.direction[axis]);
    }
    return object;
}

int edge_sign(const Vec3& a, const Vec3& b, const Vec3& d) {
    TripleProduct product = edge_product(a, b, d);
    if (!product.certain) product = certain_triple_product(Vec3d(a), Vec3d(b), Vec3d(d));
    if (!product.certain) return 0;
    return product.value > 0 ? 1 : -1;
}

bool intersect_triangle(const ObjectRay& ray, const Vec3& p0, const Vec3& p1, const Vec3& p2,
                        bool cull_backfaces, TriangleHit& hit) {
    const Vec3 a0 = p0 - ray.origin, a1 = p1 - ray.origin, a2 = p2 - ray.origin;
    const int sign0 = edge_sign(a1, a2, ray.direction);
    const int sign1 = edge_sign(a2, a0, ray.direction);
    if (sign0 * sign1 < 0) return false;
    const int sign2 = edge_sign(a0, a1, ray.direction);
    const int side = sign0 + sign1 + sign2;
    if (sign0 * sign2 < 0 || sign1 * sign2 < 0) return false;
    if (cull_backfaces && side > 0) return false;

    Box box{p0, p0};
    box.grow(p1);
    box.grow(p2);
    const Interval inside = slab(box, ray);
    if (!(inside.near <= inside.far)) return false;
    const float t = std::clamp(plane_t(ray, p0, p1, p2, a0), inside.near, inside.far);
    if (!(t > ray.t_min && t < ray.t_max)) return false;

    const float weight0 = edge_value(a1, a2, ray.direction);
    const float weight1 = edge_value(a2, a0, ray.direction);
    const float weight2 = edge_value(a0, a1, ray.direction);
    const Barycentric at = barycentric(weight0, weight1, weight2);
    hit = {t, at.u, at.v};
    return true;
}

}  // namespace luch
