#include "techniques/shadow_map/filters.h"

#include "framework/trace/known_light.h"
#include "techniques/shadow_map/cube.h"

#include <algorithm>

namespace luch::techniques::shadow_map {
namespace {

/// A receiver on its face: its place in texels, how far it is, and its plane.
struct Place {
    int face = 0;
    double x = 0, y = 0;
    float distance = 0;
    Vec3 normal;
    float height;  ///< of the light over the plane, along the normal

    Place(const Receiver& receiver, int n)
        : face(face_of(receiver.from_light)),
          distance(glm::length(receiver.from_light)),
          normal(receiver.normal),
          height(glm::dot(receiver.normal, receiver.from_light)) {
        const double depth = std::abs(receiver.from_light[main_axis(face)]);
        x = (receiver.from_light[x_axis(face)] / depth + 1) / 2 * n;
        y = (receiver.from_light[y_axis(face)] / depth + 1) / 2 * n;
    }

    /// How far its plane is along a unit direction; infinite where it is not met.
    [[nodiscard]] float plane_along(const Vec3& d) const {
        const float along = glm::dot(normal, d) / height;
        return along > 0 ? 1 / along : std::numeric_limits<float>::infinity();
    }
};

/// What a map holds at a place on a face's plane, perhaps beyond the face, and how far the
/// receiver's plane is there.
struct Tap {
    float stored, plane;
};

Tap tap_at(const CubeMap& map, const Place& place, double x, double y) {
    Vec3 d;
    d[main_axis(place.face)] = static_cast<float>(sign_of(place.face));
    d[x_axis(place.face)] = static_cast<float>(2 * x / map.n - 1);
    d[y_axis(place.face)] = static_cast<float>(2 * y / map.n - 1);
    Texel texel;
    reference().texel_of({&d, 1}, map.n, {&texel, 1});
    return {map.at(texel), place.plane_along(glm::normalize(d))};
}

/// Looks at taps on a grid, up to `reach` texels to each side, no more than so many a side:
/// visit(tap, how many texels away).
template <class Visit>
void look_around(const CubeMap& map, const Place& place, double reach, int most, Visit&& visit) {
    const int steps = std::clamp(static_cast<int>(std::ceil(reach)), 1, most);
    const double step = reach / steps;
    for (int j = -steps; j <= steps; ++j) {
        for (int i = -steps; i <= steps; ++i) {
            visit(tap_at(map, place, place.x + i * step, place.y + j * step),
                  step * std::max(std::abs(i), std::abs(j)));
        }
    }
}

constexpr int most_taps = 8;
/// No penumbra is wider than so much of a face.
constexpr double widest = 0.25;

/// Half of the penumbra's width in texels, that a blocker at a distance makes at a farther one: by
/// similar triangles, seen from the light.
double penumbra(double width, double blocker, double receiver, int n) {
    const double spread = width / 2 * (receiver - blocker) / (blocker * receiver);
    return std::min(spread / 2, widest) * n;
}

float soft_share(const CubeMap& map, double width, const Receiver& receiver, float bias) {
    const Place place(receiver, map.n);
    if (!(place.distance > 0) || !std::isfinite(place.x + place.y)) return 1;
    // Away from the receiver its plane is nearer or farther: that is what counts there.
    const auto blocks = [&](const Tap& tap) { return tap.stored + bias < tap.plane; };
    double sum = 0, count = 0, taps = 0;
    // As wide as what is half way to the lamp needs; what is nearer to it looks large from there.
    const double wide = penumbra(width, place.distance / 2, place.distance, map.n);
    look_around(map, place, wide, most_taps, [&](const Tap& tap, double away) {
        // Only what lies between the receiver and some point of the lamp.
        if (!blocks(tap) || away > penumbra(width, tap.stored, place.distance, map.n) + 1) return;
        sum += std::min(tap.stored, place.distance);
        count += 1;
    });
    if (count == 0) return 1;
    const double reach = std::max(penumbra(width, sum / count, place.distance, map.n), 0.5);
    sum = 0;
    look_around(map, place, reach, most_taps, [&](const Tap& tap, double) {
        sum += blocks(tap) ? 0 : 1;
        taps += 1;
    });
    return static_cast<float>(sum / taps);
}

/// Where the bias is a larger part of the distance, a map says little.
constexpr float most_bias = 0.05f;

}  // namespace

void soft_shares(const CubeMap& map, double width, std::span<const Receiver> receivers,
                 std::span<const float> biases, std::span<float> shares) {
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        shares[i] = soft_share(map, width, receivers[i], biases[i]);
    }
}

void keep_agreed(std::span<const Receiver> receivers, std::span<const float> biases,
                 std::span<float> shares) {
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const float distance = glm::length(receivers[i].from_light);
        const bool agreed = shares[i] == 0 || shares[i] == 1;
        if (!agreed || biases[i] > most_bias * distance) shares[i] = ShadowSource::unknown;
    }
}

}  // namespace luch::techniques::shadow_map
