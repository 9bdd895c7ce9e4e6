// Tasks t6 and t7: from triangles on the screen to ids, and from ids to hits.
#include "framework/accel/accelerator.h"
#include "framework/grading/gates.h"
#include "homework/vista/check/tests.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace luch::homework::vista {
namespace {

using grading::failure;
using grading::Finding;

struct Painted {
    Image<std::uint32_t> ids;
    Image<float> depth;
    explicit Painted(Size size) : ids(size, 12345), depth(size, -1) {}
};

Painted painted(const Steps& steps, std::span<const ScreenTri> triangles, Size size, Hidden hidden,
                Size tile) {
    Painted result(size);
    for (int y = 0; y < size.height; y += tile.height) {
        for (int x = 0; x < size.width; x += tile.width) {
            steps.rasterise(triangles,
                            {x, y, std::min(x + tile.width, size.width),
                             std::min(y + tile.height, size.height)},
                            hidden, result.ids.view(), result.depth.view());
        }
    }
    return result;
}

Painted painted(const Steps& steps, const Sample& sample, Hidden hidden) {
    const Size size = sample.screen().size();
    return painted(steps, sample.on_screen, size, hidden, size);
}

Finding nearest_is_seen(const Steps& steps, const Sample& sample) {
    const Painted yours = painted(steps, sample, Hidden::depth);
    return grading::same_ids(yours.ids.view(), sample.nearest_ids.view());
}

Finding depths(const Steps& steps, const Sample& sample) {
    const Painted yours = painted(steps, sample, Hidden::depth);
    return grading::same_depths(yours.depth.view(), sample.nearest_depth.view(), yours.ids.view(),
                                sample.nearest_ids.view());
}

/// A painter does not ask for depths: with the near made far it is still the last that is seen.
Finding painted_over(const Steps& steps, const Sample& sample) {
    const Size size = sample.screen().size();
    std::vector<ScreenTri> turned = sample.on_screen;
    double most = 0;
    for (const ScreenTri& triangle : turned) {
        for (const double inverse : triangle.inverse_depth) most = std::max(most, inverse);
    }
    for (ScreenTri& triangle : turned) {
        for (double& inverse : triangle.inverse_depth) inverse = 2 * most - inverse;
    }
    const Painted yours = painted(steps, sample, Hidden::painter);
    const Painted other = painted(steps, turned, size, Hidden::painter, size);
    return grading::first_failure_of(
        {grading::same_ids(yours.ids.view(), sample.painter_ids.view()),
         grading::same_ids(other.ids.view(), sample.painter_ids.view(),
                           "id, depths turned round,")});
}

/// One tile leaves the others alone, and all together make the picture that one large tile makes.
Finding tile_by_tile(const Steps& steps, const Sample& sample) {
    const Size size = sample.screen().size();
    const Tile middle{32, 24, 48, 36};
    Painted one(size);
    steps.rasterise(sample.on_screen, middle, Hidden::depth, one.ids.view(), one.depth.view());
    Image<std::uint32_t> touched(size, 0), expected(size, 0);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            touched(x, y) = one.ids(x, y) != 12345 || one.depth(x, y) != -1;
            expected(x, y) = x >= middle.x0 && x < middle.x1 && y >= middle.y0 && y < middle.y1;
        }
    }
    if (touched != expected) {
        Finding finding = grading::same_ids(touched.view(), expected.view());
        finding.passed = false;
        finding.what = "not exactly the pixels of the tile are written (1: written)";
        return finding;
    }
    const Painted whole = painted(steps, sample, Hidden::depth);
    const Painted tiles = painted(steps, sample.on_screen, size, Hidden::depth, {16, 12});
    if (whole.ids == tiles.ids && whole.depth == tiles.depth) return {};
    Finding finding = grading::same_ids(tiles.ids.view(), whole.ids.view());
    finding.passed = false;
    finding.what = "tiles of 16 × 12 pixels make another picture than one large tile";
    return finding;
}

/// Left and right change places in the picture when they do in the triangles.
Finding mirrored(const Steps& steps, const Sample& sample) {
    const Size size = sample.screen().size();
    std::vector<ScreenTri> triangles = sample.on_screen;
    for (ScreenTri& triangle : triangles) {
        for (Vec2d& px : triangle.px) px.x = size.width - px.x;
    }
    const Painted there = painted(steps, triangles, size, Hidden::depth, size);
    Image<std::uint32_t> back(size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) back(x, y) = there.ids(size.width - 1 - x, y);
    }
    return grading::same_ids(back.view(), sample.nearest_ids.view());
}

