#include "tests/stability/rows.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

// The table's rows at a size for every day, or with LUCH_FULL=1 in the environment at the stated
// one.
namespace luch::stability {
namespace {

bool is_full() {
    const char* full = std::getenv("LUCH_FULL");
    return full != nullptr && std::string_view(full) == "1";
}

struct Case {
    Row row;
    Isa isa;
};

void PrintTo(const Case& tested, std::ostream* out) {
    *out << tested.row.name << " on " << to_string(tested.isa);
}

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const Row& row : rows()) {
        for (const Isa isa : usable_isas()) {
            if (row.every_isa || isa == usable_isas().back()) all.push_back({row, isa});
        }
    }
    return all;
}

class Stability : public ::testing::TestWithParam<Case> {};

TEST_P(Stability, HasNoFailure) {
    const auto& [row, isa] = GetParam();
    const auto start = std::chrono::steady_clock::now();
    const Counts counts = row.run({is_full() ? 1 : row.smoke, isa});
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    fmt::print("{:<32} {:<5} {:>11} rays {:>4} failures {:>8.2f} s\n", row.name, to_string(isa),
               counts.rays, counts.failures, seconds);
    EXPECT_GT(counts.rays, 500u);
    EXPECT_EQ(counts.failures, 0u) << counts.first;
}

INSTANTIATE_TEST_SUITE_P(Row, Stability, ::testing::ValuesIn(cases()), [](const auto& tested) {
    return std::string(tested.param.row.name) + "On" + std::string(to_string(tested.param.isa));
});

}  // namespace
}  // namespace luch::stability
