// Task t3: what a light sees through a face.
#include "framework/accel/accelerator.h"
#include "framework/grading/gates.h"
#include "homework/shadow_map/check/same.h"
#include "homework/shadow_map/check/tests.h"

#include <fmt/format.h>

namespace luch::homework::shadow_map {
namespace {

using grading::Finding;

/// What was there before.
constexpr float untouched = -7;

struct Rendered {
    CubeMap map;
    Counts counts;
};

void put(const Image<float>& part, const Tile& tile, Image<float>& whole) {
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) whole(x, y) = part(x - tile.x0, y - tile.y0);
    }
}

Rendered rendered(const Steps& steps, const Scene& scene, const Vec3d& light, int n, int side) {
    const auto accelerator = build_accelerator(scene);
    Tracer tracer(*accelerator);
    Rendered result{{n, {}}, {}};
    for (int face = 0; face < faces_of_cube; ++face) {
        Face& whole = result.map.faces[static_cast<std::size_t>(face)];
        whole = whole_face(n, untouched);
        for (int y = 0; y < n; y += side) {
            for (int x = 0; x < n; x += side) {
                const Tile tile{x, y, std::min(x + side, n), std::min(y + side, n)};
                Image<float> part({tile.width(), tile.height()}, untouched);
                steps.render_face(light, face, n, tile, tracer, part.view());
                put(part, tile, whole.distance);
            }
        }
    }
    result.counts = tracer.counts();
    return result;
}

Rendered rendered(const Steps& steps, const Sample& sample) {
    return rendered(steps, *sample.scene, sample.light(), sample.map.n, sample.map.n);
}

Finding distances(const Steps& steps, const Sample& sample) {
    return same_distances(rendered(steps, sample).map, sample.map, sample);
}

Finding nothing_is_infinite(const Steps& steps, const Sample& sample) {
    return same_gaps(rendered(steps, sample).map, sample.map);
}

/// A part of a face has its own image: texel (x, y) lies at (x − x0, y − y0), and beyond it is
/// memory of somebody else. Held against its own map, so that other mistakes are not punished
/// once more.
Finding part_of_a_face(const Steps& steps, const Sample& sample) {
    const int n = sample.map.n;
    const auto accelerator = build_accelerator(*sample.scene);
    Tracer tracer(*accelerator);
    const CubeMap whole = rendered(steps, sample).map;
    const Tile tile{3, 5, n - 4, n - 6};
    std::vector<double> got, expected;
    for (int face = 0; face < faces_of_cube; ++face) {
        std::vector<float> memory(static_cast<std::size_t>(2 * n * n), untouched);
        const ImageView<float> part(memory.data(), {tile.width(), tile.height()});
        steps.render_face(sample.light(), face, n, tile, tracer, part);
        if (std::any_of(memory.begin() + static_cast<std::ptrdiff_t>(tile.area()), memory.end(),
                        [](float each) { return each != untouched; })) {
            return grading::failure(
                "something is written outside the image of the tile",
                "the image is as large as the tile: texel (x, y) lies at (x − tile.x0, y − "
                "tile.y0)");
        }
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) {
                expected.push_back(whole.at({face, x, y}));
                got.push_back(part(x - tile.x0, y - tile.y0));
            }
        }
    }
    Finding finding = grading::same_numbers(got, expected, 0, "the distance of texel");
    if (!finding.passed) {
        finding.what = "a tile of a face has not the distances that it has in the whole face";
    }
    return finding;
}

Finding one_ray_a_texel(const Steps& steps, const Sample& sample) {
    const auto expected = static_cast<std::uint64_t>(6 * sample.map.n * sample.map.n);
    const Counts counts = rendered(steps, sample).counts;
    if (counts.all_rays() != expected) {
        return grading::failure(
            "one ray a texel is enough",
            fmt::format("expected {} rays, got {}", expected, counts.all_rays()));
    }
    if (counts.of(RayKind::shadow) == expected) return {};
    return grading::failure("the rays are not counted as shadow rays",
                            fmt::format("expected {} of RayKind::shadow, got {}", expected,
                                        counts.of(RayKind::shadow)));
}

/// The whole scene, elsewhere and of another size.
Scene moved(const Scene& scene, double scale, const Vec3d& by) {
    Scene there = scene;
    const Transform to = Transform::scaling(Vec3d(scale)).then(Transform::translation(by));
    for (Node& node : there.nodes) {
        node.to_world = node.to_world.then(to);
        node.to_object = node.to_world.inverse();
    }
    return there;
}

/// Held against its own map here, so that other mistakes are not punished once more.
Finding same_map_there(const Steps& steps, const Sample& sample, double scale, const Vec3d& by) {
    const CubeMap here = rendered(steps, sample).map;
    CubeMap there = rendered(steps, moved(*sample.scene, scale, by), sample.light() * scale + by,
                             here.n, here.n)
                        .map;
    for (Face& face : there.faces) {
        for (float& distance : face.distance.pixels())
            distance = static_cast<float>(distance / scale);
    }
    return grading::first_failure_of({same_gaps(there, here), same_distances(there, here, sample)});
}

Finding far_from_the_origin(const Steps& steps, const Sample& sample) {
    return same_map_there(steps, sample, 1, {40'000, -300'000, 170'000});
}

Finding small_and_large(const Steps& steps, const Sample& sample) {
    return grading::first_failure_of({same_map_there(steps, sample, 0x1p-14, Vec3d(0)),
                                      same_map_there(steps, sample, 0x1p20, Vec3d(0))});
}

}  // namespace

grading::Task face_task(const Samples& samples) {
    return {"shadow_map.t3",
            "render_face: what the light sees",
            {{"shadow_map.t3.distances", 2, cases_of(samples, distances)},
             {"shadow_map.t3.nothing_is_infinite", 0.5, cases_of(samples, nothing_is_infinite)},
             {"shadow_map.t3.part_of_a_face", 1, cases_of(samples, part_of_a_face)},
             {"shadow_map.t3.one_ray_a_texel", 0.5, cases_of(samples, one_ray_a_texel)},
             {"shadow_map.t3.far_from_the_origin", 0.5, cases_of(samples, far_from_the_origin)},
             {"shadow_map.t3.small_and_large", 0.5, cases_of(samples, small_and_large)}}};
}

}  // namespace luch::homework::shadow_map
