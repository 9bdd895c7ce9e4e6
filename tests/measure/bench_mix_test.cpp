#include "framework/measure/bench_mix.h"

#include "tests/testing/kernel_objects.h"

namespace luch {
namespace {

TEST(BenchMix, RoundsByHalfALevelAtMostWithAllInstructions) {
    for (const Isa isa : usable_isas()) {
        for (const MixSpeed& speed : raced({.size = {65, 3}, .rounds = 1, .isa = isa})) {
            const bool exact = speed.mode.starts_with("float") || speed.mode.ends_with("texture");
            EXPECT_NEAR(speed.worst_error, exact ? 0 : 0.5, 5e-3)
                << speed.mode << " on " << to_string(isa);
        }
    }
}

TEST(BenchMix, ExportsItsEntryAndNothingThatALinkerMightShare) {
    testing::expect_one_entry_each(LUCH_KERNEL_OBJECTS "/luch_measure_", ".dir/mix/kernel.cpp.o",
                                   "luch::mix::kernels_");
}

}  // namespace
}  // namespace luch
