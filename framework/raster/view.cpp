#include "framework/raster/view.h"

#include "framework/accel/node_hit.h"

#include <glm/matrix.hpp>

namespace luch::raster {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// The direction through a pixel, X and Y from the middle, that is 1 along the view axis.
Vec3d long_direction(const Sight& sight, double x, double y) {
    const Screen& screen = *sight.screen;
    const Vec3d unit =
        screen.ray(sight.middle_x() + x + sight.offset.x, sight.middle_y() + y + sight.offset.y)
            .direction;
    return unit / glm::dot(unit, screen.forward());
}

/// D(X, Y) in the world, and the reach of X and Y (four pixels more than the frame).
struct Directions {
    double reach_x, reach_y;
    Vec3d d, dx, dy;
    double longest;

    explicit Directions(const Sight& sight)
        : reach_x(sight.screen->size().width - sight.middle_x() + 4),
          reach_y(sight.screen->size().height - sight.middle_y() + 4) {
        d = long_direction(sight, 0, 0);
        dx = (long_direction(sight, reach_x, 0) - d) / reach_x;
        dy = (long_direction(sight, 0, reach_y) - d) / reach_y;
        longest = max_norm(d) + reach_x * max_norm(dx) + reach_y * max_norm(dy);
    }
};

float sum_of_sizes(const Vec3d& v) {
    return static_cast<float>(std::abs(v.x) + std::abs(v.y) + std::abs(v.z));
}

void put(const Vec3d& v, float (&to)[3]) {
    for (int axis = 0; axis < 3; ++axis) to[axis] = static_cast<float>(v[axis]);
}

/// a·plane ≥ 0 for what is seen; rounding to float and in the products: far below 2⁻²⁰.
void set_plane(View& view, int i, const Vec3d& plane) {
    put(plane, view.plane[i]);
    view.slack[i] = 0x1p-18f * sum_of_sizes(plane);
}

void set_inverse(View& view, const Vec3d& to_w, const Vec3d& to_x, const Vec3d& to_y) {
    put(to_w, view.to_w);
    put(to_x, view.to_x);
    put(to_y, view.to_y);
    view.size_w = sum_of_sizes(to_w);
    view.size_x = sum_of_sizes(to_x);
    view.size_y = sum_of_sizes(to_y);
    set_plane(view, 0, to_w);
    set_plane(view, 1, to_x + (view.middle_x + 2.0) * to_w);
    set_plane(view, 2, (view.width - view.middle_x + 2.0) * to_w - to_x);
    set_plane(view, 3, to_y + (view.middle_y + 2.0) * to_w);
    set_plane(view, 4, (view.height - view.middle_y + 2.0) * to_w - to_y);
}

/// Inverts the map from (w, X·w, Y·w) to points; false when rounding spoils the inverse.
bool invert(View& view, const Vec3d& d, const Vec3d& dx, const Vec3d& dy, double reach_x,
            double reach_y) {
    const glm::dmat3 forth(d, dx * reach_x, dy * reach_y);  // columns: forth · (w, …) = point
    const glm::dmat3 back = glm::inverse(forth);
    const glm::dmat3 off = back * forth - glm::dmat3(1);
    if (!(max_norm(off) < 0x1p-27)) return false;
    const glm::dmat3 rows = glm::transpose(back);
    set_inverse(view, rows[0], rows[1] * reach_x, rows[2] * reach_y);
    return true;
}

bool tame(double x) {
    return x > 0x1p-60 && x < 0x1p60;
}

std::int16_t clamped(double x, int most) {
    return static_cast<std::int16_t>(std::clamp(x, -1.0, static_cast<double>(most)));
}

}  // namespace

View view_of(const Sight& sight, const Node& node) {
    View view{};
    const Directions world(sight);
    const Vec3 origin(node.to_object.point(sight.screen->eye()));
    const Vec3d d = node.to_object.direction(world.d), dx = node.to_object.direction(world.dx),
                dy = node.to_object.direction(world.dy);
    view.middle_x = sight.middle_x();
    view.middle_y = sight.middle_y();
    view.width = sight.screen->size().width;
    view.height = sight.screen->size().height;
    put(Vec3d(origin), view.origin);
    put(d, view.d);
    put(dx, view.dx);
    put(dy, view.dy);
    for (int axis = 0; axis < 3; ++axis) {
        view.d_exact[axis] = d[axis];
        view.dx_exact[axis] = dx[axis];
        view.dy_exact[axis] = dy[axis];
    }
    view.step = 1.001f * (sum_of_sizes(dx) + sum_of_sizes(dy));
    // The last term is for what cancels in the transform: 2⁻⁴⁰ of it is u · 2⁻¹⁶ of it.
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3d column = glm::abs(node.to_object.matrix[axis]);
        sum += std::abs(d[axis]) + world.reach_x * std::abs(dx[axis]) +
               world.reach_y * std::abs(dy[axis]) +
               0x1p-16 * world.longest * (column.x + column.y + column.z);
    }
    view.sum = static_cast<float>(sum * 1.001);
    view.hopeless = !tame(sum) || !(max_norm(Vec3d(origin)) < 0x1p60) ||
                    !invert(view, d, dx, dy, world.reach_x, world.reach_y);
    return view;
}

Extent everywhere(Size size) {
    return {{0, 0, static_cast<std::int16_t>(size.width - 1),
             static_cast<std::int16_t>(size.height - 1)},
            infinity};
}

Extent extent_of(const View& view, const Boxd& box) {
    const Size size{view.width, view.height};
    const double far = std::max(max_norm(box.lo), max_norm(box.hi));
    if (view.hopeless || !std::isfinite(far)) return everywhere(size);
    double x0 = view.width, x1 = -1, y0 = view.height, y1 = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3d a((corner & 1) != 0 ? box.hi.x : box.lo.x,
                      (corner & 2) != 0 ? box.hi.y : box.lo.y,
                      (corner & 4) != 0 ? box.hi.z : box.lo.z);
        const auto along = [&](const float(&to)[3]) {
            return a.x * to[0] + a.y * to[1] + a.z * to[2];
        };
        const double w = along(view.to_w);
        if (!(w > 0x1p-14 * far * view.size_w)) return everywhere(size);
        const double x = along(view.to_x) / w, y = along(view.to_y) / w;
        const double slack = 0x1p-18 * far / w;
        const double pad_x = slack * (view.size_x + std::abs(x) * view.size_w) + 0.01;
        const double pad_y = slack * (view.size_y + std::abs(y) * view.size_w) + 0.01;
        x0 = std::min(x0, x - pad_x + view.middle_x);
        x1 = std::max(x1, x + pad_x + view.middle_x);
        y0 = std::min(y0, y - pad_y + view.middle_y);
        y1 = std::max(y1, y + pad_y + view.middle_y);
        least = std::min(least, w - 0x1p-18 * far * view.size_w);
    }
    return {{clamped(std::max(std::ceil(x0), 0.0), view.width),
             clamped(std::max(std::ceil(y0), 0.0), view.height),
             clamped(std::floor(x1), view.width - 1), clamped(std::floor(y1), view.height - 1)},
            static_cast<float>(1.0001 / least)};
}

Extent world_extent_of(const Sight& sight, const Boxd& box, double slack) {
    Node world;
    View view = view_of(sight, world);
    const Vec3d eye = sight.screen->eye();
    const Vec3d lo = box.lo - eye, hi = box.hi - eye;
    const double padding = slack * std::max(max_norm(lo), max_norm(hi));
    return extent_of(view, {lo - padding, hi + padding});
}

}  // namespace luch::raster
