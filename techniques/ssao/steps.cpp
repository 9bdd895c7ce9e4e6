// The lecture's passes, in its order. Mittring, "Finding Next Gen: CryEngine 2", SIGGRAPH 2007;
// Filion and McNaughton, "Effects & Techniques", SIGGRAPH 2008 (the half-ball).
#include "framework/math/spread.h"
#include "techniques/ssao/view.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace luch::techniques::ssao {
namespace {

constexpr Vec3 nothing{0, 0, std::numeric_limits<float>::infinity()};

void positions(ImageView<const float> z, const Screen& screen, Tile tile,
               ImageView<Vec3> position) {
    each_pixel(tile, [&](int x, int y) {
        const float depth = z(x, y);
        const bool seen = depth > 0 && depth < std::numeric_limits<float>::infinity();
        const Vec2d at{screen.across(x + 0.5), screen.upwards(y + 0.5)};
        position(x, y) = seen ? Vec3(Vec3d(at, 1) * double(depth)) : nothing;
    });
}

/// Along one axis, the step to the neighbour that lies on the same surface. In the picture of a
/// plane 1/z is linear: of the two sides, the one whose next two pixels lead on to this one.
std::optional<Vec3> step_along(ImageView<const Vec3> position, int x, int y, Axis axis) {
    const auto at = [&](int i) -> std::optional<Vec3> {
        const int u = axis == Axis::x ? x + i : x, v = axis == Axis::x ? y : y + i;
        if (u < 0 || v < 0 || u >= position.width() || v >= position.height()) return {};
        return is_seen(position(u, v)) ? std::optional(position(u, v)) : std::nullopt;
    };
    const Vec3 here = position(x, y);
    std::optional<Vec3> best;
    double least = std::numeric_limits<double>::infinity();
    for (const int side : {1, -1}) {
        const auto next = at(side), second = at(2 * side);
        if (!next) continue;
        const double beyond = second ? 1.0 / second->z : 1.0 / next->z;
        const double off = std::abs(2.0 / next->z - beyond - 1.0 / here.z);
        if (best && off >= least) continue;
        least = off;
        best = static_cast<float>(side) * (*next - here);
    }
    return best;
}

void normals(ImageView<const Vec3> position, Tile tile, ImageView<Vec3> normal) {
    each_pixel(tile, [&](int x, int y) {
        normal(x, y) = Vec3(0);
        const Vec3d here = position(x, y);
        if (!is_seen(position(x, y))) return;
        normal(x, y) = -glm::normalize(here);
        const auto right = step_along(position, x, y, Axis::x);
        const auto down = step_along(position, x, y, Axis::y);
        if (!right || !down) return;
        const Vec3d across = glm::cross(Vec3d(*right), Vec3d(*down));
        const double length = glm::length(across);
        if (!(length > 0) || !std::isfinite(length)) return;
        normal(x, y) = Vec3(glm::dot(across, here) > 0 ? -across / length : across / length);
    });
}

/// How far out the points lie, for shares 0..1 of them. What the picture shows is taken for solid,
/// so a point far out tells of all that is on its way, but misses what is thin.
double kernel_distance(double share) {
    return std::sqrt(share);
}

/// Malley's method: points of the disc, lifted to the half-sphere, have the density cos/π.
void kernel(Key key, std::span<Vec3> points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2d disc = disc_of(spread(key.branch(0), static_cast<std::uint32_t>(i)));
        const double height = std::sqrt(std::max(0.0, 1 - glm::dot(disc, disc)));
        const double share = (static_cast<double>(i) + key.uniform(1)) / double(points.size());
        const double distance = std::max(kernel_distance(share), 0x1p-20);
        points[i] = Vec3(Vec3d(disc, height) * distance);
    }
}

/// Three unit vectors at right angles, the third given.
struct Around {
    Vec3 x, y, z;
    explicit Around(const Vec3& normal) : z(normal) {
        const Vec3 other = std::abs(z.x) < 0.5f ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
        x = glm::normalize(glm::cross(other, z));
        y = glm::cross(z, x);
    }
};

/// The surface that is seen where a point of camera space would be, if it falls on the frame.
std::optional<Vec3> seen_at(const GBuffer& seen, const Screen& screen, const Vec3& point) {
    const auto px = screen.project(point);
    const bool in_frame = px && px->x >= 0 && px->y >= 0 && px->x < seen.position.width() &&
                          px->y < seen.position.height();
    if (!in_frame) return {};
    return seen.position(static_cast<int>(px->x), static_cast<int>(px->y));
}

