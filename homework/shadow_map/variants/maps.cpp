#include "homework/shadow_map/variants/variants.h"

#include <cmath>

namespace luch::homework::shadow_map {
namespace {

using namespace techniques::shadow_map;

constexpr float infinite = std::numeric_limits<float>::infinity();

/// In double, from the last to the first.
void texel_in_double(std::span<const Vec3> directions, int n, std::span<Texel> texels) {
    for (std::size_t i = directions.size(); i-- > 0;) {
        const Vec3d d(directions[i]);
        texels[i] = {0, n / 2, n / 2};
        const double largest = max_norm(d);
        if (!std::isfinite(d.x + d.y + d.z) || largest == 0) continue;
        int axis = 2;
        while (axis > 0 && std::abs(d[axis - 1]) >= std::abs(d[axis])) --axis;
        if (std::abs(d[0]) == largest) axis = 0;
        const Vec3d q = d / largest;
        const auto cell = [&](double u) {
            return std::min(static_cast<int>(0.5 * n * (u + 1)), n - 1);
        };
        texels[i] = {2 * axis + (d[axis] < 0), cell(q[(axis + 1) % 3]), cell(q[(axis + 2) % 3])};
    }
}

/// A case for each face, no loops over axes; multiplied and added at once.
void texel_by_cases(std::span<const Vec3> directions, int n, std::span<Texel> texels) {
    const float half = 0.5f * float(n);
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const auto& [x, y, z] = std::array{directions[i].x, directions[i].y, directions[i].z};
        const float a = std::fabs(x), b = std::fabs(y), c = std::fabs(z);
        const auto at = [&](int face, float u, float v, float w) {
            const auto cell = [&](float to) {
                return std::clamp(static_cast<int>(std::floor(std::fma(to / w, half, half))), 0,
                                  n - 1);
            };
            texels[i] = {face, cell(u), cell(v)};
        };
        if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z) || a + b + c == 0) {
            texels[i] = {0, n / 2, n / 2};
        } else if (a >= b && a >= c) {
            at(x > 0 ? 0 : 1, y, z, a);
        } else if (b >= c) {
            at(y > 0 ? 2 : 3, z, x, b);
        } else {
            at(z > 0 ? 4 : 5, x, y, c);
        }
    }
}

/// The face whose outward normal is the nearest; the cell by counting borders.
void texel_by_counting(std::span<const Vec3> directions, int n, std::span<Texel> texels) {
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const Vec3d d(directions[i]);
        texels[i] = {0, n / 2, n / 2};
        if (!all_finite(d)) continue;
        double most = 0;
        int face = -1;
        for (int k = 0; k < faces_of_cube; ++k) {
            const double along = k % 2 == 0 ? d[k / 2] : -d[k / 2];
            if (along <= most) continue;
            most = along;
            face = k;
        }
        if (face < 0) continue;
        // Of equal ones the first axis.
        const auto cell = [&](double across) {
            int borders = 0;
            while (borders < n - 1 && across * n >= most * (2 * (borders + 1) - n)) ++borders;
            return borders;
        };
        texels[i] = {face, cell(d[(face / 2 + 1) % 3]), cell(d[(face / 2 + 2) % 3])};
    }
}

void direction_in_double(std::span<const Texel> texels, int n, std::span<Vec3> directions) {
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const auto& [face, x, y] = texels[i];
        const double u = (x + 0.5) * 2 / n - 1, v = (y + 0.5) * 2 / n - 1;
        const double w = face % 2 == 0 ? 1 : -1, length = std::sqrt(1 + u * u + v * v);
        const Vec3d ways[] = {{w, u, v}, {v, w, u}, {u, v, w}};
        directions[i] = Vec3(ways[face / 2] / length);
    }
}

