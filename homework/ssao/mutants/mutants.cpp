// Mistakes that students make with surfaces and points, tasks t1 to t3: each is the reference with
// one step spoilt.
#include "homework/ssao/mutants/more.h"
#include "techniques/ssao/view.h"

#include <cmath>
#include <numbers>

namespace luch::homework::ssao {
namespace {

using namespace techniques::ssao;

constexpr float infinite = std::numeric_limits<float>::infinity();

struct PositionRules {
    double offset = 0.5;
    bool along_the_ray = false, y_down = false, takes_all = false, one_side = false, whole = false;
};

template <PositionRules rules>
void positions(ImageView<const float> z, const Screen& screen, Tile tile,
               ImageView<Vec3> position) {
    each_pixel(rules.whole ? z.tile() : tile, [&](int x, int y) {
        const float depth = z(x, y);
        Vec3d ray(screen.across(x + rules.offset), screen.upwards(y + rules.offset), 1);
        if (rules.y_down) ray.y = -ray.y;
        if (rules.one_side) ray.x /= screen.half_width() / screen.half_height();
        if (rules.along_the_ray) ray = glm::normalize(ray);
        const bool seen = rules.takes_all || (depth > 0 && depth < infinite);
        position(x, y) = seen ? Vec3(double(depth) * ray) : Vec3(0, 0, infinite);
    });
}

struct NormalRules {
    bool one_side = false, both_sides = false, not_turned = false, not_unit = false;
    bool y_flipped = false, of_nothing = false, away = false;
};

/// A step of the simplest kind: to the nearer of both neighbours in z.
template <NormalRules rules>
std::optional<Vec3> step_along(ImageView<const Vec3> position, int x, int y, bool down) {
    const auto at = [&](int i) -> std::optional<Vec3> {
        const int u = down ? x : x + i, v = down ? y + i : y;
        if (u < 0 || v < 0 || u >= position.width() || v >= position.height()) return {};
        if (!rules.of_nothing && !is_seen(position(u, v))) return {};
        return position(u, v);
    };
    const Vec3 here = position(x, y);
    const auto after = at(1), before = at(-1);
    if (rules.one_side) return after ? std::optional(*after - here) : std::nullopt;
    if (after && before) {
        if (rules.both_sides) return *after - *before;
        const bool nearer = std::abs(after->z - here.z) <= std::abs(before->z - here.z);
        return nearer ? *after - here : here - *before;
    }
    if (after) return *after - here;
    return before ? std::optional(here - *before) : std::nullopt;
}

template <NormalRules rules>
void normals(ImageView<const Vec3> position, Tile tile, ImageView<Vec3> normal) {
    each_pixel(tile, [&](int x, int y) {
        const Vec3 here = position(x, y);
        normal(x, y) = Vec3(0);
        if (!rules.of_nothing && !is_seen(here)) return;
        normal(x, y) = -glm::normalize(here);
        const auto right = step_along<rules>(position, x, y, false);
        const auto down = step_along<rules>(position, x, y, true);
        if (!right || !down) return;
        Vec3 across = glm::cross(*right, *down);
        if (!rules.not_unit) across = glm::normalize(across);
        if (rules.y_flipped) across.y = -across.y;
        if (!rules.not_turned && glm::dot(across, here) > 0) across = -across;
        normal(x, y) = rules.away ? -across : across;
    });
}

struct KernelRules {
    bool whole_sphere = false, even = false, cube = false, one_short = false, one_key = false;
    bool y_up = false, crowded = false, on_the_sphere = false;
};

template <KernelRules rules>
void kernel(Key key, std::span<Vec3> points) {
    const Key own = rules.one_key ? Key(1) : key;
    const std::size_t count = rules.one_short ? points.size() - 1 : points.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Key at = own.branch(i);
        const double turn = 2 * std::numbers::pi * at.uniform(0), u = at.uniform(1);
        const double sine = rules.even ? std::sqrt(1 - u * u) : std::sqrt(u);
        const double cosine = std::sqrt(std::max(0.0, 1 - sine * sine));
        Vec3d point(sine * std::cos(turn), sine * std::sin(turn), cosine);
        if (rules.cube) point = {2 * u - 1, 2 * at.uniform(3) - 1, at.uniform(4)};
        if (rules.whole_sphere && i % 2 == 1) point.z = -point.z;
        if (rules.crowded) point = {0, 0, 1};
        if (rules.y_up) point = {point.x, point.z, point.y};
        if (!rules.cube && !rules.on_the_sphere) point *= 0.05 + 0.95 * at.uniform(2);
        points[i] = Vec3(point);
    }
}

}  // namespace

