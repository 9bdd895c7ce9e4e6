// Task t7: points in the place of a light with an area. Where they lie at random is judged by what
// must hold for whatever numbers come.
#include "framework/grading/gates.h"
#include "homework/shadow_map/check/same.h"
#include "homework/shadow_map/check/tests.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace luch::homework::shadow_map {
namespace {

using grading::failure;
using grading::Finding;

constexpr int keys_tried = 64;

std::vector<LightPoint> points(const Steps& steps, const Sample& sample, int n, Pattern pattern,
                               std::uint64_t key) {
    std::vector<LightPoint> found{{Vec3d(1e9), 3}};  // what was there before is replaced
    steps.light_points(sample.area(), n, pattern, Key(key), found);
    return found;
}

std::vector<LightPoint> points(const Steps& steps, const Sample& sample, Pattern pattern,
                               std::uint64_t key) {
    return points(steps, sample, sample.points(), pattern, key);
}

/// On the light's own square: −½..½ along x and z.
std::vector<Vec2d> places(const std::vector<LightPoint>& points, const RectLight& light) {
    const Transform to_light = light.to_world.inverse();
    std::vector<Vec2d> found;
    for (const LightPoint& point : points) {
        const Vec3d place = to_light.point(point.position);
        found.emplace_back(place.x, place.z);
    }
    return found;
}

std::string text_of(const Vec2d& place) {
    return fmt::format("({:.4g}, {:.4g})", place.x, place.y);
}

std::vector<Vec2d> stored_places(const Sample& sample) {
    std::vector<LightPoint> grid;
    for (const Vec3& position : sample.grid) grid.push_back({Vec3d(position), 1});
    return places(grid, sample.area());
}

/// Row by row.
void sort(std::vector<Vec2d>& places) {
    const auto line = [](double z) { return std::round(z * 1e4); };
    std::ranges::sort(places, [&](const Vec2d& a, const Vec2d& b) {
        return line(a.y) != line(b.y) ? line(a.y) < line(b.y) : a.x < b.x;
    });
}

Finding regular_grid(const Steps& steps, const Sample& sample) {
    std::vector<Vec2d> yours = places(points(steps, sample, Pattern::regular, 1), sample.area()),
                       reference = stored_places(sample);
    sort(yours);
    sort(reference);
    std::vector<double> got, expected;
    for (const Vec2d& place : yours) got.insert(got.end(), {place.x, place.y});
    for (const Vec2d& place : reference) expected.insert(expected.end(), {place.x, place.y});
    Finding finding = grading::same_numbers(got, expected, 1e-4, "the place of point", 2);
    if (finding.passed || finding.wrong.empty()) return finding;
    const std::size_t first = finding.wrong.front();
    finding.first = fmt::format("on the light's square: expected a point at {}, got {}",
                                text_of(reference[first]), text_of(yours[first]));
    return finding;
}

/// The grid's columns and rows, by its stored points.
struct Cells {
    int columns = 0, rows = 0;

    explicit Cells(const Sample& sample) {
        std::set<long> x, z;
        for (const Vec2d& place : stored_places(sample)) {
            x.insert(std::lround(place.x * 1e4));
            z.insert(std::lround(place.y * 1e4));
        }
        columns = static_cast<int>(x.size());
        rows = static_cast<int>(z.size());
    }
    [[nodiscard]] int count() const { return columns * rows; }
    /// In units of cells.
    [[nodiscard]] Vec2d scaled(const Vec2d& place) const {
        return (place + 0.5) * Vec2d(columns, rows);
    }
    /// Of a place on the light.
    [[nodiscard]] int of(const Vec2d& place) const {
        const Vec2d cell =
            glm::clamp(glm::floor(scaled(place)), Vec2d(0), Vec2d(columns - 1, rows - 1));
        return static_cast<int>(cell.y) * columns + static_cast<int>(cell.x);
    }
};

Finding off_the_light(const std::vector<Vec2d>& places) {
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (max_norm(Vec3d(places[i], 0)) <= 0.5 + 1e-9) continue;
        return failure("points lie off the light", fmt::format("point {} is at {}; the square ends "
                                                               "at ±0.5",
                                                               i, text_of(places[i])));
    }
    return {};
}

