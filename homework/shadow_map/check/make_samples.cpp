#include "homework/shadow_map/check/make_samples.h"

#include "framework/scene/loader/loader.h"
#include "framework/trace/surface.h"
#include "homework/shadow_map/check/store.h"

#include <fmt/format.h>

#include <cmath>

namespace luch::homework::shadow_map {
namespace {

/// What rounding may do to a direction or a distance, and more.
constexpr float wobble = 2e-5f;

/// A vector, and eight that are nearly it.
std::vector<Vec3> around(const Vec3& v) {
    std::vector<Vec3> all{v};
    for (int k = 0; k < 8; ++k) {
        const Vec3 sign(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
        all.push_back(v * (1.0f + wobble * sign.x) + wobble * glm::length(v) * sign);
    }
    return all;
}

template <class T>
bool all_equal(const std::vector<T>& values) {
    return std::ranges::all_of(values, [&](const T& each) { return each == values.front(); });
}

Texel texel(const Steps& steps, const Vec3& direction, int n) {
    Texel found;
    steps.texel_of({&direction, 1}, n, {&found, 1});
    return found;
}

bool steady(const Steps& steps, const Vec3& direction, int n) {
    std::vector<Texel> texels;
    for (const Vec3& each : around(direction)) texels.push_back(texel(steps, each, n));
    return all_equal(texels);
}

Vec3 direction(const Key& key) {
    const double z = 2 * key.uniform(0) - 1, turn = 6.283185307179586 * key.uniform(1);
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(turn), r * std::sin(turn), z};
}

void choose_directions(Sample& sample, Key from, const Steps& steps) {
    constexpr std::size_t count = 240;
    for (std::uint64_t i = 0; sample.directions.size() < count; ++i) {
        const Key key = from.branch(i);
        const auto length = static_cast<float>(std::pow(10, 6 * key.uniform(2) - 3));
        const Vec3 chosen = length * direction(key);
        if (steady(steps, chosen, sample.map.n)) sample.directions.push_back(chosen);
    }
    sample.texels.resize(count);
    sample.centres.resize(count);
    steps.texel_of(sample.directions, sample.map.n, sample.texels);
    steps.direction_of(sample.texels, sample.map.n, sample.centres);
}

void look_around(Sample& sample, const Steps& steps, Tracer& tracer) {
    const int n = sample.map.n;
    for (int face = 0; face < faces_of_cube; ++face) {
        const auto i = static_cast<std::size_t>(face);
        Face& whole = sample.map.faces[i];
        whole = whole_face(n, 0);
        sample.nodes[i] = Image<std::uint32_t>({n, n});
        steps.render_face(sample.light(), face, n, whole.window, tracer, whole.distance.view());
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                const Texel texel{face, x, y};
                Vec3 direction;
                steps.direction_of({&texel, 1}, n, {&direction, 1});
                const Ray ray{sample.light(), Vec3d(direction)};
                sample.nodes[i](x, y) = tracer.closest(RayKind::shadow, ray).node;
            }
        }
    }
}

using Filter = decltype(Steps::lit);

/// Whether rounding cannot change what a filter says.
bool steady(const Sample& sample, Filter filter, const Receiver& receiver, float bias) {
    std::vector<float> shares;
    for (const Vec3& place : around(receiver.from_light)) {
        for (const float factor : {0.99f, 1.01f}) {
            const Receiver near{place, receiver.normal};
            const float other = factor * bias;
            float share = 0;
            filter(sample.map, {&near, 1}, {&other, 1}, {&share, 1});
            shares.push_back(share);
        }
    }
    return all_equal(shares);
}

