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

Rendered rendered(const Steps& steps, const Scene& scene, const Vec3d& light, int n, int side) {
    const auto accelerator = build_accelerator(scene);
    Tracer tracer(*accelerator);
    Rendered result{{n, {}}, {}};
    for (int face = 0; face < faces_of_cube; ++face) {
        Image<float>& image = result.map.faces[static_cast<std::size_t>(face)];
        image = Image<float>({n, n}, untouched);
        for (int y = 0; y < n; y += side) {
            for (int x = 0; x < n; x += side) {
                const Tile tile{x, y, std::min(x + side, n), std::min(y + side, n)};
                steps.render_face(light, face, tile, tracer, image.view());
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

/// One tile leaves the others alone, and all together make what one large tile makes.
Finding tile_by_tile(const Steps& steps, const Sample& sample) {
    const int n = sample.map.n;
    const auto accelerator = build_accelerator(*sample.scene);
    Tracer tracer(*accelerator);
    const Tile middle{3, 5, n - 4, n - 6};
    for (int face = 0; face < faces_of_cube; ++face) {
        Image<float> image({n, n}, untouched);
        steps.render_face(sample.light(), face, middle, tracer, image.view());
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                const bool inside =
                    x >= middle.x0 && x < middle.x1 && y >= middle.y0 && y < middle.y1;
                if ((image(x, y) != untouched) == inside) continue;
                return grading::failure(
                    "not exactly the texels of the tile are written",
                    fmt::format("face {}, texel ({},{}) {}", face, x, y,
                                inside ? "is not" : "was written outside the tile"));
            }
        }
    }
    const CubeMap whole = rendered(steps, sample).map;
    const CubeMap tiles = rendered(steps, *sample.scene, sample.light(), n, 7).map;
    if (whole.faces == tiles.faces) return {};
    return grading::failure("tiles of 7 × 7 texels make another map than one large tile");
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
    for (Image<float>& face : there.faces) {
        for (float& distance : face.pixels()) distance = static_cast<float>(distance / scale);
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
             {"shadow_map.t3.tile_by_tile", 1, cases_of(samples, tile_by_tile)},
             {"shadow_map.t3.one_ray_a_texel", 0.5, cases_of(samples, one_ray_a_texel)},
             {"shadow_map.t3.far_from_the_origin", 0.5, cases_of(samples, far_from_the_origin)},
             {"shadow_map.t3.small_and_large", 0.5, cases_of(samples, small_and_large)}}};
}

}  // namespace luch::homework::shadow_map
