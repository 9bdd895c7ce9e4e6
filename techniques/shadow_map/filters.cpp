#include "techniques/shadow_map/filters.h"

#include "framework/trace/known_light.h"
#include "techniques/shadow_map/cube.h"

#include <algorithm>

namespace luch::techniques::shadow_map {
namespace {

/// A receiver on its face: its place in texels, and how far it is.
struct Place {
    int face = 0;
    double x = 0, y = 0;
    float distance = 0;

    Place(const Vec3& from_light, int n) : face(face_of(from_light)) {
        const double depth = std::abs(from_light[main_axis(face)]);
        x = (from_light[x_axis(face)] / depth + 1) / 2 * n;
        y = (from_light[y_axis(face)] / depth + 1) / 2 * n;
        distance = glm::length(from_light);
    }
};

/// What is stored at a place on a face's plane, perhaps beyond the face.
float stored_at(const CubeMap& map, int face, double x, double y) {
    Vec3 d;
    d[main_axis(face)] = static_cast<float>(sign_of(face));
    d[x_axis(face)] = static_cast<float>(2 * x / map.n - 1);
    d[y_axis(face)] = static_cast<float>(2 * y / map.n - 1);
    Texel texel;
    reference().texel_of({&d, 1}, map.n, {&texel, 1});
    return map.at(texel);
}

/// Looks at places on a grid, up to `reach` texels to each side, no more than so many a side.
/// visit(stored distance, texels that the place is away along the longer axis).
template <class Visit>
void look_around(const CubeMap& map, const Place& place, double reach, int most, Visit&& visit) {
    const int steps = std::clamp(static_cast<int>(std::ceil(reach)), 1, most);
    const double step = reach / steps;
    for (int j = -steps; j <= steps; ++j) {
        for (int i = -steps; i <= steps; ++i) {
            visit(stored_at(map, place.face, place.x + i * step, place.y + j * step),
                  step * std::max(std::abs(i), std::abs(j)));
        }
    }
}

constexpr int most_blockers = 5, most_taps = 8;
/// No penumbra is wider than so much of a face.
constexpr double widest = 0.25;

/// Half of the penumbra's width in texels, that a blocker at a distance makes at a farther one: by
/// similar triangles, seen from the light.
double penumbra(double width, double blocker, double receiver, int n) {
    const double spread = width / 2 * (receiver - blocker) / (blocker * receiver);
    return std::min(spread / 2, widest) * n;
}

float soft_share(const CubeMap& map, double width, double nearest, const Receiver& receiver,
                 float bias) {
    const Place place(receiver.from_light, map.n);
    if (!(place.distance > 0) || !std::isfinite(place.x + place.y)) return 1;
    // Of a tap k texels away, the bias is that of 2k + 1 half texels.
    const auto blocks = [&](float there, double away) {
        return place.distance > there + bias * static_cast<float>(2 * away + 1);
    };
    double sum = 0, count = 0, taps = 0;
    if (nearest < place.distance) {
        const double reach = penumbra(width, nearest, place.distance, map.n);
        look_around(map, place, reach, most_blockers, [&](float there, double away) {
            if (!blocks(there, away)) return;
            sum += there;
            count += 1;
        });
    }
    if (count == 0) return 1;
    const double reach = std::max(penumbra(width, sum / count, place.distance, map.n), 0.5);
    sum = 0;
    look_around(map, place, reach, most_taps, [&](float there, double away) {
        sum += blocks(there, away) ? 0 : 1;
        taps += 1;
    });
    return static_cast<float>(sum / taps);
}

/// Where the bias is a larger part of the distance, a map says little.
constexpr float most_bias = 0.05f;

}  // namespace

void soft_shares(const CubeMap& map, float nearest, double width,
                 std::span<const Receiver> receivers, std::span<const float> biases,
                 std::span<float> shares) {
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        shares[i] = soft_share(map, width, nearest, receivers[i], biases[i]);
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
