#include "scenes/generator/newell.h"

namespace luch::assets {
namespace {

/// A quarter circle's four control points: (radius, 0), (radius, pull), (pull, radius), (0,
/// radius).
struct Quarter {
    double radius, pull, height;
};
using Profile = std::array<Quarter, 4>;

// Inside of the rim over its edge, down the body, round the foot to the middle of the bottom.
constexpr Profile body[] = {
    {{{1.4, 0.784, 2.4}, {1.3375, 0.749, 2.53125}, {1.4375, 0.805, 2.53125}, {1.5, 0.84, 2.4}}},
    {{{1.5, 0.84, 2.4}, {1.75, 0.98, 1.875}, {2, 1.12, 1.35}, {2, 1.12, 0.9}}},
    {{{2, 1.12, 0.9}, {2, 1.12, 0.45}, {1.5, 0.84, 0.225}, {1.5, 0.84, 0.15}}},
    {{{1.5, 0.84, 0.15}, {1.5, 0.84, 0.075}, {1.425, 0.798, 0}, {0, 0, 0}}},
};

// From the top of the knob down to the lid's edge.
constexpr Profile lid[] = {
    {{{0, 0, 3.15}, {0.8, 0.45, 3.15}, {0, 0, 2.85}, {0.2, 0.112, 2.7}}},
    {{{0.2, 0.112, 2.7}, {0.4, 0.224, 2.55}, {1.3, 0.728, 2.55}, {1.3, 0.728, 2.4}}},
};

/// Half a ring's four control points: (x0, 0), (x0, width), (x1, width), (x1, 0) at heights y0, y1.
struct Half {
    double x0, y0, x1, y1, width;
};
using Tube = std::array<Half, 4>;

// From the body's upper end to its lower one; x0, y0 is the inner side.
constexpr Tube handle[] = {
    {{{-1.6, 2.025, -1.5, 2.25, 0.3},
      {-2.3, 2.025, -2.5, 2.25, 0.3},
      {-2.7, 2.025, -3, 2.25, 0.3},
      {-2.7, 1.8, -3, 1.8, 0.3}}},
    {{{-2.7, 1.8, -3, 1.8, 0.3},
      {-2.7, 1.575, -3, 1.35, 0.3},
      {-2.5, 1.125, -2.65, 0.9375, 0.3},
      {-2, 0.9, -1.9, 0.6, 0.3}}},
};

// From the body to the mouth and over its lip; x0, y0 is the upper side.
constexpr Tube spout[] = {
    {{{1.7, 1.425, 1.7, 0.6, 0.66},
      {2.6, 1.425, 3.1, 0.825, 0.66},
      {2.3, 2.1, 2.4, 2.025, 0.25},
      {2.7, 2.4, 3.3, 2.4, 0.25}}},
    {{{2.7, 2.4, 3.3, 2.4, 0.25},
      {2.8, 2.475, 3.525, 2.49375, 0.25},
      {2.9, 2.475, 3.45, 2.5125, 0.15},
      {2.8, 2.4, 3.2, 2.4, 0.15}}},
};

/// A quarter turn about y.
Vec3d turned(const Vec3d& p, int quarters) {
    Vec3d q = p;
    for (int k = 0; k < quarters; ++k) q = {q.z, q.y, -q.x};
    return q;
}

Patch quarter_patch(const Profile& profile, int quarters) {
    Patch patch;
    for (int i = 0; i < 4; ++i) {
        const auto [r, p, y] = profile[i];
        patch.rows[i] = {Vec3d(r, y, 0), Vec3d(r, y, -p), Vec3d(p, y, -r), Vec3d(0, y, -r)};
        for (Vec3d& point : patch.rows[i]) point = turned(point, quarters);
    }
    return patch;
}

/// The half of the ring on the −z side, or the one that leads back on the +z side.
Patch half_patch(const Tube& tube, bool back) {
    Patch patch;
    for (int i = 0; i < 4; ++i) {
        const auto [x0, y0, x1, y1, w] = tube[i];
        if (back) {
            patch.rows[i] = {Vec3d(x1, y1, 0), Vec3d(x1, y1, w), Vec3d(x0, y0, w),
                             Vec3d(x0, y0, 0)};
        } else {
            patch.rows[i] = {Vec3d(x0, y0, 0), Vec3d(x0, y0, -w), Vec3d(x1, y1, -w),
                             Vec3d(x1, y1, 0)};
        }
    }
    return patch;
}

template <class Rings>
Sheet turned_sheet(std::string_view name, const Rings& rings) {
    Sheet sheet{name, 4, static_cast<int>(std::size(rings)), {}};
    for (const Profile& profile : rings) {
        for (int k = 0; k < 4; ++k) sheet.patches.push_back(quarter_patch(profile, k));
    }
    sheet.starts_in_point = std::begin(rings)->front().radius == 0;
    sheet.ends_in_point = std::prev(std::end(rings))->back().radius == 0;
    return sheet;
}

template <class Rings>
Sheet tube_sheet(std::string_view name, const Rings& rings) {
    Sheet sheet{name, 2, static_cast<int>(std::size(rings)), {}};
    for (const Tube& tube : rings) {
        for (const bool back : {false, true}) sheet.patches.push_back(half_patch(tube, back));
    }
    return sheet;
}

}  // namespace

std::vector<Sheet> newell_teapot() {
    return {turned_sheet("body", body), turned_sheet("lid", lid), tube_sheet("handle", handle),
            tube_sheet("spout", spout)};
}

}  // namespace luch::assets