/// Triangles around a point, their outer corners on a polygon; all corners are pixels' centres.
std::vector<ScreenTri> around(const Vec2d& middle, const std::vector<Vec2d>& ring, bool turned) {
    std::vector<ScreenTri> triangles;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        Vec2d a = middle + ring[i], b = middle + ring[(i + 1) % ring.size()];
        if (turned && i % 2 == 0) std::swap(a, b);
        triangles.push_back({{middle, a, b}, {0.25, 0.25, 0.25}, static_cast<NodeId>(i)});
    }
    return triangles;
}

/// A centre on an edge, or on a corner, belongs to one of the triangles that meet there.
Finding each_pixel_once(const Steps& steps, const std::vector<Vec2d>& ring, bool turned) {
    const Size size{40, 30};
    Image<std::uint32_t> count(size, 0), once(size, 0);
    const Vec2d middle{20.5, 15.5};
    for (const ScreenTri& triangle : around(middle, ring, turned)) {
        const Painted one = painted(steps, {&triangle, 1}, size, Hidden::painter, size);
        for (std::size_t i = 0; i < size.area(); ++i) {
            count.pixels()[i] += one.ids.pixels()[i] == triangle.node ? 1 : 0;
        }
    }
    // Nearer than this, all is inside the ring.
    double inner = size.width;
    for (const Vec2d& corner : ring) inner = std::min(inner, glm::length(corner));
    inner *= 0.6;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const bool inside = glm::length(Vec2d(x + 0.5, y + 0.5) - middle) < inner;
            once(x, y) = inside ? 1 : count(x, y);
        }
    }
    if (count == once) return {};
    Finding finding = grading::same_ids(count.view(), once.view());
    finding.passed = false;
    finding.what =
        fmt::format("{} pixels on common edges are not painted exactly once", finding.wrong.size());
    return finding;
}

grading::Case once_case(const char* name, std::vector<Vec2d> ring, bool turned) {
    return {name, "",
            [=](const std::any& steps) { return each_pixel_once(steps_in(steps), ring, turned); }};
}

struct LookedUp {
    Image<std::uint32_t> nodes, fell_back;
    Image<float> t;
    Counts counts;
};

LookedUp looked_up(const Steps& steps, const Sample& sample, const Image<std::uint32_t>& named) {
    const auto accelerator = build_accelerator(*sample.scene);
    Tracer tracer(*accelerator);
    const Size size = named.size();
    Image<Hit> hits(size);
    Image<std::uint8_t> fell_back(size, 9);
    for (const Tile tile : {Tile{0, 0, size.width, 40}, Tile{0, 40, size.width, size.height}}) {
        steps.look_up(sample.screen(), tile, named.view(), tracer, hits.view(), fell_back.view());
    }
    LookedUp result{Image<std::uint32_t>(size), Image<std::uint32_t>(size), Image<float>(size),
                    tracer.counts()};
    for (std::size_t i = 0; i < size.area(); ++i) {
        const Hit& hit = hits.pixels()[i];
        result.nodes.pixels()[i] = hit.node;
        result.fell_back.pixels()[i] = fell_back.pixels()[i];
        result.t.pixels()[i] =
            hit ? static_cast<float>(hit.t) : std::numeric_limits<float>::infinity();
    }
    return result;
}

/// Of the hits of every pixel's ray with one node.
Image<float> distances(const Sample& sample, const Image<std::uint32_t>& nodes) {
    const auto accelerator = build_accelerator(*sample.scene);
    Tracer tracer(*accelerator);
    const Screen screen = sample.screen();
    Image<float> t(nodes.size(), std::numeric_limits<float>::infinity());
    for (int y = 0; y < t.height(); ++y) {
        for (int x = 0; x < t.width(); ++x) {
            const Ray ray = screen.ray(x + 0.5, y + 0.5);
            Hit hit;
            tracer.test({&nodes(x, y), 1}, {&ray, 1}, {&hit, 1});
            if (hit) t(x, y) = static_cast<float>(hit.t);
        }
    }
    return t;
}

Finding the_named_is_hit(const Steps& steps, const Sample& sample) {
    const LookedUp yours = looked_up(steps, sample, sample.named);
    const Image<float> t = distances(sample, sample.hit_nodes);
    return grading::first_failure_of(
        {grading::same_ids(yours.nodes.view(), sample.hit_nodes.view(), "node"),
         grading::same_depths(yours.t.view(), t.view(), yours.nodes.view(),
                              sample.hit_nodes.view())});
}

Finding marks_its_fallbacks(const Steps& steps, const Sample& sample) {
    const LookedUp yours = looked_up(steps, sample, sample.named);
    return grading::same_ids(yours.fell_back.view(), sample.fell_back.view(), "fell_back");
}

