#include "homework/vista/check/make_samples.h"

#include "framework/accel/accelerator.h"
#include "framework/math/rng.h"
#include "framework/scene/loader/loader.h"
#include "homework/vista/check/sight.h"
#include "homework/vista/check/store.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace luch::homework::vista {
namespace {

double in_float(double value) {
    return static_cast<float>(value);
}

/// As the file will hold them.
void round_to_float(std::vector<Tri>& triangles) {
    for (Tri& triangle : triangles) {
        for (auto& [p, w] : triangle.corners) {
            p = Vec3d(Vec3(p));
            w = in_float(w);
        }
    }
}

std::vector<Tri> shapes(const Sample& sample, const Steps& steps, int segments) {
    std::vector<Tri> all, some;
    for (NodeId node = 0; node < sample.scene->nodes.size(); ++node) {
        const Geometry& geometry = sample.scene->geometries[sample.scene->nodes[node].geometry];
        steps.tessellate(geometry, std::holds_alternative<Sphere>(geometry) ? segments : 0, some);
        to_view(*sample.scene, node, sample.screen(), some);
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

void make_triangles(Sample& sample, const Steps& steps) {
    Sight sight = sight_of(shapes(sample, steps, shape_segments), sample.screen());
    sample.shape_ids = std::move(sight.ids);
    sample.shape_depth = std::move(sight.depth);
    sample.around = shapes(sample, steps, input_segments);
    round_to_float(sample.around);
    steps.clip(sample.around, frustum_of(sample.screen()), sample.in_view);
    round_to_float(sample.in_view);
}

/// Sorts and finds out where everything went: by numbers in the place of nodes.
void make_order(Sample& sample, const Steps& steps) {
    std::vector<Tri> numbered = sample.in_view;
    for (std::size_t i = 0; i < numbered.size(); ++i) numbered[i].node = static_cast<NodeId>(i);
    steps.sort(numbered);
    sample.order.clear();
    for (const Tri& triangle : numbered) sample.order.push_back(triangle.node);
}

void make_pixels(Sample& sample, const Steps& steps) {
    sample.on_screen.assign(sample.order.size(), {});
    steps.project(sample.sorted(), sample.screen(), sample.on_screen);
    for (ScreenTri& triangle : sample.on_screen) {
        for (Vec2d& px : triangle.px) px = Vec2d(Vec2(px));
        for (double& inverse : triangle.inverse_depth) inverse = in_float(inverse);
    }
    const Size size = sample.screen().size();
    const Tile whole{0, 0, size.width, size.height};
    Image<float> unused(size);
    sample.painter_ids = sample.nearest_ids = Image<std::uint32_t>(size);
    sample.nearest_depth = Image<float>(size);
    steps.rasterise(sample.on_screen, whole, Hidden::painter, sample.painter_ids.view(),
                    unused.view());
    steps.rasterise(sample.on_screen, whole, Hidden::depth, sample.nearest_ids.view(),
                    sample.nearest_depth.view());
}

/// The nodes that the buffer names, and in every third square of 8 × 8 pixels another one.
Image<std::uint32_t> partly_wrong(const Sample& sample) {
    Image<std::uint32_t> named = sample.nearest_ids;
    const auto count = static_cast<std::uint32_t>(sample.scene->nodes.size());
    for (int y = 0; y < named.height(); ++y) {
        for (int x = 0; x < named.width(); ++x) {
            if ((x / 8 + y / 8) % 3 != 0 || named(x, y) == no_node) continue;
            named(x, y) = (named(x, y) + 1) % count;
        }
    }
    return named;
}

void make_hits(Sample& sample, const Steps& steps) {
    sample.named = partly_wrong(sample);
    const Size size = sample.named.size();
    const auto accelerator = build_accelerator(*sample.scene);
    Tracer tracer(*accelerator);
    Image<Hit> hits(size);
    Image<std::uint8_t> fell_back(size);
    steps.look_up(sample.screen(), {0, 0, size.width, size.height}, sample.named.view(), tracer,
                  hits.view(), fell_back.view());
    sample.hit_nodes = sample.fell_back = Image<std::uint32_t>(size);
    for (std::size_t i = 0; i < size.area(); ++i) {
        sample.hit_nodes.pixels()[i] = hits.pixels()[i].node;
        sample.fell_back.pixels()[i] = fell_back.pixels()[i];
    }
}

class SceneMaker {
 public:
    explicit SceneMaker(Key key) : key_(key) {}

    Scene scene() {
        Scene made;
        made.settings.frame = {96, 72};
        made.camera.position = {between(-1, 1), between(0.5, 2.5), -7};
        made.camera.yaw_deg = between(-12, 12);
        made.camera.pitch_deg = between(-15, 0);
        made.camera.roll_deg = between(-10, 10);
        made.materials.emplace_back();
        add(made, Plane{.y = -1 - between(0, 0.4)}, {});
        for (int i = 0; i < 8; ++i) {
            const double size = between(0.6, 1.5);
            const Vec3d place{between(-5, 5), between(-0.5, 3), between(-3, 4)};
            const Transform turned =
                Transform::scaling({between(0.7, 1.4), between(0.7, 1.4), between(0.7, 1.4)})
                    .then(Transform::rotation(between(0, 3), between(0, 3), between(0, 3)))
                    .then(Transform::translation(place));
            if (i % 2 == 0) {
                add(made, Sphere{.radius = size}, turned);
            } else {
                add(made, Cube{.side = 2 * size}, turned);
            }
        }
        return made;
    }

 private:
    double between(double least, double most) {
        return least + (most - least) * key_.uniform(drawn_++);
    }
    static void add(Scene& made, Geometry geometry, const Transform& to_world) {
        made.geometries.push_back(std::move(geometry));
        add_node(made, "", static_cast<GeometryId>(made.geometries.size() - 1), 0, to_world);
    }

    Key key_;
    std::uint64_t drawn_ = 0;
};

}  // namespace

Sample sample_of(std::string name, std::shared_ptr<const Scene> scene, const Steps& steps) {
    Sample sample;
    sample.name = std::move(name);
    sample.scene = std::move(scene);
    make_triangles(sample, steps);
    make_order(sample, steps);
    make_pixels(sample, steps);
    make_hits(sample, steps);
    return sample;
}

LodSample lod_sample(const Steps& steps) {
    LodSample sample;
    for (float radius = 0.01f; radius < 20'000; radius *= 1.37f) sample.radii.push_back(radius);
    sample.radii.push_back(std::numeric_limits<float>::infinity());
    for (const float radius : sample.radii) {
        sample.segments.push_back(steps.lod(Sphere{}, radius));
    }
    return sample;
}

std::vector<Sample> samples_from_seed(std::uint64_t seed, const Steps& steps) {
    std::vector<Sample> samples;
    for (std::uint64_t i = 0; i < 3; ++i) {
        auto scene = std::make_shared<Scene>(SceneMaker(Key(seed).branch(i)).scene());
        samples.push_back(sample_of(fmt::format("seed {}.{}", seed, i), std::move(scene), steps));
    }
    return samples;
}

int regenerate(const std::filesystem::path& root, const Steps& steps,
               const grading::Regeneration& regeneration) {
    const std::filesystem::path folder = root / "homework/vista";
    int changed = 0;
    for (const grading::StoredPlane& plane : planes_of(lod_sample(steps))) {
        changed += grading::regenerate_plane(folder / "reference", plane, {}, regeneration);
    }
    for (const char* name : {"balls", "boxes", "gems", "inside"}) {
        const auto file = folder / "scenes" / (std::string(name) + ".scene");
        auto scene = std::make_shared<const Scene>(load_scene(file).scene);
        const Sample sample = sample_of(name, std::move(scene), steps);
        for (const grading::StoredPlane& plane : planes_of(sample)) {
            changed += grading::regenerate_plane(folder / "reference" / name, plane,
                                                 sample.screen().size(), regeneration);
        }
    }
    return changed;
}

}  // namespace luch::homework::vista
