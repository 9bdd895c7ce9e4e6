#include "homework/ssao/check/make_samples.h"

#include "framework/accel/accelerator.h"
#include "framework/scene/loader/loader.h"
#include "framework/trace/tracer.h"
#include "homework/ssao/check/store.h"

#include <fmt/format.h>

#include <cmath>

namespace luch::homework::ssao {
namespace {

/// What the pixels' centres see.
Image<float> depths_of(const Scene& scene) {
    const Size size = scene.settings.frame;
    const Screen screen(scene.camera, size);
    const auto accelerator = build_accelerator(scene);
    Tracer tracer(*accelerator);
    Image<float> depth(size, std::numeric_limits<float>::infinity());
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const Ray ray = screen.ray(x + 0.5, y + 0.5);
            const Hit hit = tracer.closest(RayKind::primary, ray);
            if (!hit) continue;
            depth(x, y) = static_cast<float>(hit.t * glm::dot(ray.direction, screen.forward()));
        }
    }
    return depth;
}

/// Rounded so that a file takes little room.
float rounded(float value) {
    return std::round(value * 64) / 64;
}

void occlude(Sample& sample, const Steps& steps) {
    const Size size = sample.depth.size();
    const Tile whole = sample.depth.view().tile();
    sample.mean = sample.variance = sample.raw = Image<float>(size);
    Image<float> some(size);
    std::vector<double> sum(size.area()), squares(size.area());
    for (int i = 0; i < turns_taken; ++i) {
        steps.occlusion(sample.seen(), sample.screen(), sample.kernel, {.radius = Sample::radius},
                        Key(77).branch(static_cast<std::uint64_t>(i)), whole, some.view());
        for (std::size_t k = 0; k < sum.size(); ++k) {
            sum[k] += some.pixels()[k];
            squares[k] += double(some.pixels()[k]) * some.pixels()[k];
        }
    }
    for (std::size_t k = 0; k < sum.size(); ++k) {
        const double mean = sum[k] / turns_taken;
        sample.mean.pixels()[k] = static_cast<float>(mean);
        sample.variance.pixels()[k] =
            static_cast<float>(std::max(0.0, squares[k] / turns_taken - mean * mean));
        sample.raw.pixels()[k] = rounded(some.pixels()[k]);
    }
}

void smooth(Sample& sample, const Steps& steps) {
    const Size size = sample.depth.size();
    const Tile whole = sample.depth.view().tile();
    sample.along_x = sample.along_y = sample.upsampled = Image<float>(size);
    const Blur blur{.tolerance = Sample::tolerance};
    steps.blur(sample.raw.view(), sample.seen(), blur, Axis::x, whole, sample.along_x.view());
    steps.blur(sample.raw.view(), sample.seen(), blur, Axis::y, whole, sample.along_y.view());
    const Image<float> coarse = halved(sample.raw);
    const Image<Vec3> position = halved(sample.position), normal = halved(sample.normal);
    steps.upsample(coarse.view(), {position.view(), normal.view()}, sample.seen(),
                   Sample::tolerance, whole, sample.upsampled.view());
    Image<float> visibility = sample.raw;
    for (float& share : visibility.pixels()) share = 1 - share;
    sample.light = Image<Rgb>(size);
    steps.apply(visibility.view(), sample.ambient(), whole, sample.light.view());
}

class SceneMaker {
 public:
    explicit SceneMaker(Key key) : key_(key) {}

    Scene scene() {
        Scene made;
        made.settings.frame = {40, 30};
        made.settings.ambient_light = Rgb(between(0.3, 1), between(0.3, 1), between(0.3, 1));
        made.camera.position = {between(-1, 1), between(1.5, 2.5), between(-6, -5)};
        made.camera.yaw_deg = between(-10, 10);
        made.camera.pitch_deg = between(-20, -10);
        made.camera.fov_deg = between(55, 70);
        add(made, Plane{.limit = 14}, {0, 0, 0});
        // A wall that ends within the frame.
        add(made, Cube{.side = 6}, {between(2, 3), 3, between(4.5, 5.5)});
        for (int i = 0; i < 5; ++i) {
            const Vec3d place{between(-2.2, 1.8), 0, between(-1.5, 1.5)};
            const double size = between(0.4, 0.8);
            if (i % 2 == 0) {
                add(made, Sphere{.radius = size}, place + Vec3d(0, 0.9 * size, 0));
            } else {
                add(made, Cube{.side = 1.6 * size}, place + Vec3d(0, 0.8 * size, 0));
            }
        }
        return made;
    }

 private:
    double between(double least, double most) {
        return least + (most - least) * key_.uniform(drawn_++);
    }
    static void add(Scene& made, Geometry geometry, const Vec3d& at) {
        made.geometries.push_back(std::move(geometry));
        made.materials.emplace_back(Lambert{.color = Rgb(0.7f)});
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
    sample.depth = depths_of(*sample.scene);
    const Tile whole = sample.depth.view().tile();
    sample.position = sample.normal = Image<Vec3>(sample.depth.size());
    steps.positions(sample.depth.view(), sample.screen(), whole, sample.position.view());
    steps.normals(sample.position.view(), whole, sample.normal.view());
    sample.kernel.resize(kernel_points);
    steps.kernel(Key(12), sample.kernel);
    occlude(sample, steps);
    smooth(sample, steps);
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
    const std::filesystem::path folder = root / "homework/ssao";
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

}  // namespace luch::homework::ssao
