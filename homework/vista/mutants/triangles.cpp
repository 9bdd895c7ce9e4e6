#include "homework/vista/mutants/mutants.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace luch::homework::vista {
namespace {

using namespace techniques::vista;

void not_at_all(std::span<const Tri> triangles, const Frustum&, std::vector<Tri>& inside) {
    inside.assign(triangles.begin(), triangles.end());
}

bool is_inside(const Corner& corner, const Frustum& frustum) {
    return std::all_of(frustum.inward.begin(), frustum.inward.end(),
                       [&](const Vec3d& inward) { return glm::dot(inward, corner.p) >= 0; });
}

/// What reaches out is thrown away whole.
void all_or_nothing(std::span<const Tri> triangles, const Frustum& frustum,
                    std::vector<Tri>& inside) {
    inside.clear();
    for (const Tri& triangle : triangles) {
        const auto& corners = triangle.corners;
        if (std::all_of(corners.begin(), corners.end(),
                        [&](const Corner& c) { return is_inside(c, frustum); })) {
            inside.push_back(triangle);
        }
    }
}

/// No near side: what lies in front of the four sides' backs is kept, too. Each side alone is cut
/// right, but those of a triangle with a corner behind the eye are skipped.
void no_near_clip(std::span<const Tri> triangles, const Frustum& frustum,
                  std::vector<Tri>& inside) {
    inside.clear();
    std::vector<Tri> one;
    for (const Tri& triangle : triangles) {
        const auto& corners = triangle.corners;
        const bool behind =
            std::any_of(corners.begin(), corners.end(), [](const Corner& c) { return c.p.z <= 0; });
        if (behind) {
            inside.push_back(triangle);
            continue;
        }
        reference().clip({&triangle, 1}, frustum, one);
        inside.insert(inside.end(), one.begin(), one.end());
    }
}

/// A triangle that was cut is a polygon; only its first three corners are kept.
void first_three_corners(std::span<const Tri> triangles, const Frustum& frustum,
                         std::vector<Tri>& inside) {
    inside.clear();
    std::vector<Tri> one;
    for (const Tri& triangle : triangles) {
        reference().clip({&triangle, 1}, frustum, one);
        if (!one.empty()) inside.push_back(one.front());
    }
}

/// The floor's side of the frame is forgotten.
void three_sides(std::span<const Tri> triangles, const Frustum& frustum, std::vector<Tri>& inside) {
    Frustum three = frustum;
    three.inward[3] = three.inward[2];
    reference().clip(triangles, three, inside);
}

/// w is left as it was at the corner inside.
void w_forgotten(std::span<const Tri> triangles, const Frustum& frustum, std::vector<Tri>& inside) {
    reference().clip(triangles, frustum, inside);
    for (Tri& triangle : inside) {
        for (Corner& corner : triangle.corners) corner.w = 1;
    }
}

template <class Distance>
void by(std::span<Tri> triangles, const Distance& less) {
    std::stable_sort(triangles.begin(), triangles.end(), less);
}

double distance(const Corner& corner) {
    return corner.w > 0 ? glm::length(corner.p) / corner.w
                        : std::numeric_limits<double>::infinity();
}

double farthest(const Tri& triangle) {
    const auto& [a, b, c] = triangle.corners;
    return std::max({distance(a), distance(b), distance(c)});
}

double nearest(const Tri& triangle) {
    const auto& [a, b, c] = triangle.corners;
    return std::min({distance(a), distance(b), distance(c)});
}

void nearest_first(std::span<Tri> triangles) {
    by(triangles, [](const Tri& a, const Tri& b) { return farthest(a) < farthest(b); });
}

void by_nearest_corner(std::span<Tri> triangles) {
    by(triangles, [](const Tri& a, const Tri& b) { return nearest(a) > nearest(b); });
}

void equals_turned_round(std::span<Tri> triangles) {
    std::reverse(triangles.begin(), triangles.end());
    by(triangles, [](const Tri& a, const Tri& b) { return farthest(a) > farthest(b); });
}

void not_sorted(std::span<Tri>) {}

template <class Change>
void changed(std::span<const Tri> triangles, const Screen& screen, std::span<ScreenTri> result,
             const Change& change) {
    reference().project(triangles, screen, result);
    for (ScreenTri& triangle : result) {
        if (triangle.node != no_node) change(triangle);
    }
}

void upside_down(std::span<const Tri> triangles, const Screen& screen,
                 std::span<ScreenTri> result) {
    changed(triangles, screen, result, [&](ScreenTri& triangle) {
        for (Vec2d& px : triangle.px) px.y = screen.size().height - px.y;
    });
}

void mirrored(std::span<const Tri> triangles, const Screen& screen, std::span<ScreenTri> result) {
    changed(triangles, screen, result, [&](ScreenTri& triangle) {
        for (Vec2d& px : triangle.px) px.x = screen.size().width - px.x;
    });
}

void half_a_pixel_off(std::span<const Tri> triangles, const Screen& screen,
                      std::span<ScreenTri> result) {
    changed(triangles, screen, result, [](ScreenTri& triangle) {
        for (Vec2d& px : triangle.px) px -= 0.5;
    });
}

void aspect_forgotten(std::span<const Tri> triangles, const Screen& screen,
                      std::span<ScreenTri> result) {
    const double stretch = screen.half_height() / screen.half_width();
    const double grid = pixel_grid(screen.size());
    changed(triangles, screen, result, [&](ScreenTri& triangle) {
        for (Vec2d& px : triangle.px) {
            const double middle = screen.size().height / 2.0;
            px.y = std::round((middle + (px.y - middle) * stretch) / grid) * grid;
        }
    });
}

void depth_for_its_inverse(std::span<const Tri> triangles, const Screen& screen,
                           std::span<ScreenTri> result) {
    changed(triangles, screen, result, [](ScreenTri& triangle) {
        for (double& inverse : triangle.inverse_depth) inverse = 1 / std::max(inverse, 1e-9);
    });
}

/// Divides by |z|: what is behind the eye is seen, too.
void behind_kept(std::span<const Tri> triangles, const Screen& screen,
                 std::span<ScreenTri> result) {
    std::vector<Tri> before(triangles.begin(), triangles.end());
    for (Tri& triangle : before) {
        for (Corner& corner : triangle.corners) corner.p.z = std::abs(corner.p.z);
    }
    reference().project(before, screen, result);
}

}  // namespace

