#include "framework/trace/known_light.h"

#include "framework/trace/whitted.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace luch {
namespace {

/// Says the same of every light and point.
class SameShare : public ShadowSource {
 public:
    explicit SameShare(float of_tiles, float of_others = unknown)
        : of_tiles_(of_tiles), of_others_(of_others) {}
    void shares(std::size_t, std::span<const Surface>, std::span<const std::uint32_t> which,
                std::span<float> shares) const override {
        asked += which.size();
        std::ranges::fill(shares, of_tiles_);
    }
    float share(std::size_t, const Surface&) const override { return of_others_; }
    mutable std::size_t asked = 0;

 private:
    float of_tiles_, of_others_;
};

/// Ambient light that remembers who asked.
struct Remembering : AmbientSource {
    Rgb at(const Surface&, std::size_t point) const override {
        points.insert(point);
        return Rgb(2);
    }
    mutable std::set<std::size_t> points;
};

/// What 400 rays of a tile show of a scene.
struct Shown {
    std::vector<Rgb> light;
    Counts counts;
};

Shown shown(const Scene& scene, const KnownLight& known) {
    const auto accelerator = build_accelerator(scene);
    std::vector<Ray> rays;
    std::vector<Key> keys;
    for (int i = 0; i < 400; ++i) {
        rays.push_back({{0, 0, 0}, {i % 20 * 0.05 - 0.5, i / 20 * 0.05 - 0.5, 1}});
        keys.push_back(Key(7).branch(static_cast<std::uint64_t>(i)));
    }
    Tracer tracer(*accelerator);
    std::vector<Hit> hits(rays.size());
    tracer.closest(RayKind::primary, rays, hits);
    Shown result;
    result.light.resize(rays.size());
    Whitted(scene, Needs(), tracer, known).shade(RayKind::primary, rays, hits, keys, result.light);
    result.counts = tracer.counts();
    return result;
}

/// A white square that fills the view, without ambient light.
Scene wall() {
    Scene scene = testing::empty_scene();
    scene.settings.ambient_light = Rgb(0);
    testing::add_shape(scene, Cube{.centre = {0, 0, 20}, .side = 30}, {}, Rgb(1));
    return scene;
}

TEST(KnownLight, TakesTheShareOfALightThatASourceKnows) {
    const Scene scene = wall();
    const Shown rays = shown(scene, {});
    for (const float share : {0.0f, 0.25f, 1.0f}) {
        const SameShare source(share);
        const Shown known = shown(scene, {.shadows = &source});
        EXPECT_EQ(source.asked, 400u);
        EXPECT_EQ(known.counts.of(RayKind::shadow), 0u);
        for (std::size_t i = 0; i < known.light.size(); ++i) {
            EXPECT_EQ(known.light[i], rays.light[i] * share);
        }
    }
}

TEST(KnownLight, AsksRaysWhatASourceDoesNotKnow) {
    Scene scene = testing::sixty_spheres();
    scene.lights.emplace_back(RectLight{.to_world = {glm::dmat3(1), {0, 5, 3}}});
    scene.lights.emplace_back(DirectionalLight{});
    const Shown rays = shown(scene, {});
    const SameShare source(ShadowSource::unknown);
    const Shown known = shown(scene, {.shadows = &source});
    EXPECT_EQ(known.light, rays.light);
    EXPECT_EQ(known.counts.of(RayKind::shadow), rays.counts.of(RayKind::shadow));
    EXPECT_GT(source.asked, 100u);
}

TEST(KnownLight, AsksASourceForLightsWithAnArea) {
    Scene scene = wall();
    scene.lights = {RectLight{.to_world = {glm::dmat3(1), {0, 9, 4}}}};
    const SameShare source(0);
    const Shown known = shown(scene, {.shadows = &source});
    EXPECT_EQ(known.counts.of(RayKind::shadow), 0u);
    for (const Rgb& light : known.light) EXPECT_EQ(light, Rgb(0));
}

TEST(KnownLight, AsksASourceForWhatAMirrorShows) {
    Scene scene = wall();
    scene.materials.emplace_back(Reflection{.multiplier = Rgb(1)});
    scene.nodes.back().material = static_cast<MaterialId>(scene.materials.size() - 1);
    testing::add_shape(scene, Cube{.centre = {0, 0, -20}, .side = 30}, {}, Rgb(1));
    scene.lights = {PointLight{.position = {0, 0, 0}, .power = 100}};
    const SameShare dark(ShadowSource::unknown, 0), bright(ShadowSource::unknown, 1);
    const Shown rays = shown(scene, {});
    EXPECT_EQ(shown(scene, {.shadows = &bright}).light, rays.light);
    EXPECT_NE(rays.light[0], Rgb(0));
    for (const Rgb& light : shown(scene, {.shadows = &dark}).light) EXPECT_EQ(light, Rgb(0));
}

TEST(KnownLight, TakesAmbientLightFromASourceAndSaysWhichPointAsks) {
    Scene scene = wall();
    scene.lights.clear();
    const Remembering source;
    for (const Rgb& light : shown(scene, {.ambient = &source}).light) EXPECT_EQ(light, Rgb(2));
    EXPECT_EQ(source.points.size(), 400u);
    EXPECT_EQ(*source.points.rbegin(), 399u);

    scene.materials.emplace_back(Reflection{.multiplier = Rgb(1)});
    scene.nodes.back().material = static_cast<MaterialId>(scene.materials.size() - 1);
    testing::add_shape(scene, Cube{.centre = {0, 0, -20}, .side = 30}, {}, Rgb(1));
    const Remembering mirrored;
    (void)shown(scene, {.ambient = &mirrored});
    EXPECT_EQ(mirrored.points, std::set<std::size_t>{AmbientSource::nowhere});
}

}  // namespace
}  // namespace luch
