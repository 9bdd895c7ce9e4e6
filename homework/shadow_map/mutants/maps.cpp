#include "homework/shadow_map/mutants/mutants.h"

#include <cmath>

namespace luch::homework::shadow_map {
namespace {

using namespace techniques::shadow_map;

constexpr float infinite = std::numeric_limits<float>::infinity();

struct TexelRules {
    bool swapped = false, mirrored = false, one_side = false, other_side = false;
    bool last_of_equals = false, past_the_end = false, rounded = false, one_short = false;
    bool not_divided = false, by_angle = false, by_length = false, unguarded = false;
};

template <TexelRules rules>
Texel texel(Vec3 d, int n) {
    if (rules.by_length) d = glm::normalize(d);
    const bool sound = all_finite(d) && d != Vec3(0);
    if (!sound && !rules.unguarded) return {0, n / 2, n / 2};
    if (!sound) d = Vec3(-1, -1, -1);  // whatever comes of no number
    const Vec3 size = glm::abs(d);
    int axis = 0;
    for (int k = 1; k < 3; ++k) {
        if (size[k] > size[axis] || (rules.last_of_equals && size[k] == size[axis])) axis = k;
    }
    const bool negative = rules.one_side ? false : (d[axis] < 0) != rules.other_side;
    const auto cell = [&](int along, bool turned) {
        float u = d[along] / (rules.not_divided ? glm::length(d) : size[axis]);
        if (turned) u = -u;
        if (rules.by_angle) u = std::atan(u) / 0.78539816f;
        const float place = (u + 1) / 2 * float(rules.one_short ? n - 1 : n);
        const int at = static_cast<int>(std::floor(rules.rounded ? place + 0.5f : place));
        return rules.past_the_end ? at : std::clamp(at, 0, n - 1);
    };
    const int x = (axis + 1) % 3, y = (axis + 2) % 3;
    return {2 * axis + (negative ? 1 : 0), cell(rules.swapped ? y : x, rules.mirrored && negative),
            cell(rules.swapped ? x : y, false)};
}

template <TexelRules rules>
void texel_of(std::span<const Vec3> directions, int n, std::span<Texel> texels) {
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = texel<rules>(directions[i], n);
}

struct DirectionRules {
    bool corner = false, one_short = false, swapped = false, mirrored = false, other_side = false;
    bool any_length = false, zero_to_one = false;
};

template <DirectionRules rules>
void direction_of(std::span<const Texel> texels, int n, std::span<Vec3> directions) {
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const auto& [face, x, y] = texels[i];
        const auto place = [&](int cell) {
            const double at = cell + (rules.corner || rules.one_short ? 0 : 0.5);
            const double share = at / (rules.one_short ? n - 1 : n);
            return rules.zero_to_one ? share : 2 * share - 1;
        };
        const bool negative = (face % 2 == 1) != rules.other_side;
        Vec3 d;
        d[face / 2] = negative ? -1.0f : 1.0f;
        d[(face / 2 + (rules.swapped ? 2 : 1)) % 3] =
            static_cast<float>(rules.mirrored && negative ? -place(x) : place(x));
        d[(face / 2 + (rules.swapped ? 1 : 2)) % 3] = static_cast<float>(place(y));
        directions[i] = rules.any_length ? d : glm::normalize(d);
    }
}

struct FaceRules {
    enum Stored { distance, depth, square, inverse } stored = distance;
    float miss = infinite, t_min = 0, t_max = infinite;
    bool corner = false, transposed = false, behind = false;
    bool place_on_face = false, forgets_corner = false, n_of_image = false;
    bool in_float = false, twice = false;
    RayKind kind = RayKind::shadow;
};

template <FaceRules rules>
void render_face(const Vec3d& light, int face, int n, Tile tile, Tracer& tracer,
                 ImageView<float> distance) {
    if (rules.n_of_image) n = distance.width();
    if (rules.forgets_corner) tile = distance.tile();
    const int x0 = rules.place_on_face ? 0 : tile.x0, y0 = rules.place_on_face ? 0 : tile.y0;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            const Texel texel = rules.transposed ? Texel{face, y, x} : Texel{face, x, y};
            Vec3 d;
            reference().direction_of({&texel, 1}, n, {&d, 1});
            const double along = std::abs(d[face / 2]);
            if (rules.corner) {
                d[(face / 2 + 1) % 3] -= float(along / n);
                d[(face / 2 + 2) % 3] -= float(along / n);
                d = glm::normalize(d);
            }
            Ray ray{light, rules.behind ? -Vec3d(d) : Vec3d(d), rules.t_min, rules.t_max};
            if (rules.in_float) ray.origin = Vec3d(Vec3(light));
            Hit hit = tracer.closest(rules.kind, ray);
            if (rules.twice) hit = tracer.closest(rules.kind, ray);
            float stored = hit.t;
            if (rules.stored == FaceRules::depth) stored *= float(along);
            if (rules.stored == FaceRules::square) stored *= stored;
            if (rules.stored == FaceRules::inverse) stored = 1 / stored;
            distance.data()[(y - y0) * distance.width() + x - x0] = hit ? stored : rules.miss;
        }
    }
}

template <TexelRules rules>
grading::Other texel_mutant(const char* name, const char* cause) {
    return {name, "shadow_map.t1", cause, with(&Steps::texel_of, texel_of<rules>)};
}