/// What the camera sees, but for borderline cases and planes that are nearly edge on.
void choose_receivers(Sample& sample, const Steps& steps, Tracer& tracer) {
    constexpr float least_cosine = 0.01f;
    const Scene& scene = *sample.scene;
    const Size frame = scene.settings.frame;
    const Screen screen(scene.camera, frame);
    for (std::uint32_t pixel = 0; pixel < frame.area(); ++pixel) {
        const int x = static_cast<int>(pixel) % frame.width,
                  y = static_cast<int>(pixel) / frame.width;
        const Ray ray = screen.ray(x + 0.5, y + 0.5);
        const Hit hit = tracer.closest(RayKind::primary, ray);
        if (!hit) continue;
        const Surface surface = surface_at(scene, ray, hit);
        const Receiver receiver{Vec3(surface.position - sample.light()),
                                Vec3(surface.geometric_normal)};
        const float cosine = glm::dot(glm::normalize(receiver.from_light), receiver.normal);
        if (std::abs(cosine) < least_cosine) continue;
        float bias = 0;
        steps.bias({&receiver, 1}, sample.map.n, {&bias, 1});
        if (!steady(steps, receiver.from_light, sample.map.n) ||
            !steady(sample, steps.lit, receiver, bias) ||
            !steady(sample, steps.pcf, receiver, pcf_width * bias)) {
            continue;
        }
        sample.pixels.push_back(pixel);
        sample.seen.points.push_back(receiver);
        sample.seen.biases.push_back(bias);
    }
    Receivers& seen = sample.seen;
    std::vector<float> wide = seen.biases;
    for (float& bias : wide) bias *= pcf_width;
    seen.lit.resize(wide.size());
    seen.pcf.resize(wide.size());
    steps.lit(sample.map, seen.points, seen.biases, seen.lit);
    steps.pcf(sample.map, seen.points, wide, seen.pcf);
}

/// Somewhere in a texel, not too near its border.
Vec3 spot_in(const Steps& steps, const Texel& texel, int n, const Key& key) {
    Vec3 centre;
    steps.direction_of({&texel, 1}, n, {&centre, 1});
    const Vec3 off = 0.35f / static_cast<float>(n) * direction(key);
    return spot_distance * glm::normalize(centre + off);
}

void choose_spots(Sample& sample, Key from, const Steps& steps) {
    const int n = sample.map.n;
    std::vector<Texel> texels;
    const auto below = [](const Key& key, std::uint64_t purpose, int most) {
        return static_cast<int>(key.uniform(purpose) * most);
    };
    for (std::size_t i = 0; i < spots_inside; ++i) {
        const Key key = from.branch(1).branch(i);
        texels.push_back({below(key, 0, 6), 1 + below(key, 1, n - 2), 1 + below(key, 2, n - 2)});
    }
    for (std::size_t i = 0; i < spots_on_rims; ++i) {
        const int face = static_cast<int>(i) % 6, edge = static_cast<int>(i) / 6 % 4;
        const int end = edge % 2 == 0 ? 0 : n - 1,
                  along = 1 + below(from.branch(2).branch(i), 0, n - 2);
        texels.push_back(edge < 2 ? Texel{face, end, along} : Texel{face, along, end});
    }
    for (std::size_t i = 0; i < spots_in_corners; ++i) {
        const int face = static_cast<int>(i) / 4, corner = static_cast<int>(i) % 4;
        texels.push_back({face, corner % 2 == 0 ? 0 : n - 1, corner / 2 == 0 ? 0 : n - 1});
    }
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const Vec3 spot = spot_in(steps, texels[i], n, from.branch(3).branch(i));
        sample.spots.push_back({spot, -glm::normalize(spot)});
    }
    const std::vector<float> biases(texels.size(), spot_bias);
    sample.spot_shares.resize(texels.size());
    steps.pcf(speckled_map(n), sample.spots, biases, sample.spot_shares);
}

class SceneMaker {
 public:
    explicit SceneMaker(Key key) : key_(key) {}