/// The mean share of the 4 × 4 blocks of a unit square that places should fall into evenly: each
/// block's count against its deviation, one chance in a million for all of them.
Finding evenly_spread(const std::vector<Vec2d>& places) {
    constexpr int side = 4;
    constexpr double most_deviations = 5.6;  // Šidák: 16 blocks
    std::vector<double> count(side * side, 0);
    for (const Vec2d& place : places) {
        const Vec2d block = glm::clamp(glm::floor(place * double(side)), 0.0, side - 1.0);
        count[static_cast<std::size_t>(block.y * side + block.x)] += 1;
    }
    const double blocks = side * side, mean = static_cast<double>(places.size()) / blocks;
    const double deviation = std::sqrt(mean * (1 - 1 / blocks));
    Finding finding;
    for (std::uint32_t i = 0; i < count.size(); ++i) {
        const double off = (count[i] - mean) / deviation;
        if (std::abs(off) <= most_deviations) continue;
        if (finding.wrong.empty()) {
            finding.first = fmt::format("block ({}, {}) of 4 × 4 expected {:.0f}, got {:.0f}",
                                        i % side, i / side, mean, count[i]);
        }
        finding.wrong.push_back(i);
        finding.signature.push_back(2 * i + (off < 0 ? 1 : 0));
    }
    finding.passed = finding.wrong.empty();
    return finding;
}

/// Places of many keys; `of_cell`: within their cells.
std::vector<Vec2d> many_places(const Steps& steps, const Sample& sample, Pattern pattern, int keys,
                               bool of_cell) {
    const Cells cells(sample);
    std::vector<Vec2d> all;
    for (int key = 0; key < keys; ++key) {
        for (const Vec2d& place :
             places(points(steps, sample, pattern, 1000 + key), sample.area())) {
            all.push_back(of_cell ? glm::fract(cells.scaled(place)) : place + 0.5);
        }
    }
    return all;
}

/// Where chance alone would fail once in a million, four times as many are asked.
Finding at_random(const Steps& steps, const Sample& sample, Pattern pattern, bool of_cell,
                  std::string what) {
    Finding finding = evenly_spread(many_places(steps, sample, pattern, keys_tried, of_cell));
    if (finding.passed) return finding;
    finding = evenly_spread(many_places(steps, sample, pattern, 4 * keys_tried, of_cell));
    finding.what = std::move(what);
    return finding;
}

Finding one_in_each_cell(const Steps& steps, const Sample& sample) {
    const Cells cells(sample);
    for (std::uint64_t key = 0; key < 16; ++key) {
        const auto yours = places(points(steps, sample, Pattern::jittered, key), sample.area());
        if (Finding off = off_the_light(yours); !off.passed) return off;
        std::vector<std::uint32_t> count(static_cast<std::size_t>(cells.count()), 0);
        for (const Vec2d& place : yours) ++count[static_cast<std::size_t>(cells.of(place))];
        Finding finding;
        for (std::uint32_t i = 0; i < count.size(); ++i) {
            if (count[i] == 1) continue;
            const auto columns = static_cast<std::uint32_t>(cells.columns);
            if (finding.wrong.empty()) {
                finding.first = fmt::format("cell ({}, {}) expected 1 point, got {}", i % columns,
                                            i / columns, count[i]);
            }
            finding.wrong.push_back(i);
        }
        finding.passed = finding.wrong.empty();
        finding.what = fmt::format("jittered: {} of {} × {} cells have not exactly one point",
                                   finding.wrong.size(), cells.columns, cells.rows);
        if (!finding.passed) return finding;
    }
    return {};
}

/// Anywhere in its cell, and each point by a number of its own.
Finding jittered_at_random(const Steps& steps, const Sample& sample) {
    const Cells cells(sample);
    Finding spread = at_random(steps, sample, Pattern::jittered, true,
                               "jittered: points do not fall evenly into their cells");
    if (!spread.passed) return spread;
    std::vector<Vec2d> within;
    for (const Vec2d& place : places(points(steps, sample, Pattern::jittered, 3), sample.area())) {
        within.push_back(glm::fract(cells.scaled(place)));
    }
    for (std::size_t i = 1; i < within.size(); ++i) {
        if (max_norm(Vec3d(within[i] - within[0], 0)) > 1e-6) continue;
        return failure(
            "jittered: points lie at the same place in their cells",
            fmt::format("points 0 and {}, both at {} of their cells", i, text_of(within[i])));
    }
    return {};
}

