#include "techniques/shadow_map/moments.h"

#include "techniques/shadow_map/cube.h"

#include <algorithm>

namespace luch::techniques::shadow_map {
namespace {

/// The texel of a place on a face's plane, perhaps beyond the face.
Texel texel_at(int face, int x, int y, int n) {
    if (x >= 0 && y >= 0 && x < n && y < n) return {face, x, y};
    Vec3 d;
    d[main_axis(face)] = static_cast<float>(sign_of(face));
    d[x_axis(face)] = static_cast<float>(2 * x + 1) / static_cast<float>(n) - 1;
    d[y_axis(face)] = static_cast<float>(2 * y + 1) / static_cast<float>(n) - 1;
    Texel texel;
    reference().texel_of({&d, 1}, n, {&texel, 1});
    return texel;
}

bool stored(const CubeMap& map, const Texel& texel) {
    const Tile& window = map.faces[static_cast<std::size_t>(texel.face)].window;
    return texel.x >= window.x0 && texel.x < window.x1 && texel.y >= window.y0 &&
           texel.y < window.y1;
}

glm::vec4 blurred(const CubeMap& map, const Moments& moments, const Texel& at) {
    Powers sum(0);
    double count = 0;
    for (int dy = -blur_reach; dy <= blur_reach; ++dy) {
        for (int dx = -blur_reach; dx <= blur_reach; ++dx) {
            const Texel there = texel_at(at.face, at.x + dx, at.y + dy, map.n);
            if (!stored(map, there)) continue;
            const double z = moments.depth(map.at(there));
            sum += Powers(z, z * z, z * z * z, z * z * z * z);
            count += 1;
        }
    }
    return glm::vec4(sum / count);
}

/// The least and the largest root of a x² + b x + c, which has two.
struct Roots {
    double lo, hi;
};
Roots roots_of(double a, double b, double c) {
    const double q = -0.5 * (b + std::copysign(std::sqrt(std::max(b * b - 4 * a * c, 0.0)), b));
    const double one = q / a, other = q != 0 ? c / q : one;
    return {std::min(one, other), std::max(one, other)};
}

}  // namespace

std::uint64_t Moments::bytes() const {
    std::uint64_t bytes = 0;
    for (const Image<glm::vec4>& face : faces) bytes += face.size().area() * sizeof(glm::vec4);
    return bytes;
}

Moments moments_of(const CubeMap& map, Context& context) {
    Moments moments;
    moments.farthest = 0;
    for (const Face& face : map.faces) {
        for (const float distance : face.distance.pixels()) {
            if (std::isfinite(distance)) moments.farthest = std::max(moments.farthest, distance);
        }
    }
    if (!(moments.farthest > 0)) moments.farthest = 1;
    for (int face = 0; face < faces_of_cube; ++face) {
        const Tile& window = map.faces[static_cast<std::size_t>(face)].window;
        Image<glm::vec4>& out = moments.faces[static_cast<std::size_t>(face)];
        out = Image<glm::vec4>({window.width(), window.height()});
        context.for_each(window.height(), [&](int y, int) {
            for (int x = 0; x < window.width(); ++x) {
                out(x, y) = blurred(map, moments, {face, window.x0 + x, window.y0 + y});
            }
        });
    }
    return moments;
}

double lit_by_variance(const Powers& moments, double z) {
    const double mean = moments.x, off = z - mean;
    if (!(off > 0)) return 1;
    const double variance = std::max(moments.y - mean * mean, 0.0);
    return variance / (variance + off * off);
}

double lit_by_moments(const Powers& moments, double z) {
    // Moments that were rounded may belong to nothing: mixed with those of an even spread over
    // −1..1 they are sound again.
    constexpr double mixed = 3e-7;
    const Powers b = moments + mixed * (Powers(0, 1.0 / 3, 0, 1.0 / 5) - moments);
    // Solves the Hankel matrix's system B c = (1, z, z²) by Cholesky, B = L D Lᵗ.
    const double l32 = b.z - b.x * b.y, d22 = b.y - b.x * b.x;
    const double d33 = b.w - b.y * b.y - l32 * l32 / d22;
    if (!(d22 > 0) || !(d33 > 0)) return lit_by_variance(moments, z);
    double c1 = z - b.x, c2 = (z * z - b.y - l32 / d22 * c1) / d33;
    c1 = c1 / d22 - l32 / d22 * c2;
    const double c0 = 1 - b.x * c1 - b.y * c2;
    const auto [lo, hi] = roots_of(c2, c1, c0);
    if (!(z > lo)) return 1;
    const double in_front = z <= hi ? (z * hi - b.x * (z + hi) + b.y) / ((hi - lo) * (z - lo))
                                    : 1 - (lo * hi - b.x * (lo + hi) + b.y) / ((z - lo) * (z - hi));
    return std::clamp(1 - in_front, 0.0, 1.0);
}

void shares_by_moments(const CubeMap& map, const Moments& moments, bool four,
                       std::span<const Receiver> receivers, std::span<const float> biases,
                       std::span<float> shares) {
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        Texel at;
        reference().texel_of({&receivers[i].from_light, 1}, map.n, {&at, 1});
        shares[i] = 1;
        if (!stored(map, at)) continue;
        const Tile& window = map.faces[static_cast<std::size_t>(at.face)].window;
        const Powers powers(
            moments.faces[static_cast<std::size_t>(at.face)](at.x - window.x0, at.y - window.y0));
        const float distance = glm::length(receivers[i].from_light) - biases[i];
        const double z = moments.depth(distance);
        shares[i] =
            static_cast<float>(four ? lit_by_moments(powers, z) : lit_by_variance(powers, z));
    }
}

}  // namespace luch::techniques::shadow_map