    /// Things in a ring around the light, which is off the middle.
    Scene scene() {
        Scene made;
        made.settings.frame = {40, 30};
        made.camera.position = {0, 3.5, -9};
        made.camera.pitch_deg = -16;
        made.camera.fov_deg = 75;
        made.lights.emplace_back(PointLight{
            .position = {between(-0.7, 0.7), between(1.1, 1.9), between(-0.7, 0.7)}, .power = 50});
        add(made, Plane{}, Transform::translation({0, -1, 0}));
        for (int i = 0; i < 9; ++i) {
            const double turn = 0.7 * i + between(0, 0.3), far = between(2.2, 4);
            const double size = between(0.5, 1);
            const Transform at = Transform::translation(
                {far * std::sin(turn), between(-0.6, 2.4), far * std::cos(turn)});
            const Transform turned = Transform::rotation(between(0, 3), between(-1, 1), 0);
            if (i % 2 == 0) {
                add(made, Sphere{.radius = 0.8 * size}, at);
            } else {
                add(made, Cube{.side = size}, turned.then(at));
            }
        }
        add(made, Cube{.side = 1.5}, Transform::translation({between(-1, 1), 4, 0}));
        const Vec3d size(between(0.5, 2), 1, between(0.5, 2));
        add_rect_light(made, "",
                       {Transform::scaling(size)
                            .then(Transform::rotation(between(0, 6), between(-1, 1), 0))
                            .then(Transform::translation({4, 6, between(-3, 3)})),
                        Rgb(1), 30, 3 + int(between(0, 3)), 3});
        return made;
    }

 private:
    double between(double least, double most) {
        return least + (most - least) * key_.uniform(drawn_++);
    }
    void add(Scene& made, Geometry geometry, const Transform& to_world) {
        made.geometries.push_back(std::move(geometry));
        made.materials.emplace_back(Lambert{});
        add_node(made, "", static_cast<GeometryId>(made.geometries.size() - 1),
                 static_cast<MaterialId>(made.materials.size() - 1), to_world);
    }

    Key key_;
    std::uint64_t drawn_ = 0;
};

}  // namespace

Sample sample_of(std::string name, std::shared_ptr<const Scene> scene, int n, Key key,
                 const Steps& steps) {
    Sample sample;
    sample.name = std::move(name);
    sample.scene = std::move(scene);
    sample.map.n = n;
    const auto accelerator = build_accelerator(*sample.scene);
    Tracer tracer(*accelerator);
    choose_directions(sample, key.branch(1), steps);
    look_around(sample, steps, tracer);
    choose_receivers(sample, steps, tracer);
    choose_spots(sample, key.branch(2), steps);
    std::vector<LightPoint> points;
    steps.light_points(sample.area(), sample.points(), Pattern::regular, Key(), points);
    for (const LightPoint& point : points) sample.grid.emplace_back(point.position);
    return sample;
}

std::vector<Sample> samples_from_seed(std::uint64_t seed, const Steps& steps) {
    std::vector<Sample> samples;
    for (std::uint64_t i = 0; i < 3; ++i) {
        const Key key = Key(seed).branch(i);
        auto scene = std::make_shared<Scene>(SceneMaker(key).scene());
        const int n = 15 + static_cast<int>(10 * key.uniform(1000));
        samples.push_back(
            sample_of(fmt::format("seed {}.{}", seed, i), std::move(scene), n, key, steps));
    }
    return samples;
}

int regenerate(const std::filesystem::path& root, const Steps& steps,
               const grading::Regeneration& regeneration) {
    const std::filesystem::path folder = root / "homework/shadow_map";
    int changed = 0;
    for (const auto& [name, n] : public_samples()) {
        auto scene =
            std::make_shared<const Scene>(load_scene(folder / "scenes" / (name + ".scene")).scene);
        const Sample sample =
            sample_of(name, std::move(scene), n, Key(static_cast<std::uint64_t>(n)), steps);
        for (const grading::StoredPlane& plane : planes_of(sample)) {
            changed += grading::regenerate_plane(folder / "reference" / name, plane, {3 * n, 2 * n},
                                                 regeneration);
        }
    }
    return changed;
}

}  // namespace luch::homework::shadow_map