template <DirectionRules rules>
grading::Other direction_mutant(const char* name, const char* cause) {
    return {name, "shadow_map.t2", cause, with(&Steps::direction_of, direction_of<rules>)};
}

template <FaceRules rules>
grading::Other face_mutant(const char* name, const char* cause) {
    return {name, "shadow_map.t3", cause, with(&Steps::render_face, render_face<rules>)};
}

}  // namespace

std::vector<grading::Other> map_mutants() {
    return {
        texel_mutant<TexelRules{.swapped = true}>("axes_swapped",
                                                  "the face's x and y are swapped: x → y → z "
                                                  "→ x"),
        texel_mutant<TexelRules{.mirrored = true}>(
            "mirrored_faces", "faces that look against an axis are mirrored: none is"),
        texel_mutant<TexelRules{.one_side = true}>(
            "sign_forgotten", "faces 1, 3, 5 are never used: the sign is forgotten"),
        texel_mutant<TexelRules{.other_side = true}>("sides_swapped",
                                                     "faces along an axis and against it are "
                                                     "swapped: s is 1 against it"),
        texel_mutant<TexelRules{.last_of_equals = true}>(
            "last_of_equals", "of equal |components| the last is taken, not the first"),
        texel_mutant<TexelRules{.past_the_end = true}>(
            "past_the_end", "a place at 1 is past the last texel: keep it in"),
        texel_mutant<TexelRules{.rounded = true}>(
            "half_texel_shift", "rounded to the nearest: half a texel off. Round down"),
        texel_mutant<TexelRules{.one_short = true}>(
            "one_texel_short", "multiplied by n − 1: there are n texels, not borders"),
        texel_mutant<TexelRules{.not_divided = true}>(
            "not_divided", "not divided by the largest |component|, but by the length"),
        texel_mutant<TexelRules{.by_angle = true}>(
            "by_angle", "the angle is used: a face is flat, use the ratio"),
        texel_mutant<TexelRules{.by_length = true}>(
            "squares_overflow", "squares overflow or vanish: the length is not needed"),
        texel_mutant<TexelRules{.unguarded = true}>(
            "no_direction", "a direction that is zero or not finite is not caught"),

        direction_mutant<DirectionRules{.corner = true}>(
            "texel_corner", "through the texel's corner: half a texel is missing"),
        direction_mutant<DirectionRules{.one_short = true}>(
            "edge_to_edge", "divided by n − 1: that goes through the edges"),
        direction_mutant<DirectionRules{.swapped = true}>(
            "direction_axes_swapped", "the face's x and y are swapped: x → y → z → x"),
        direction_mutant<DirectionRules{.mirrored = true}>(
            "direction_mirrored", "faces that look against an axis are mirrored: none is"),
        direction_mutant<DirectionRules{.other_side = true}>(
            "direction_other_side", "along the axis and against it are swapped: s is 1 against it"),
        direction_mutant<DirectionRules{.any_length = true}>("not_unit", "the length is not 1"),
        direction_mutant<DirectionRules{.zero_to_one = true}>("zero_to_one",
                                                              "a face goes from −1 to 1, not from "
                                                              "0"),

        face_mutant<FaceRules{.stored = FaceRules::depth}>(
            "depth_for_distance",
            "depth along the axis is stored, or t of a ray whose direction is not of length 1: the "
            "distance is asked for"),
        face_mutant<FaceRules{.stored = FaceRules::square}>("square_of_distance",
                                                            "the square of the distance is stored"),
        face_mutant<FaceRules{.stored = FaceRules::inverse}>(
            "inverse_distance", "the inverse of the distance is stored"),
        face_mutant<FaceRules{.miss = 0}>("miss_is_zero",
                                          "where nothing is hit it is dark: infinity, not 0"),
        face_mutant<FaceRules{.miss = 1e6f}>(
            "miss_is_large", "where nothing is hit a number is stored, not infinity"),
        face_mutant<FaceRules{.corner = true}>(
            "ray_through_corner", "rays go through the texels' corners, not their centres"),
        face_mutant<FaceRules{.transposed = true}>("transposed",
                                                   "x and y of the image are swapped"),
        face_mutant<FaceRules{.behind = true}>("looks_back", "rays run the other way"),
        face_mutant<FaceRules{.place_on_face = true}>(
            "writes_past_the_tile", "written at the place on the face: the image is the tile's"),
        face_mutant<FaceRules{.forgets_corner = true}>(
            "tile_corner_forgotten", "the tile's corner is forgotten: it begins at (x0, y0)"),
        face_mutant<FaceRules{.n_of_image = true}>(
            "n_of_the_image", "the image's width is taken for n: it is the tile's width"),
        face_mutant<FaceRules{.t_min = 1e-3f}>(
            "fixed_epsilon", "t_min is a fixed length, under which all is lost: take 0"),
        face_mutant<FaceRules{.t_max = 1e4f}>("fixed_end",
                                              "t_max is a fixed length: take infinity"),
        face_mutant<FaceRules{.in_float = true}>("light_in_float",
                                                 "the light's position was rounded to float"),
        face_mutant<FaceRules{.kind = RayKind::primary}>(
            "counted_as_primary", "the rays are shadow rays: RayKind::shadow"),
        face_mutant<FaceRules{.twice = true}>("shot_twice", "every ray is shot twice"),
    };
}

}  // namespace luch::homework::shadow_map
