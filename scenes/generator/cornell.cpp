#include "scenes/generator/cornell.h"

#include "framework/math/vec.h"
#include "scenes/generator/text.h"

#include <fmt/format.h>

#include <array>

namespace luch::assets {
namespace {

using Quad = std::array<Vec3d, 4>;

// The published measurements, in millimetres (Cornell University Program of Computer Graphics,
// "Cornell Box Data", 1998; after Goral, Torrance, Greenberg and Battaile, "Modeling the
// Interaction of Light Between Diffuse Surfaces", 1984). Their x runs to the left.
constexpr double width = 556;  // of the ceiling
constexpr Quad floor_quad{{{552.8, 0, 0}, {0, 0, 0}, {0, 0, 559.2}, {549.6, 0, 559.2}}};
constexpr Quad ceiling{{{556, 548.8, 0}, {556, 548.8, 559.2}, {0, 548.8, 559.2}, {0, 548.8, 0}}};
constexpr Quad back{{{549.6, 0, 559.2}, {0, 0, 559.2}, {0, 548.8, 559.2}, {556, 548.8, 559.2}}};
constexpr Quad right{{{0, 0, 559.2}, {0, 0, 0}, {0, 548.8, 0}, {0, 548.8, 559.2}}};
constexpr Quad left{{{552.8, 0, 0}, {549.6, 0, 559.2}, {556, 548.8, 559.2}, {556, 548.8, 0}}};
constexpr Quad short_top{{{130, 165, 65}, {82, 165, 225}, {240, 165, 272}, {290, 165, 114}}};
constexpr Quad tall_top{{{423, 330, 247}, {265, 330, 296}, {314, 330, 456}, {472, 330, 406}}};

/// A block that stands on the floor: its top and four sides.
std::vector<Quad> block(const Quad& top) {
    std::vector<Quad> quads{top};
    const auto foot = [](const Vec3d& corner) { return Vec3d(corner.x, 0, corner.z); };
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3d &a = top[i], &b = top[(i + 1) % 4];
        quads.push_back({a, b, foot(b), foot(a)});
    }
    return quads;
}

std::string obj_of(const std::vector<Quad>& quads) {
    std::string text =
        "# A part of the Cornell box, measured in millimetres. Written by luch_assets.\n";
    for (const Quad& quad : quads) {
        for (const Vec3d& corner : quad) {
            text += fmt::format("v {} {} {}\n", number(width - corner.x, 1), number(corner.y, 1),
                                number(corner.z, 1));
        }
    }
    for (std::size_t i = 0; i < quads.size(); ++i) {
        text += fmt::format("f {} {} {} {}\n", 4 * i + 1, 4 * i + 2, 4 * i + 3, 4 * i + 4);
    }
    return text;
}

}  // namespace

std::vector<BoxPart> cornell_parts() {
    return {{"white_walls", obj_of({floor_quad, ceiling, back})},
            {"red_wall", obj_of({left})},
            {"green_wall", obj_of({right})},
            {"short_block", obj_of(block(short_top))},
            {"tall_block", obj_of(block(tall_top))}};
}

}  // namespace luch::assets
