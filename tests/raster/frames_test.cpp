#include "framework/raster/item_buffer.h"
#include "tests/testing/everything.h"

#include <gtest/gtest.h>

namespace luch {
namespace {

class Frames : public ::testing::TestWithParam<Isa> {};

TEST_P(Frames, AreThoseOfRaysInASceneOfEverythingOnceAmbiguousPixelsAreTraced) {
    const Scene scene = testing::bit_of_everything();
    const auto accelerator = build_accelerator(scene, GetParam());
    ItemBuffer buffer(scene, GetParam());
    buffer.draw(Screen(scene.camera, {64, 48}), Vec2d(0.5), Workers(2));
    WorkCounts work;
    for (int i = 0; i < buffer.tile_count(); ++i) {
        const RayPacket rays = buffer.rays(i);
        HitPacket hits, truth;
        buffer.resolve(i, rays, hits);
        buffer.trace_ambiguous(i, rays, *accelerator, hits, work);
        accelerator->closest(rays, truth, work);
        for (int k = 0; k < RayPacket::capacity; ++k) {
            ASSERT_EQ(hits.hit(k), truth.hit(k)) << "tile " << i << ", ray " << k;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, Frames, ::testing::ValuesIn(usable_isas()),
                         [](const auto& level) { return std::string(to_string(level.param)); });

}  // namespace
}  // namespace luch
