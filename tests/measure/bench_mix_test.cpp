#include "framework/measure/bench_mix.h"

#include "tests/testing/shell.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace luch {
namespace {

TEST(BenchMix, RoundsByHalfALevelAtMostWithAllInstructions) {
    for (const Isa isa : usable_isas()) {
        for (const MixSpeed& speed : raced({.size = {65, 3}, .rounds = 1, .isa = isa})) {
            const bool floats = speed.mode.starts_with("float");
            EXPECT_NEAR(speed.worst_error, floats ? 0 : 0.5, 1e-4)
                << speed.mode << " on " << to_string(isa);
        }
    }
}

TEST(BenchMix, ExportsItsEntryAndNothingThatALinkerMightShare) {
    for (const char* level : {"plain", "v2", "v3", "v4"}) {
        const std::string object =
            std::string(LUCH_KERNEL_OBJECTS) + "/luch_measure_" + level + ".dir/mix/kernel.cpp.o";
        if (!std::filesystem::exists(object)) {
            ASSERT_STRNE(level, "plain") << object;
            continue;
        }
        const auto [status, text] = shell("nm --defined-only -g -C " + object);
        ASSERT_EQ(status, 0) << text;
        EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
        EXPECT_NE(text.find(std::string(" T luch::mix::kernels_") + level), text.npos) << text;
    }
}

}  // namespace
}  // namespace luch
