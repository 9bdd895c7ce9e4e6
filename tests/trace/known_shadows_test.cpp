#include "framework/trace/known_shadows.h"

#include "framework/trace/whitted.h"
#include "tests/testing/everything.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

namespace luch {
namespace {

/// A tile's rays, and what shading them one by one and together gives.
struct Shaded {
    std::vector<Rgb> one_by_one, together;
    Counts counts_of_one_by_one, counts_of_together;
};

Shaded shaded(const Scene& scene, bool dark_rays) {
    const auto accelerator = build_accelerator(scene);
    std::vector<Ray> rays;
    std::vector<Key> keys;
    for (int i = 0; i < 900; ++i) {
        rays.push_back({{0, 0, 0}, {i % 30 * 0.05 - 0.75, i / 30 * 0.05 - 0.75, 1}});
        keys.push_back(Key(4).branch(static_cast<std::uint64_t>(i)));
    }
    Shaded result;
    Needs needs;
    needs[Part::dark_shadow_rays] = dark_rays;
    Tracer alone(*accelerator), all(*accelerator);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        result.one_by_one.push_back(
            Whitted(scene, needs, alone).radiance(RayKind::primary, rays[i], keys[i]));
    }
    std::vector<Hit> hits(rays.size());
    all.closest(RayKind::primary, rays, hits);
    result.together.resize(rays.size());
    Whitted(scene, needs, all).shade(RayKind::primary, rays, hits, keys, result.together);
    result.counts_of_one_by_one = alone.counts();
    result.counts_of_together = all.counts();
    return result;
}

TEST(KnownShadows, ChangeNeitherABitNorARay) {
    Scene spheres = testing::sixty_spheres();
    spheres.lights.emplace_back(SpotLight{.position = {3, 4, -2}});
    for (const Scene& scene : {spheres, testing::one_of_each(), testing::bit_of_everything()}) {
        for (const bool dark_rays : {false, true}) {
            const Shaded result = shaded(scene, dark_rays);
            EXPECT_EQ(result.together, result.one_by_one);
            for (const RayKind kind : {RayKind::primary, RayKind::shadow, RayKind::reflection}) {
                EXPECT_EQ(result.counts_of_together.of(kind), result.counts_of_one_by_one.of(kind));
            }
            EXPECT_GT(result.counts_of_together.of(RayKind::shadow), 100u);
        }
    }
}

TEST(KnownShadows, AskOnlyLightsThatStandInOnePlace) {
    Scene scene = testing::one_triangle();
    scene.lights = {PointLight{.position = {0, 0, -5}}, RectLight{}};
    const auto accelerator = build_accelerator(scene);
    Tracer tracer(*accelerator);
    const Ray ray{{0, 0, 0}, {0, 0, 1}};
    const Hit hit = tracer.closest(RayKind::primary, ray);
    ASSERT_TRUE(hit);
    const Surface surface = surface_at(scene, ray, hit);
    const KnownShadows shadows(scene, {&surface, 1}, {&hit, 1}, Needs(), tracer);
    EXPECT_EQ(shadows.share(0, 0), 1);
    EXPECT_EQ(shadows.share(1, 0), ShadowSource::unknown);
    EXPECT_EQ(tracer.counts().of(RayKind::shadow), 1u);
}

}  // namespace
}  // namespace luch
