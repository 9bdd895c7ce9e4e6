#include "framework/measure/ray_view.h"

#include <numbers>

namespace luch {
namespace {

/// The box around all ends of rays that are ends. Only finite points.
Boxd box_of(const RayLog& log) {
    Boxd box;
    for (const LoggedRay& ray : log.rays()) {
        box.grow(ray.ray.origin);
        if (std::isfinite(ray.t)) box.grow(ray.end());
    }
    return box;
}

/// How long a ray to the sky is drawn.
double reach_of(const RayLog& log) {
    const Boxd box = box_of(log);
    const double reach = box.empty() ? 0 : glm::length(box.size());
    return reach > 0 ? reach : 1;
}

/// A ray as it is drawn, from 0 to `t`: a blocked shadow ray whole, whatever is between.
struct Drawn {
    const LoggedRay& ray;
    double t;

    Drawn(const LoggedRay& logged, double reach) : ray(logged) {
        const double length = glm::length(ray.ray.direction);
        t = ray.fate == LoggedRay::blocked ? ray.ray.t_max : ray.t;
        if (!std::isfinite(t)) t = reach / (length > 0 ? length : 1);
    }
    [[nodiscard]] Vec3d at(double part) const { return ray.ray.at(part * t); }
};

/// Whether nothing lies between the eye and a point.
bool visible(const Accelerator& accelerator, const Vec3d& eye, const Vec3d& point) {
    WorkCounts not_counted;
    // Not the surface itself that a ray ends at: a drawing's tolerance.
    constexpr float almost = 0.999f;
    return !accelerator.occluded({eye, point - eye, 0, almost}, not_counted);
}

/// How well a camera sees one ray, 0 to about 1: how much of it, and how large.
double worth(const LoggedRay& ray, const Accelerator& accelerator, const Screen& screen,
             double reach) {
    constexpr int points = 16;
    const Drawn drawn(ray, reach);
    const Vec2d frame(screen.size().width, screen.size().height);
    std::optional<Vec2d> first, last;
    double seen = 0;
    for (int k = 0; k <= points; ++k) {
        const Vec3d point = drawn.at(double(k) / points);
        const auto at = screen.project(screen.to_view(point));
        if (!at) continue;
        // The frame's border is no good place.
        const Vec2d aside = glm::abs(*at / frame - 0.5);
        if (std::max(aside.x, aside.y) > 0.47) continue;
        if (!visible(accelerator, screen.eye(), point)) continue;
        // The ends, where things happen, count more than what is between.
        seen += k == 0 || k == points ? points / 2.0 : 1;
        if (!first) first = at;
        last = at;
    }
    if (!first) return 0;
    const double length = glm::distance(*first, *last) / glm::length(frame);
    return seen / (2 * points) * (0.3 + std::min(length, 0.7));
}

/// The mean over the kinds of the mean over their rays.
double worth(const RayLog& log, const Accelerator& accelerator, const Screen& screen,
             double reach) {
    constexpr std::size_t most_rays = 200;
    std::array<double, ray_kind_names.size()> sum{}, count{};
    const auto& rays = log.rays();
    const std::size_t stride = 1 + rays.size() / most_rays;
    for (std::size_t i = 0; i < rays.size(); i += stride) {
        const auto kind = static_cast<std::size_t>(rays[i].kind);
        sum[kind] += worth(rays[i], accelerator, screen, reach);
        count[kind] += 1;
    }
    double total = 0;
    for (std::size_t kind = 0; kind < sum.size(); ++kind) {
        if (count[kind] > 0) total += sum[kind] / count[kind];
    }
    return total;
}

/// A ray cut into pieces, each with its place on the screen and whether it is seen.
void add_strokes(const LoggedRay& ray, int index, double reach, const Accelerator& accelerator,
                 const Screen& screen, std::vector<RayStroke>& strokes) {
    constexpr int pieces = 192;
    const Drawn drawn(ray, reach);
    const double blocked_from = ray.fate == LoggedRay::blocked ? ray.t / drawn.t : 2;
    bool joined = false;
    for (int k = 0; k < pieces; ++k) {
        const double t0 = double(k) / pieces, t1 = (k + 1.0) / pieces, middle = (t0 + t1) / 2;
        const auto a = screen.project(screen.to_view(drawn.at(t0)));
        const auto b = screen.project(screen.to_view(drawn.at(t1)));
        if (!a || !b) {
            joined = false;
            continue;
        }
        const bool hidden = !visible(accelerator, screen.eye(), drawn.at(middle));
        const bool blocked = middle > blocked_from;
        if (joined && strokes.back().hidden == hidden && strokes.back().blocked == blocked) {
            strokes.back().to_px = *b;
        } else {
            strokes.push_back({*a, *b, index, hidden, blocked});
        }
        joined = true;
    }
}

}  // namespace

Camera overview_camera(const RayLog& log, const Accelerator& accelerator, Size size) {
    Camera best;
    best.fov_deg = 75;
    best.aspect = std::clamp(double(size.width) / size.height, 1e-4, 1e4);
    const Boxd box = box_of(log);
    if (box.empty()) return best;
    const double reach = reach_of(log);
    const Screen shape(best, size);
    const double fitting = reach / 2 / std::min(shape.half_width(), shape.half_height());
    double most = -1;
    for (const double nearness : {1.3, 1.0, 0.7, 0.5}) {
        for (const double pitch : {-50.0, -30.0, -12.0}) {
            for (double yaw = -180; yaw < 180; yaw += 20) {
                Camera camera = best;
                camera.yaw_deg = yaw;
                camera.pitch_deg = pitch;
                const Vec3d forward = camera.to_world().direction({0, 0, 1});
                camera.position = box.centre() - forward * (fitting * nearness);
                const double value = worth(log, accelerator, Screen(camera, size), reach);
                if (!(value > most)) continue;
                most = value;
                best = camera;
            }
        }
    }
    return best;
}

std::vector<RayStroke> ray_strokes(const RayLog& log, const Accelerator& accelerator,
                                   const Screen& screen) {
    std::vector<RayStroke> strokes;
    const double reach = reach_of(log);
    int index = 0;
    for (const LoggedRay& ray : log.rays()) {
        add_strokes(ray, index++, reach, accelerator, screen, strokes);
    }
    return strokes;
}

}  // namespace luch
