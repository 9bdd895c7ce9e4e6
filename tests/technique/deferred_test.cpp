#include "framework/baseline/deferred.h"

#include "tests/testing/everything.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

namespace luch {
namespace {

using Kind = ShadedParts::Kind;

struct Deferred {
    explicit Deferred(Scene scene) : studio(std::move(scene)), shot(shot_of(studio.scene())) {
        shot.spp = 3;
    }
    void defer(int sample) {
        defer_tile(studio.scene(), shot, whole(), sample, Needs(), tracer, pixels);
    }
    [[nodiscard]] Tile whole() const { return {0, 0, shot.size.width, shot.size.height}; }

    testing::OwnStudio studio;
    Shot shot;
    Tracer tracer{studio.studio().accelerator};
    DeferredPixels pixels;
};

TEST(Deferred, HasTheLightThatTraceTileMeans) {
    Deferred deferred(testing::bit_of_everything());
    Image<Rgb> sum(deferred.shot.size, Rgb(0)), traced(deferred.shot.size);
    for (int sample = 0; sample < 3; ++sample) {
        deferred.defer(sample);
        for (std::size_t i = 0; i < deferred.pixels.light.size(); ++i) {
            const auto& [x, y] = deferred.pixels.pixels[i];
            sum(x, y) += deferred.pixels.light[i];
        }
    }
    const Counts counts = deferred.tracer.counts();
    Tracer other(deferred.studio.studio().accelerator);
    trace_tile(deferred.studio.scene(), deferred.shot, deferred.whole(), Needs(), other,
               traced.view());
    for (Rgb& pixel : sum.pixels()) pixel /= 3.0f;
    EXPECT_EQ(sum, traced);
    EXPECT_EQ(counts.rays, other.counts().rays);
    EXPECT_EQ(counts.shades, other.counts().shades);
}

/// What a lit point's parts add up to, as the header has it.
Rgb summed(const ShadedParts& parts, std::size_t i, const Rgb& ambient) {
    Rgb light = ambient, highlights(0);
    for (const ShadedParts::Light& each : parts.lights()) {
        if (!each.diffuse.empty()) light += each.diffuse[i];
        if (!each.highlight.empty()) highlights += each.highlight[i];
    }
    return parts.albedo()[i] * light + highlights;
}

Rgb blended(const ShadedParts& parts, std::size_t i) {
    Rgb colour(0);
    for (const ShadedParts::Layer& layer : parts.layers()) {
        colour = colour * (Rgb(1) - layer.blend[i]) + layer.blend[i] * layer.light[i];
    }
    return colour;
}

TEST(Deferred, HasPartsThatAddUpToTheLight) {
    Deferred deferred(testing::bit_of_everything());
    deferred.defer(0);
    const ShadedParts& parts = deferred.pixels.parts;
    std::size_t lit = 0, layered = 0, other = 0;
    for (std::size_t i = 0; i < parts.points(); ++i) {
        const Rgb& light = deferred.pixels.light[i];
        const float tolerance = 1e-5f * std::max(1.0f, max_norm(light));
        if (parts.kinds()[i] == Kind::lit) {
            const Rgb sum = summed(parts, i, deferred.studio.scene().settings.ambient_light);
            ASSERT_LE(max_norm(sum - light), tolerance);
            ++lit;
        } else if (parts.kinds()[i] == Kind::layered) {
            ASSERT_LE(max_norm(blended(parts, i) - light), tolerance);
            ++layered;
        } else {
            EXPECT_EQ(parts.albedo()[i], Rgb(0));
            ++other;
        }
    }
    EXPECT_GT(lit, 500u);
    EXPECT_GT(layered, 10u);
    EXPECT_GT(other, 100u);
}

TEST(Deferred, ForgetsTheTileBefore) {
    Deferred deferred(testing::bit_of_everything());
    const Tile small{0, 0, 4, 4};
    deferred.defer(0);
    defer_tile(deferred.studio.scene(), deferred.shot, small, 0, Needs(), deferred.tracer,
               deferred.pixels);
    EXPECT_EQ(deferred.pixels.parts.points(), 16u);
    for (const ShadedParts::Light& light : deferred.pixels.parts.lights()) {
        EXPECT_TRUE(light.diffuse.empty() || light.diffuse.size() == 16);
    }
}

/// A ray log wants paths one by one: the parts are the same.
TEST(Deferred, HasTheSamePartsWhileRaysAreRecorded) {
    Deferred plain(testing::bit_of_everything()), logged(testing::bit_of_everything());
    plain.defer(0);
    RayLog log;
    logged.tracer.record(&log);
    logged.defer(0);
    EXPECT_EQ(logged.pixels.light, plain.pixels.light);
    EXPECT_EQ(logged.pixels.parts.albedo(), plain.pixels.parts.albedo());
    for (std::size_t i = 0; i < plain.pixels.parts.lights().size(); ++i) {
        EXPECT_EQ(logged.pixels.parts.lights()[i].diffuse, plain.pixels.parts.lights()[i].diffuse);
    }
}

TEST(Deferred, TakesTheEdgesThatAreMarked) {
    Deferred deferred(testing::bit_of_everything());
    Image<std::uint8_t> edges(deferred.shot.size, 0);
    edges(5, 7) = edges(40, 30) = 1;
    defer_edges(deferred.studio.scene(), deferred.shot, deferred.whole(), 2, edges.view(), Needs(),
                deferred.tracer, deferred.pixels);
    ASSERT_EQ(deferred.pixels.pixels.size(), 2u);
    const Screen screen(deferred.shot.camera, deferred.shot.size);
    const auto& [x, y] = deferred.pixels.pixels[0];
    EXPECT_EQ(deferred.pixels.rays[0].direction, screen.ray(x + 0.2, y + 0.8).direction);
}

}  // namespace
}  // namespace luch