/// In whole halves of texels until the very end.
void direction_in_integers(std::span<const Texel> texels, int n, std::span<Vec3> directions) {
    for (std::size_t i = 0; i < texels.size(); ++i) {
        int place[3];
        place[texels[i].face / 2] = texels[i].face % 2 == 0 ? n : -n;
        place[(texels[i].face / 2 + 1) % 3] = 2 * texels[i].x + 1 - n;
        place[(texels[i].face / 2 + 2) % 3] = 2 * texels[i].y + 1 - n;
        const Vec3 d(place[0], place[1], place[2]);
        directions[i] = d * (1.0f / std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z));
    }
}

Vec3d centre(int face, int x, int y, int n) {
    const Texel texel{face, x, y};
    Vec3 d;
    reference().direction_of({&texel, 1}, n, {&d, 1});
    return Vec3d(d);
}

/// Ray by ray, in columns.
void face_one_by_one(const Vec3d& light, int face, int n, Tile tile, Tracer& tracer,
                     ImageView<float> distance) {
    for (int x = tile.x0; x < tile.x1; ++x) {
        for (int y = tile.y0; y < tile.y1; ++y) {
            const Ray ray{light, centre(face, x, y, n)};
            distance(x - tile.x0, y - tile.y0) = tracer.closest(RayKind::shadow, ray).t;
        }
    }
}

/// Directions that reach the face; t is stretched by their length.
void face_of_long_rays(const Vec3d& light, int face, int n, Tile tile, Tracer& tracer,
                       ImageView<float> distance) {
    for (int y = tile.y1 - 1; y >= tile.y0; --y) {
        std::vector<Ray> rays;
        for (int x = tile.x0; x < tile.x1; ++x) {
            Vec3d d;
            d[face / 2] = 1 - 2 * (face % 2);
            d[(face / 2 + 1) % 3] = (2 * x + 1) / double(n) - 1;
            d[(face / 2 + 2) % 3] = (2 * y + 1) / double(n) - 1;
            rays.push_back({light, d});
        }
        std::vector<Hit> hits(rays.size());
        tracer.closest(RayKind::shadow, rays, hits);
        for (int x = tile.x0; x < tile.x1; ++x) {
            const auto i = static_cast<std::size_t>(x - tile.x0);
            distance(x - tile.x0, y - tile.y0) =
                static_cast<float>(hits[i].t * glm::length(rays[i].direction));
        }
    }
}

/// From the point that was hit back to the light.
void face_by_points(const Vec3d& light, int face, int n, Tile tile, Tracer& tracer,
                    ImageView<float> distance) {
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            const Ray ray{light, centre(face, x, y, n)};
            const Hit hit = tracer.closest(RayKind::shadow, ray);
            distance(x - tile.x0, y - tile.y0) =
                hit ? static_cast<float>(glm::distance(ray.at(hit.t), light)) : infinite;
        }
    }
}

/// The distance of a receiver's plane through a place on the face, in double.
struct Plane {
    Vec3d normal;
    double offset;
    int axis, x, y;
    double side;

    explicit Plane(const Receiver& receiver)
        : normal(receiver.normal), offset(glm::dot(normal, Vec3d(receiver.from_light))) {
        Texel texel;
        reference().texel_of({&receiver.from_light, 1}, 8, {&texel, 1});
        axis = texel.face / 2;
        x = (axis + 1) % 3;
        y = (axis + 2) % 3;
        side = texel.face % 2 == 0 ? 1 : -1;
    }
    [[nodiscard]] Vec3d q(double u, double v) const {
        Vec3d place;
        place[axis] = side;
        place[x] = u;
        place[y] = v;
        return place;
    }
    [[nodiscard]] double distance(double u, double v) const {
        return offset * glm::length(q(u, v)) / glm::dot(normal, q(u, v));
    }
};