std::vector<grading::Other> triangle_mutants() {
    return {
        {"not_clipped", "vista.t3", "nothing is cut", with(&Steps::clip, not_at_all)},
        {"no_near_clip", "vista.t3", "triangles with a corner behind the eye are not cut",
         with(&Steps::clip, no_near_clip)},
        {"all_or_nothing", "vista.t3", "what reaches out of the frame is dropped, not cut",
         with(&Steps::clip, all_or_nothing)},
        {"first_three_corners", "vista.t3", "of the cut polygon only one triangle is kept",
         with(&Steps::clip, first_three_corners)},
        {"three_sides", "vista.t3", "one side of the frame is forgotten",
         with(&Steps::clip, three_sides)},
        {"w_forgotten", "vista.t3", "w is not cut along with p", with(&Steps::clip, w_forgotten)},
        {"nearest_first", "vista.t4", "the near is painted before the far",
         with(&Steps::sort, nearest_first)},
        {"by_nearest_corner", "vista.t4", "sorted by the nearest corner, not the farthest",
         with(&Steps::sort, by_nearest_corner)},
        {"equals_turned_round", "vista.t4", "equally far triangles do not keep their order",
         with(&Steps::sort, equals_turned_round)},
        {"not_sorted", "vista.t4", "nothing is sorted", with(&Steps::sort, not_sorted)},
        {"upside_down", "vista.t5", "y runs upwards: a pixel's y runs downwards",
         with(&Steps::project, upside_down)},
        {"mirrored", "vista.t5", "left and right are exchanged", with(&Steps::project, mirrored)},
        {"half_a_pixel_off", "vista.t5",
         "half a pixel is subtracted: (0, 0) is the corner of the first pixel, not its centre",
         with(&Steps::project, half_a_pixel_off)},
        {"aspect_forgotten", "vista.t5", "half_width stands where half_height belongs",
         with(&Steps::project, aspect_forgotten)},
        {"depth_for_its_inverse", "vista.t5", "z/w is stored instead of w/z",
         with(&Steps::project, depth_for_its_inverse)},
        {"behind_kept", "vista.t5", "corners behind the eye are projected, too",
         with(&Steps::project, behind_kept)},
    };
}

}  // namespace luch::homework::vista