void occlusion(const GBuffer& seen, const Screen& screen, std::span<const Vec3> kernel,
               const Params& params, Key key, Tile tile, ImageView<float> occluded) {
    const Scale scale(screen);
    const auto radius = static_cast<float>(params.radius);
    const auto shift = static_cast<float>(16 * key.uniform(0));
    each_pixel(tile, [&](int x, int y) {
        occluded(x, y) = 0;
        const Vec3 here = seen.position(x, y);
        if (!is_seen(here) || !(scale.px(radius, here.z) >= 1)) return;
        const Vec3 normal = towards(-glm::normalize(here), seen.normal(x, y));
        if (normal == Vec3(0)) return;
        const float turn =
            2 * std::numbers::pi_v<float> * (static_cast<float>(turn_of(x, y)) + shift) / 16;
        const float cosine = std::cos(turn), sine = std::sin(turn);
        const Around around(normal);
        int counted = 0, hidden = 0;
        for (const Vec3& point : kernel) {
            const Vec3 turned(cosine * point.x - sine * point.y, sine * point.x + cosine * point.y,
                              point.z);
            const Vec3 there =
                here + radius * (turned.x * around.x + turned.y * around.y + turned.z * around.z);
            const auto surface = seen_at(seen, screen, there);
            if (!surface) continue;
            ++counted;
            if (!(surface->z < there.z)) continue;
            const Vec3 way = *surface - here;
            const float squared = glm::dot(way, way);
            const bool near = squared <= radius * radius;
            if (near && stands_out(glm::dot(way, normal), squared, here.z)) ++hidden;
        }
        if (counted > 0) occluded(x, y) = static_cast<float>(hidden) / static_cast<float>(counted);
    });
}

void blur(ImageView<const float> in, const GBuffer& seen, const Blur& blur, Axis axis, Tile tile,
          ImageView<float> out) {
    std::vector<float> gaussian;
    for (int i = 0; i <= blur.reach_px; ++i) {
        const float off = static_cast<float>(i) / blur.sigma_px;
        gaussian.push_back(std::exp(-0.5f * off * off));
    }
    const int length = axis == Axis::x ? in.width() : in.height();
    each_pixel(tile, [&](int x, int y) {
        out(x, y) = in(x, y);
        if (!is_seen(seen.position(x, y)) || !std::isfinite(in(x, y))) return;
        const int at = axis == Axis::x ? x : y;
        float sum = 0, whole = 0;
        const int first = std::max(at - blur.reach_px, 0);
        const int last = std::min(at + blur.reach_px, length - 1);
        for (int i = first; i <= last; ++i) {
            const int u = axis == Axis::x ? i : x, v = axis == Axis::x ? y : i;
            if (!is_seen(seen.position(u, v)) || !std::isfinite(in(u, v))) continue;
            const float weight =
                gaussian[static_cast<std::size_t>(std::abs(i - at))] *
                nearness(off_plane(seen, x, y, seen.position(u, v)), blur.tolerance);
            sum += weight * in(u, v);
            whole += weight;
        }
        out(x, y) = sum / whole;
    });
}

void upsample(ImageView<const float> in, const GBuffer& coarse, const GBuffer& fine,
              float tolerance, Tile tile, ImageView<float> out) {
    each_pixel(tile, [&](int x, int y) {
        out(x, y) = 0;
        if (!is_seen(fine.position(x, y))) return;
        float sum = 0, whole = 0, least = std::numeric_limits<float>::infinity();
        for (int j = y / 2; j <= std::min((y + 1) / 2, in.height() - 1); ++j) {
            for (int i = x / 2; i <= std::min((x + 1) / 2, in.width() - 1); ++i) {
                if (!is_seen(coarse.position(i, j))) continue;
                const float off = off_plane(fine, x, y, coarse.position(i, j));
                if (off < least && !(whole > 0)) out(x, y) = in(i, j);
                least = std::min(least, off);
                sum += nearness(off, tolerance) * in(i, j);
                whole += nearness(off, tolerance);
            }
        }
        if (whole > 0) out(x, y) = sum / whole;
    });
}

void apply(ImageView<const float> visibility, const Rgb& ambient, Tile tile, ImageView<Rgb> light) {
    each_pixel(tile, [&](int x, int y) { light(x, y) = ambient * visibility(x, y); });
}

}  // namespace

Steps reference() {
    return {positions, normals, kernel, occlusion, blur, upsample, apply};
}

}  // namespace luch::techniques::ssao
