#include "homework/layered/check/make_samples.h"

#include "framework/baseline/classic.h"
#include "framework/math/rng.h"
#include "framework/scene/loader/loader.h"
#include "homework/layered/check/store.h"

#include <fmt/format.h>

#include <limits>

namespace luch::homework::layered {
namespace {

/// Rounded so that a file takes little room.
float rounded(float value) {
    return std::round(value * 64) / 64;
}

/// What a pinhole sees: depths, and colours that take little room in a file.
Image<Rgb> look(Sample& sample) {
    const Scene& scene = *sample.scene;
    Shot shot = shot_of(scene);
    shot.camera.depth_of_field = false;
    shot.spp = 1;
    const Screen screen(shot.camera, shot.size);
    const auto accelerator = build_accelerator(scene);
    Tracer tracer(*accelerator);
    Image<Rgb> colour(shot.size);
    trace_tile(scene, shot, colour.view().tile(), Needs(), tracer, colour.view());
    sample.depth = Image<float>(shot.size, std::numeric_limits<float>::infinity());
    for (int y = 0; y < shot.size.height; ++y) {
        for (int x = 0; x < shot.size.width; ++x) {
            const Ray ray = screen.ray(x + 0.5, y + 0.5);
            const Hit hit = tracer.closest(RayKind::primary, ray);
            if (!hit) continue;
            sample.depth(x, y) =
                static_cast<float>(hit.t * glm::dot(ray.direction, screen.forward()));
        }
    }
    return colour;
}

/// Coverage of a pixel that is there: some are half covered.
float coverage(int x, int y) {
    return (x + 2 * y) % 5 == 0 ? 0.5f : 1.0f;
}

/// One half of the scene by depth, premultiplied.
Image<Rgba> layer(const Sample& sample, const Image<Rgb>& colour, bool near, float cut) {
    Image<Rgba> image(colour.size(), Rgba(0));
    for (int y = 0; y < colour.height(); ++y) {
        for (int x = 0; x < colour.width(); ++x) {
            if ((sample.depth(x, y) < cut) != near) continue;
            const float a = near ? coverage(x, y) : 1;
            const Rgb& c = colour(x, y);
            image(x, y) = Rgba(a * Rgb(rounded(c.r), rounded(c.g), rounded(c.b)), a);
        }
    }
    return image;
}

void blur(Sample& sample, const Steps& steps) {
    const Size size = sample.depth.size();
    const Tile whole = sample.depth.view().tile();
    sample.along_x = sample.along_y = sample.spread = Image<Rgba>(size);
    steps.gaussian(sample.near.view(), gaussian_sigma, Axis::x, whole, sample.along_x.view());
    steps.gaussian(sample.near.view(), gaussian_sigma, Axis::y, whole, sample.along_y.view());
    steps.disc(sample.near.view(), sample.coc.view(), whole, sample.spread.view());
    sample.composed = sample.far;
    steps.over(sample.spread.view(), whole, sample.composed.view());
}

class SceneMaker {
 public:
    explicit SceneMaker(Key key) : key_(key) {}

    Scene scene() {
        Scene made;
        made.settings.frame = {40, 30};
        made.settings.background = {0.1f, 0.2f, 0.3f};
        made.camera.position = {between(-1, 1), between(0.5, 2), 0};
        made.camera.yaw_deg = between(-8, 8);
        made.camera.depth_of_field = true;
        made.camera.focal_distance = between(5, 8);
        made.camera.f_number = between(7, 10);
        made.lights.emplace_back(PointLight{.position = {-4, 8, 0}, .power = 80});
        add(made, Plane{.y = -1}, {0, 0, 0});
        for (int i = 0; i < 7; ++i) {
            const double z = 2.5 + 1.6 * i;
            const Vec3d place{between(-0.45, 0.45) * z, between(-0.5, 1), z};
            const double size = between(0.3, 0.5) * std::sqrt(z);
            if (i % 2 == 0) {
                add(made, Sphere{.radius = size}, place);
            } else {
                add(made, Cube{.side = 1.6 * size}, place);
            }
        }
        return made;
    }

 private:
    double between(double least, double most) {
        return least + (most - least) * key_.uniform(drawn_++);
    }
    void add(Scene& made, Geometry geometry, const Vec3d& at) {
        made.geometries.push_back(std::move(geometry));
        made.materials.emplace_back(
            Lambert{.color = Rgb(between(0.1, 0.9), between(0.1, 0.9), between(0.1, 0.9))});
        add_node(made, "", static_cast<GeometryId>(made.geometries.size() - 1),
                 static_cast<MaterialId>(made.materials.size() - 1), Transform::translation(at));
    }

    Key key_;
    std::uint64_t drawn_ = 0;
};

}  // namespace

Sample sample_of(std::string name, std::shared_ptr<const Scene> scene, const Steps& steps) {
    Sample sample;
    sample.name = std::move(name);
    sample.scene = std::move(scene);
    const Image<Rgb> colour = look(sample);
    sample.cuts.resize(cut_layers - 1);
    steps.cut(sample.depth.pixels(), cut_layers, sample.cuts);
    sample.coc = Image<float>(sample.depth.size());
    steps.coc(sample.depth.view(), sample.lens(), sample.depth.view().tile(), sample.coc.view());
    const float middle = sample.cuts[cut_layers / 2];
    sample.near = layer(sample, colour, true, middle);
    sample.far = layer(sample, colour, false, middle);
    blur(sample, steps);
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
    const std::filesystem::path folder = root / "homework/layered";
    int changed = 0;
    for (const std::string& name : sample_names()) {
        auto scene =
            std::make_shared<const Scene>(load_scene(folder / "scenes" / (name + ".scene")).scene);
        const Sample sample = sample_of(name, std::move(scene), steps);
        for (const grading::StoredPlane& plane : planes_of(sample)) {
            changed += grading::regenerate_plane(folder / "reference" / name, plane,
                                                 sample.depth.size(), regeneration);
        }
    }
    return changed;
}

}  // namespace luch::homework::layered
