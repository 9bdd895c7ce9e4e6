#include "techniques/shadow_map/sphere_map.h"

#include "framework/baseline/tile_rays.h"

#include <numbers>

namespace luch::techniques::shadow_map {
namespace {

constexpr double pi = std::numbers::pi;

/// Longitude and latitude of a direction.
struct Angles {
    double longitude, latitude;
};

Angles angles_of(const Vec3& d) {
    return {std::atan2(double(d.z), double(d.x)), std::atan2(double(d.y), std::hypot(d.x, d.z))};
}

Vec3d direction(const Angles& at) {
    const double level = std::cos(at.latitude);
    return {level * std::cos(at.longitude), std::sin(at.latitude), level * std::sin(at.longitude)};
}

/// The angle that a texel spans, along either axis.
double texel_angle(int n) {
    return pi / (2 * n);
}

struct Place {
    int x, y;
};

Place place_of(const Vec3& d, int n) {
    const Angles at = angles_of(d);
    const double x = (at.longitude + pi) / texel_angle(n);
    const double y = (at.latitude + pi / 2) / texel_angle(n);
    return {std::clamp(static_cast<int>(x), 0, 4 * n - 1),
            std::clamp(static_cast<int>(y), 0, 2 * n - 1)};
}

/// A place one texel off the map at most.
float stored(const SphereMap& map, Place at) {
    const int across = 4 * map.n, rows = 2 * map.n;
    if (at.y < 0 || at.y >= rows) {
        at.y = at.y < 0 ? 0 : rows - 1;
        at.x += across / 2;
    }
    return map.distance((at.x + across) % across, at.y);
}

}  // namespace

Vec3 direction_in_sphere(int x, int y, int n) {
    const double angle = texel_angle(n);
    return Vec3(direction({(x + 0.5) * angle - pi, (y + 0.5) * angle - pi / 2}));
}

void render_sphere(const Vec3d& light, int n, Tile tile, Tracer& tracer,
                   ImageView<float> distance) {
    std::vector<Ray> rays;
    for_each_pixel(tile, [&](int x, int y) {
        rays.push_back({light, Vec3d(direction_in_sphere(x, y, n))});
    });
    std::vector<Hit> hits(rays.size());
    tracer.closest(RayKind::shadow, rays, hits);
    std::size_t i = 0;
    for_each_pixel(tile, [&](int x, int y) {
        distance(x - tile.x0, y - tile.y0) = hits[i++].t;  // infinite where there is no hit
    });
}

void sphere_bias(std::span<const Receiver> receivers, int n, std::span<float> biases) {
    const double half = texel_angle(n) / 2;
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const Vec3d normal(receivers[i].normal);
        const double distance = glm::length(Vec3d(receivers[i].from_light));
        biases[i] = 0;
        if (!(distance > 0)) continue;
        const Angles at = angles_of(receivers[i].from_light);
        const double level = std::cos(at.latitude), rise = std::sin(at.latitude);
        const Vec3d east{-level * std::sin(at.longitude), 0, level * std::cos(at.longitude)};
        const Vec3d north{-rise * std::cos(at.longitude), level, -rise * std::sin(at.longitude)};
        const double along = std::abs(glm::dot(normal, direction(at)));
        const double slope = std::abs(glm::dot(normal, east)) + std::abs(glm::dot(normal, north));
        const double steepness =
            along > 0 ? (slope + 2 * half) / along : std::numeric_limits<double>::infinity();
        biases[i] = static_cast<float>(distance * (half * steepness + rounding_share));
    }
}

void sphere_shares(const SphereMap& map, std::span<const Receiver> receivers,
                   std::span<const float> biases, bool pcf, std::span<float> shares) {
    const int reach = pcf ? 1 : 0;
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const float distance = glm::length(receivers[i].from_light);
        const Place at = place_of(receivers[i].from_light, map.n);
        float sum = 0, count = 0;
        for (int dy = -reach; dy <= reach; ++dy) {
            for (int dx = -reach; dx <= reach; ++dx) {
                const float there = stored(map, {at.x + dx, at.y + dy});
                sum += distance <= there + biases[i] ? 1.0f : 0.0f;
                count += 1;
            }
        }
        shares[i] = sum / count;
    }
}

}  // namespace luch::techniques::shadow_map