std::vector<grading::Other> mutants() {
    std::vector<grading::Other> all{
        {"pixel_corner", "ssao.t1", "the pixel's corner: its centre is at (x + ½, y + ½)",
         with(&Steps::positions, positions<PositionRules{.offset = 0}>)},
        {"pixel_far_corner", "ssao.t1", "a whole pixel too far: its centre is at (x + ½, y + ½)",
         with(&Steps::positions, positions<PositionRules{.offset = 1}>)},
        {"along_the_ray", "ssao.t1", "z is taken for the distance from the eye: it is a depth",
         with(&Steps::positions, positions<PositionRules{.along_the_ray = true}>)},
        {"y_down", "ssao.t1", "y points down: rows do, camera space does not",
         with(&Steps::positions, positions<PositionRules{.y_down = true}>)},
        {"square_frame", "ssao.t1", "the frame is taken for a square: x and y have own scales",
         with(&Steps::positions, positions<PositionRules{.one_side = true}>)},
        {"sky_has_a_place", "ssao.t1", "depths that are none get a position: 0·∞ is NaN",
         with(&Steps::positions, positions<PositionRules{.takes_all = true}>)},
        {"positions_of_all", "ssao.t1", "writes beyond its tile",
         with(&Steps::positions, positions<PositionRules{.whole = true}>)},

        {"one_sided", "ssao.t2", "always the step to the right and down: it crosses edges",
         with(&Steps::normals, normals<NormalRules{.one_side = true}>)},
        {"both_sides", "ssao.t2", "from the neighbour before to the one after: it crosses edges",
         with(&Steps::normals, normals<NormalRules{.both_sides = true}>)},
        {"not_turned", "ssao.t2", "the cross product as it comes: turn it towards the eye",
         with(&Steps::normals, normals<NormalRules{.not_turned = true, .away = true}>)},
        {"not_unit", "ssao.t2", "the cross product has no unit length",
         with(&Steps::normals, normals<NormalRules{.not_unit = true}>)},
        {"normal_y_down", "ssao.t2", "y points down: camera space has it up",
         with(&Steps::normals, normals<NormalRules{.y_flipped = true}>)},
        {"normals_of_nothing", "ssao.t2", "the sky has neighbours, and normals",
         with(&Steps::normals, normals<NormalRules{.of_nothing = true}>)},

        {"full_sphere", "ssao.t3", "the whole ball: half of the points are below the surface",
         with(&Steps::kernel, kernel<KernelRules{.whole_sphere = true}>)},
        {"even_directions", "ssao.t3", "all directions alike: the density is cos/π",
         with(&Steps::kernel, kernel<KernelRules{.even = true}>)},
        {"half_cube", "ssao.t3", "points of a box: those in its corners are too far out",
         with(&Steps::kernel, kernel<KernelRules{.cube = true}>)},
        {"kernel_n_minus_1", "ssao.t3", "the last point is not written: N, not N − 1",
         with(&Steps::kernel, kernel<KernelRules{.one_short = true}>)},
        {"one_key_for_all", "ssao.t3", "the key is not used: all keys give the same points",
         with(&Steps::kernel, kernel<KernelRules{.one_key = true}>)},
        {"around_y", "ssao.t3", "the half-ball around +y: it is around +z",
         with(&Steps::kernel, kernel<KernelRules{.y_up = true}>)},
        {"crowded", "ssao.t3", "all points lie in one direction",
         with(&Steps::kernel, kernel<KernelRules{.crowded = true}>)},
        {"on_the_sphere", "ssao.t3", "all points are 1 away: what is near and thin is missed",
         with(&Steps::kernel, kernel<KernelRules{.on_the_sphere = true}>)},
    };
    for (auto&& some : {occlusion_mutants(), smoothing_mutants()}) {
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

}  // namespace luch::homework::ssao