/// The quotient rule on D = (n·p)|q|/(n·q), in double.
void bias_by_quotients(std::span<const Receiver> receivers, int n, std::span<float> biases) {
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const Vec3d p(receivers[i].from_light);
        biases[i] = 0;
        if (p == Vec3d(0)) continue;
        const Plane plane(receivers[i]);
        biases[i] = infinite;
        if (plane.offset == 0) continue;
        const Vec3d q = p / (plane.side * p[plane.axis]);
        const double along = glm::dot(plane.normal, q), size = glm::length(q);
        double sum = 0;
        for (const int k : {plane.x, plane.y}) {
            sum += std::abs(plane.offset * (q[k] / size * along - size * plane.normal[k]) /
                            (along * along));
        }
        biases[i] = static_cast<float>(sum / n + rounding_share * glm::length(p));
    }
}

/// The gradient by central differences.
void bias_by_differences(std::span<const Receiver> receivers, int n, std::span<float> biases) {
    constexpr double step = 1e-5;
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const Vec3d p(receivers[i].from_light);
        const Plane plane(receivers[i]);
        biases[i] = p == Vec3d(0) ? 0 : infinite;
        if (plane.offset == 0) continue;
        const double u = p[plane.x] / std::abs(p[plane.axis]);
        const double v = p[plane.y] / std::abs(p[plane.axis]);
        const double along_u = plane.distance(u + step, v) - plane.distance(u - step, v);
        const double along_v = plane.distance(u, v + step) - plane.distance(u, v - step);
        const double rounding = double(rounding_share) * glm::length(p);
        biases[i] =
            static_cast<float>((std::abs(along_u) + std::abs(along_v)) / (2 * step * n) + rounding);
    }
}

/// The framework's formula in float, divided by |p| late, axes in the other order.
void bias_in_float(std::span<const Receiver> receivers, int n, std::span<float> biases) {
    for (std::size_t i = receivers.size(); i-- > 0;) {
        const auto& [p, normal] = receivers[i];
        const float squared = glm::dot(p, p), along = glm::dot(p, normal);
        if (!(squared > 0) || along == 0) {
            biases[i] = squared > 0 ? infinite : 0;
            continue;
        }
        const Plane plane(receivers[i]);
        const float depth = std::fabs(p[plane.axis]), away = std::sqrt(squared);
        // u/|q|² is p_u·depth/|p|², n_u/(n·q) is n_u·depth/(n·p).
        float sum = std::fabs(p[plane.y] / squared - normal[plane.y] / along);
        sum += std::fabs(p[plane.x] / squared - normal[plane.x] / along);
        biases[i] = std::fma(sum * depth / float(n), away, rounding_share * away);
    }
}

}  // namespace

std::vector<grading::Other> map_variants() {
    return {
        {"texel_in_double", "shadow_map.t1", "in double, the last first",
         with(&Steps::texel_of, texel_in_double)},
        {"texel_by_cases", "shadow_map.t1", "a case a face, fused multiplication and addition",
         with(&Steps::texel_of, texel_by_cases)},
        {"texel_by_counting", "shadow_map.t1", "the nearest normal, borders counted",
         with(&Steps::texel_of, texel_by_counting)},
        {"direction_in_double", "shadow_map.t2", "in double, by a table",
         with(&Steps::direction_of, direction_in_double)},
        {"direction_in_integers", "shadow_map.t2", "in integers, times the root's inverse",
         with(&Steps::direction_of, direction_in_integers)},
        {"face_one_by_one", "shadow_map.t3", "ray by ray, in columns",
         with(&Steps::render_face, face_one_by_one)},
        {"face_of_long_rays", "shadow_map.t3", "rays of any length, t stretched",
         with(&Steps::render_face, face_of_long_rays)},
        {"face_by_points", "shadow_map.t3", "measured between points",
         with(&Steps::render_face, face_by_points)},
        {"bias_by_quotients", "shadow_map.t4", "the quotient rule, in double",
         with(&Steps::bias, bias_by_quotients)},
        {"bias_by_differences", "shadow_map.t4", "central differences",
         with(&Steps::bias, bias_by_differences)},
        {"bias_in_float", "shadow_map.t4", "in float, another order, fused",
         with(&Steps::bias, bias_in_float)},
    };
}

}  // namespace luch::homework::shadow_map