Finding anywhere(const Steps& steps, const Sample& sample) {
    const Cells cells(sample);
    int all_in_own = 0;
    for (int key = 0; key < keys_tried; ++key) {
        const auto yours =
            places(points(steps, sample, Pattern::random, 1000 + key), sample.area());
        if (Finding off = off_the_light(yours); !off.passed) return off;
        std::set<int> used;
        for (const Vec2d& place : yours) used.insert(cells.of(place));
        all_in_own += static_cast<int>(used.size()) == cells.count() ? 1 : 0;
    }
    if (all_in_own > keys_tried / 4) {
        return failure("random: there is one point in each cell, which is jittered",
                       fmt::format("so it was for {} of {} keys", all_in_own, keys_tried));
    }
    return at_random(steps, sample, Pattern::random, false,
                     "random: points do not fall evenly onto the light");
}

/// For any n: n points, and the light's power in all.
Finding all_of_the_power(const Steps& steps, const Sample& sample) {
    for (const Pattern pattern : {Pattern::regular, Pattern::jittered, Pattern::random}) {
        for (const int n : {sample.points(), 1, 36, 11}) {
            const auto yours = points(steps, sample, n, pattern, 5);
            if (yours.size() != static_cast<std::size_t>(n)) {
                return failure("there are not n points",
                               fmt::format("expected {}, got {}", n, yours.size()));
            }
            for (const LightPoint& each : yours) {
                if (std::abs(each.share * float(n) - 1) <= 1e-5f) continue;
                return failure(
                    "each of n points has a share of 1/n",
                    fmt::format("n = {}: expected {:.5g}, got {:.5g}", n, 1.0 / n, each.share));
            }
        }
    }
    return {};
}

/// The lowest that lifted_off() leaves over, and the highest that nobody sees.
Finding above_its_face(const Steps& steps, const Sample& sample) {
    const RectLight& light = sample.area();
    const double size = max_norm(light.to_world.matrix);
    for (const Pattern pattern : {Pattern::regular, Pattern::jittered, Pattern::random}) {
        const auto yours = points(steps, sample, pattern, 7);
        const auto on_light = places(yours, light);
        for (std::size_t i = 0; i < yours.size(); ++i) {
            const Vec3d face = light.to_world.point({on_light[i].x, 0, on_light[i].y});
            const double height = glm::dot(yours[i].position - face, light.facing());
            const double least = 0x1p-46 * (max_norm(face) + size);
            if (height >= least && height <= 1e-6 * size) continue;
            const bool too_high = height > 1e-6 * size, behind = height < -least;
            return failure(too_high ? "points lie far off the light's visible face"
                           : behind ? "points lie behind the light's visible face"
                                    : "points lie in the light's visible face, which hides them",
                           fmt::format("point {} is {:.3g} above it", i, height));
        }
    }
    return {};
}

bool same(const std::vector<LightPoint>& some, const std::vector<LightPoint>& others) {
    return std::ranges::equal(some, others, [](const LightPoint& a, const LightPoint& b) {
        return a.position == b.position && a.share == b.share;
    });
}

Finding by_its_key(const Steps& steps, const Sample& sample) {
    for (const auto& [pattern, word] :
         {std::pair(Pattern::jittered, "jittered"), {Pattern::random, "random"}}) {
        const auto one = points(steps, sample, pattern, 1);
        points(steps, sample, pattern, 2);
        if (!same(one, points(steps, sample, pattern, 1))) {
            return failure(fmt::format("{}: one key has not the same points again", word));
        }
        if (same(one, points(steps, sample, pattern, 2))) {
            return failure(fmt::format("{}: every key has the same points", word));
        }
    }
    if (same(points(steps, sample, Pattern::regular, 1),
             points(steps, sample, Pattern::regular, 2))) {
        return {};
    }
    return failure("regular: the points depend on the key");
}

}  // namespace

grading::Task light_task(const Samples& samples) {
    return {"shadow_map.t7",
            "light_points: many lights for one with an area",
            {{"shadow_map.t7.regular_grid", 1, cases_of(samples, regular_grid)},
             {"shadow_map.t7.one_in_each_cell", 1, cases_of(samples, one_in_each_cell)},
             {"shadow_map.t7.jittered_at_random", 1, cases_of(samples, jittered_at_random)},
             {"shadow_map.t7.anywhere", 0.5, cases_of(samples, anywhere)},
             {"shadow_map.t7.all_of_the_power", 0.5, cases_of(samples, all_of_the_power)},
             {"shadow_map.t7.above_its_face", 0.5, cases_of(samples, above_its_face)},
             {"shadow_map.t7.by_its_key", 0.5, cases_of(samples, by_its_key)}}};
}

}  // namespace luch::homework::shadow_map