/// Speed, counted: one object test for each pixel with a node, one ray for each fallback.
Finding no_ray_too_many(const Steps& steps, const Sample& sample) {
    const LookedUp yours = looked_up(steps, sample, sample.named);
    const auto count = [](const Image<std::uint32_t>& image, auto&& counted) {
        return static_cast<double>(
            std::count_if(image.pixels().begin(), image.pixels().end(), counted));
    };
    const double tests = count(sample.named, [](std::uint32_t id) { return id != no_node; });
    const double rays = count(sample.fell_back, [](std::uint32_t fell) { return fell == 1; });
    const auto complain = [](const char* what, double most, std::uint64_t got) {
        return failure(fmt::format("too many {}", what),
                       fmt::format("expected at most {:g}, got {}", most, got));
    };
    constexpr double spare = 1.01;
    if (static_cast<double>(yours.counts.object_tests) > spare * tests) {
        return complain("object tests", tests, yours.counts.object_tests);
    }
    if (static_cast<double>(yours.counts.all_rays()) > spare * rays + 3) {
        return complain("rays", rays, yours.counts.all_rays());
    }
    return {};
}

/// Vista = full trace: with the right ids in the buffer, the hits are those of tracing every ray.
Finding same_as_tracing(const Steps& steps, const Sample& sample) {
    const Screen screen = sample.screen();
    Image<std::uint32_t> named(screen.size());
    Image<float> t(screen.size(), std::numeric_limits<float>::infinity());
    for (int y = 0; y < named.height(); ++y) {
        for (int x = 0; x < named.width(); ++x) {
            const Hit hit = closest_brute(*sample.scene, screen.ray(x + 0.5, y + 0.5));
            named(x, y) = hit.node;
            if (hit) t(x, y) = static_cast<float>(hit.t);
        }
    }
    const LookedUp yours = looked_up(steps, sample, named);
    return grading::first_failure_of(
        {grading::same_ids(yours.nodes.view(), named.view(), "node"),
         grading::same_depths(yours.t.view(), t.view(), yours.nodes.view(), named.view())});
}

/// The scene and the camera, moved by the same way.
Sample moved(const Sample& sample, const Vec3d& by) {
    Scene scene = *sample.scene;
    scene.camera.position += by;
    for (Node& node : scene.nodes) {
        node.to_world.offset += by;
        node.to_object = node.to_world.inverse();
    }
    Sample there = sample;
    there.scene = std::make_shared<const Scene>(std::move(scene));
    return there;
}

/// Where all of it stands in the world is not to be seen. Held against its own picture, so that
/// other mistakes are not punished once more.
Finding moved_with_the_camera(const Steps& steps, const Sample& sample) {
    const LookedUp here = looked_up(steps, sample, sample.named);
    const LookedUp there = looked_up(steps, moved(sample, {40, -24, 56}), sample.named);
    if (here.nodes == Image<std::uint32_t>(here.nodes.size(), no_node)) {
        return failure("no pixel has a hit");
    }
    return grading::first_failure_of(
        {grading::same_ids(there.nodes.view(), here.nodes.view(), "node, moved,"),
         grading::same_ids(there.fell_back.view(), here.fell_back.view(), "fell_back, moved,")});
}

}  // namespace

grading::Task rasterise_task(const Samples& samples) {
    const std::vector<Vec2d> square{{-10, -10}, {10, -10}, {10, 10}, {-10, 10}};
    const std::vector<Vec2d> star{{-12, 0}, {-6, -9}, {6, -9}, {12, 0}, {6, 9}, {-6, 9}};
    return {"vista.t6",
            "rasterise: row by row",
            {{"vista.t6.nearest_is_seen", 1.5, cases_of(samples, nearest_is_seen)},
             {"vista.t6.depths", 1, cases_of(samples, depths)},
             {"vista.t6.painted_over", 1, cases_of(samples, painted_over)},
             {"vista.t6.tile_by_tile", 1, cases_of(samples, tile_by_tile)},
             {"vista.t6.mirrored", 0.5, cases_of(samples, mirrored)},
             {"vista.t6.each_pixel_once",
              1,
              {once_case("square", square, false), once_case("turned square", square, true),
               once_case("star", star, false), once_case("turned star", star, true)}}}};
}

grading::Task look_up_task(const Samples& samples) {
    return {"vista.t7",
            "look_up: one object a pixel",
            {{"vista.t7.the_named_is_hit", 2, cases_of(samples, the_named_is_hit)},
             {"vista.t7.marks_its_fallbacks", 1, cases_of(samples, marks_its_fallbacks)},
             {"vista.t7.no_ray_too_many", 1, cases_of(samples, no_ray_too_many)},
             {"vista.t7.same_as_tracing", 0.5, cases_of(samples, same_as_tracing)},
             {"vista.t7.moved_with_the_camera", 0.5, cases_of(samples, moved_with_the_camera)}}};
}

}  // namespace luch::homework::vista
