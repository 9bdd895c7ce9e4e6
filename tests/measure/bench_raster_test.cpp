#include "framework/measure/bench_raster.h"

#include "tests/testing/meshes.h"

#include <gtest/gtest.h>

namespace luch {
namespace {

TEST(BenchRaster, FindsTheHitsOfRaysInEveryPixelItRaces) {
    RasterBench bench;
    bench.size = {70, 50};
    bench.rounds = 1;
    bench.isa = usable_isas().back();
    const Mesh mesh = testing::uv_sphere(12, 16, 0.5);
    const RasterSpeed speed = raced("ball", mesh, {{0, 0, -2}, {0, 0, 0}, {0, 3, 0}}, bench);
    EXPECT_EQ(speed.pixels, 3'500u);
    EXPECT_EQ(speed.mismatches, 0u);
    EXPECT_GT(speed.covered, 300u);
    EXPECT_LT(speed.covered, 1'000u);
    EXPECT_LT(speed.ambiguous, 40u);
    ASSERT_EQ(speed.modes.size(), 5u);
    EXPECT_EQ(speed.modes[1].mode, "packets");
    EXPECT_EQ(speed.ratio_of(speed.modes[1]), 1);
}

}  // namespace
}  // namespace luch
