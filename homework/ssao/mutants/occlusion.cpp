// Mistakes with occlusion, task t4.
#include "homework/ssao/mutants/more.h"
#include "techniques/ssao/view.h"

#include <cmath>
#include <numbers>

namespace luch::homework::ssao {
namespace {

using namespace techniques::ssao;

/// What is wrong: one thing at a time.
struct Rules {
    bool no_range = false, no_plane = false, unflipped = false, world_normal = false;
    bool one_short = false, short_mean = false, wraps = false, clamps = false,
         off_frame_counts = false;
    bool no_turn = false, one_turn = false, farther = false, half_radius = false, centre = false;
    bool visible = false, no_limit = false, range_by_z = false;
};

struct Around {
    Vec3 x, y, z;
    explicit Around(const Vec3& normal) : z(normal) {
        const Vec3 other = std::abs(z.x) < 0.5f ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
        x = glm::normalize(glm::cross(other, z));
        y = glm::cross(z, x);
    }
    [[nodiscard]] Vec3 operator()(const Vec3& p) const { return p.x * x + p.y * y + p.z * z; }
};

template <Rules rules>
std::optional<Vec3> surface_at(const GBuffer& seen, const Screen& screen, const Vec3& point) {
    const auto px = screen.project(point);
    if (!px) return {};
    const int width = seen.position.width(), height = seen.position.height();
    const double off = rules.centre ? 0.5 : 0;
    double x = std::floor(px->x + off), y = std::floor(px->y + off);
    if (rules.wraps) {
        x -= width * std::floor(x / width);
        y -= height * std::floor(y / height);
    }
    if (rules.clamps) {
        x = std::clamp(x, 0.0, width - 1.0);
        y = std::clamp(y, 0.0, height - 1.0);
    }
    if (!(x >= 0 && y >= 0 && x < width && y < height)) return {};
    return seen.position(static_cast<int>(x), static_cast<int>(y));
}

/// The normal's coordinates taken for those of the world.
Vec3 as_of_the_world(const Screen& screen, const Vec3& normal) {
    const Vec3d turned = screen.to_view(screen.eye() + Vec3d(normal));
    return Vec3(glm::normalize(turned));
}

template <Rules rules>
bool hides(const Vec3& surface, const Vec3& there, const Vec3& here, const Vec3& normal,
           float radius) {
    const bool nearer = surface.z < there.z;
    if (nearer == rules.farther) return false;
    const Vec3 way = surface - here;
    const float squared = glm::dot(way, way);
    const bool near = rules.range_by_z ? std::abs(way.z) <= radius : squared <= radius * radius;
    if (!near && !rules.no_range) return false;
    return rules.no_plane || stands_out(glm::dot(way, normal), squared, here.z);
}

template <Rules rules>
float occlusion_at(const GBuffer& seen, const Screen& screen, std::span<const Vec3> kernel,
                   float radius, float turn, int x, int y) {
    const Vec3 here = seen.position(x, y);
    Vec3 normal = towards(-glm::normalize(here), seen.normal(x, y));
    if (rules.world_normal) normal = as_of_the_world(screen, normal);
    if (normal == Vec3(0)) return 0;
    const Around around(normal);
    if (rules.half_radius) radius /= 2;
    if (rules.one_short || rules.short_mean) kernel = kernel.first(kernel.size() - 1);
    int counted = rules.one_short ? 1 : 0, hidden = 0;
    for (std::size_t i = 0; i < kernel.size(); ++i) {
        const Vec3& p = kernel[i];
        Vec3 turned(std::cos(turn) * p.x - std::sin(turn) * p.y,
                    std::sin(turn) * p.x + std::cos(turn) * p.y, p.z);
        if (rules.unflipped && i % 2 == 0) turned = -turned;
        const Vec3 there = here + radius * around(turned);
        const auto surface = surface_at<rules>(seen, screen, there);
        if (surface || rules.off_frame_counts) ++counted;
        if (surface && hides<rules>(*surface, there, here, normal, radius)) ++hidden;
    }
    return counted > 0 ? float(hidden) / float(counted) : 0;
}

template <Rules rules>
void occlusion(const GBuffer& seen, const Screen& screen, std::span<const Vec3> kernel,
               const Params& params, Key key, Tile tile, ImageView<float> occluded) {
    const Scale scale(screen);
    const auto radius = static_cast<float>(params.radius);
    each_pixel(tile, [&](int x, int y) {
        occluded(x, y) = rules.visible ? 1 : 0;
        const float z = seen.position(x, y).z;
        if (!(z < std::numeric_limits<float>::infinity())) return;
        if (!rules.no_limit && !(scale.px(radius, z) >= 1)) return;
        const double shift = rules.no_turn ? 0 : 16 * key.uniform(0);
        const double turn = rules.no_turn || rules.one_turn ? shift : turn_of(x, y) + shift;
        const float share = occlusion_at<rules>(seen, screen, kernel, radius,
                                                float(2 * std::numbers::pi * turn / 16), x, y);
        occluded(x, y) = rules.visible ? 1 - share : share;
    });
}

}  // namespace

std::vector<grading::Other> occlusion_mutants() {
    return {
        {"no_range_check", "ssao.t4", "no range check: what is far in front hides, too",
         with(&Steps::occlusion, occlusion<Rules{.no_range = true}>)},
        {"range_by_z", "ssao.t4", "the range check looks at z alone: take the distance",
         with(&Steps::occlusion, occlusion<Rules{.range_by_z = true}>)},
        {"no_tangent_plane", "ssao.t4", "tilted planes hide themselves: compare with least_sine",
         with(&Steps::occlusion, occlusion<Rules{.no_plane = true}>)},
        {"unflipped_hemisphere", "ssao.t4", "points below the surface: turn them around the normal",
         with(&Steps::occlusion, occlusion<Rules{.unflipped = true}>)},
        {"world_normal", "ssao.t4",
         "normals are taken for those of the world: they are in camera "
         "space",
         with(&Steps::occlusion, occlusion<Rules{.world_normal = true}>)},
        {"divided_by_n", "ssao.t4", "N − 1 points, divided by N",
         with(&Steps::occlusion, occlusion<Rules{.one_short = true}>)},
        {"screen_wrap", "ssao.t4", "points off the frame come in again on the other side",
         with(&Steps::occlusion, occlusion<Rules{.wraps = true}>)},
        {"screen_clamp", "ssao.t4", "points off the frame take the border's pixels",
         with(&Steps::occlusion, occlusion<Rules{.clamps = true}>)},
        {"off_frame_is_free", "ssao.t4",
         "points off the frame count as visible: borders are bright",
         with(&Steps::occlusion, occlusion<Rules{.off_frame_counts = true}>)},
        {"no_turns", "ssao.t4", "all pixels take the same turn, with every key",
         with(&Steps::occlusion, occlusion<Rules{.no_turn = true}>)},
        {"one_turn", "ssao.t4", "all pixels take the same turn: bands instead of noise",
         with(&Steps::occlusion, occlusion<Rules{.one_turn = true}>)},
        {"farther_hides", "ssao.t4", "the comparison is turned round: what is nearer hides",
         with(&Steps::occlusion, occlusion<Rules{.farther = true}>)},
        {"half_the_radius", "ssao.t4", "the radius is taken for a diameter",
         with(&Steps::occlusion, occlusion<Rules{.half_radius = true}>)},
        {"next_pixel", "ssao.t4", "half a pixel off: project() has centres at ½, so round down",
         with(&Steps::occlusion, occlusion<Rules{.centre = true}>)},
        {"share_that_is_visible", "ssao.t4", "the share that is visible: occlusion is 1 − it",
         with(&Steps::occlusion, occlusion<Rules{.visible = true}>)},
    };
}

}  // namespace luch::homework::ssao
