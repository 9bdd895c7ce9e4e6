#include "homework/shadow_map/mutants/mutants.h"

#include <cmath>

namespace luch::homework::shadow_map {
namespace {

using namespace techniques::shadow_map;

struct LightRules {
    enum Jitter { each, same, none, everywhere, diagonal, half, middle } jitter = each;
    enum Random { anywhere, in_cells, corner, squared } random = anywhere;
    enum Grid { middles, corners, ends, in_line, turned } grid = middles;
    bool whole_power = false, not_lifted = false, below = false, not_placed = false;
    bool zero_to_one = false, appends = false, one_key = false, counts_on = false;
    bool regular_is_jittered = false, one_more = false;
};

int rows_of(int n) {
    int rows = static_cast<int>(std::sqrt(double(n)) + 1e-9);
    while (n % rows != 0) --rows;
    return rows;
}

template <LightRules rules>
Vec2d within(Pattern pattern, const Key& key, std::uint64_t i) {
    if (pattern == Pattern::regular && !rules.regular_is_jittered) {
        return Vec2d(rules.grid == LightRules::corners ? 0 : 0.5);
    }
    Vec2d drawn = key.square(i);
    if (pattern == Pattern::random) {
        if (rules.random == LightRules::corner) drawn *= 0.5;
        if (rules.random == LightRules::squared) drawn *= drawn;
        return drawn;
    }
    switch (rules.jitter) {
        case LightRules::same:
            return key.square(0);
        case LightRules::none:
            return Vec2d(0.5);
        case LightRules::diagonal:
            return Vec2d(drawn.x);
        case LightRules::half:
            return drawn - 0.5;
        case LightRules::middle:
            return 0.25 + 0.5 * drawn;
        default:
            return drawn;
    }
}

template <LightRules rules>
Vec2d place(Pattern pattern, const Key& key, int n, int i) {
    const Vec2d inside = within<rules>(pattern, key, static_cast<std::uint64_t>(i));
    const bool free = pattern == Pattern::random
                          ? rules.random != LightRules::in_cells
                          : pattern == Pattern::jittered && rules.jitter == LightRules::everywhere;
    if (free) return inside;
    int rows = rows_of(n), columns = n / rows;
    if (rules.grid == LightRules::turned) std::swap(rows, columns);
    if (rules.grid == LightRules::in_line) {
        rows = 1;
        columns = n;
    }
    Vec2d cell(i % columns, i / columns);
    if (rules.grid == LightRules::ends && pattern == Pattern::regular) {
        return cell / Vec2d(std::max(columns - 1, 1), std::max(rows - 1, 1));
    }
    return (cell + inside) / Vec2d(columns, rows);
}

template <LightRules rules>
void light_points(const RectLight& light, int n, Pattern pattern, Key key,
                  std::vector<LightPoint>& points) {
    static std::uint64_t calls = 0;
    if (!rules.appends) points.clear();
    if (rules.one_key) key = Key(1);
    if (rules.counts_on) key = key.branch(++calls);
    for (int i = 0; i < n + (rules.one_more ? 1 : 0); ++i) {
        const Vec2d at = place<rules>(pattern, key, n, i) - (rules.zero_to_one ? 0 : 0.5);
        Vec3d position = lifted_off(light, at.x, at.y);
        const Vec3d face = light.to_world.point({at.x, 0, at.y});
        if (rules.not_lifted) position = face;
        if (rules.below) position = face - 1e-9 * light.facing();
        if (rules.not_placed) position = Vec3d(at.x, 0, at.y);
        points.push_back({position, rules.whole_power ? 1 : 1 / float(n)});
    }
}

template <LightRules rules>
grading::Other mutant(const char* name, const char* cause) {
    return {name, "shadow_map.t7", cause, with(&Steps::light_points, light_points<rules>)};
}

}  // namespace

std::vector<grading::Other> light_mutants() {
    using L = LightRules;
    return {
        mutant<LightRules{.grid = L::corners}>("cell_corners",
                                               "regular: in the cells' corners, not their middles"),
        mutant<LightRules{.grid = L::ends}>("edge_to_edge_grid",
                                            "regular: from edge to edge; cells have middles"),
        mutant<LightRules{.grid = L::in_line}>("in_a_line",
                                               "all cells in one row: c × r of them, r ≤ √n"),
        mutant<LightRules{.grid = L::turned}>(
            "grid_turned", "columns and rows are swapped: more along the light's x"),
        mutant<LightRules{.jitter = L::same}>(
            "one_jitter_for_all", "jittered: every cell has the same number: key.square(i)"),
        mutant<LightRules{.jitter = L::none}>("no_jitter",
                                              "jittered: the points are the regular ones"),
        mutant<LightRules{.jitter = L::everywhere}>(
            "jitter_everywhere",
            "jittered: the points lie anywhere, not one in each "
            "cell"),
        mutant<LightRules{.jitter = L::diagonal}>("diagonal",
                                                  "jittered: one number for both axes: a diagonal"),
        mutant<LightRules{.jitter = L::half}>("half_a_cell_off",
                                              "jittered: half a cell off: 0..1 within the cell"),
        mutant<LightRules{.jitter = L::middle}>("jitter_too_small",
                                                "jittered: only the middle of each cell is used"),
        mutant<LightRules{.random = L::in_cells}>(
            "random_in_cells", "random: one in each cell is jittered, not random"),
        mutant<LightRules{.random = L::corner}>("random_in_a_corner",
                                                "random: only a part of the light is used"),
        mutant<LightRules{.random = L::squared}>("random_uneven",
                                                 "random: some places come more often"),
        mutant<LightRules{.whole_power = true}>(
            "whole_power", "each point has all of the light's power: divide by n"),
        mutant<LightRules{.not_lifted = true}>(
            "not_lifted", "the points lie in the light's own face: lifted_off()"),
        mutant<LightRules{.below = true}>("behind_the_face",
                                          "the points lie behind the light's face"),
        mutant<LightRules{.not_placed = true}>("not_in_the_world",
                                               "the places are the light's own, not the world's: "
                                               "lifted_off()"),
        mutant<LightRules{.zero_to_one = true}>("off_the_square", "the square is −½..½, not 0..1"),
        mutant<LightRules{.appends = true}>("added_to_the_old",
                                            "what was in the list before is still there"),
        mutant<LightRules{.one_more = true}>("one_too_many", "n + 1 points"),
        mutant<LightRules{.one_key = true}>("key_ignored", "every key gives the same points"),
        mutant<LightRules{.counts_on = true}>(
            "running_counter", "the points depend on earlier calls: only on the key"),
        mutant<LightRules{.regular_is_jittered = true}>("regular_at_random",
                                                        "regular: the points are random"),
    };
}

}  // namespace luch::homework::shadow_map
