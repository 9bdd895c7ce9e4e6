#include "framework/stress/rays/rows.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cctype>
#include <chrono>
#include <cstdlib>

// The core's rows at a size for every day, or with LUCH_FULL=1 in the environment at the stated
// one.
namespace luch::stress {
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

/// "1RaysAtEdgesOnV2".
std::string name_of(const ::testing::TestParamInfo<Case>& tested) {
    std::string name = std::to_string(tested.param.row.number);
    bool begins = true;
    for (const char c : tested.param.row.name) {
        if (c != ' ') name += begins ? static_cast<char>(std::toupper(c)) : c;
        begins = c == ' ';
    }
    return name + "On" + std::string(to_string(tested.param.isa));
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
    const Tally tally = row.run({is_full() ? 1 : row.smoke, isa});
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    fmt::print("{:>2} {:<38} {:<5} {:>11} {:<8} {:>4} failures {:>8.2f} s\n", row.number, row.name,
               to_string(isa), tally.rays, row.unit, tally.failures, seconds);
    EXPECT_GT(tally.rays, 500u);
    EXPECT_EQ(tally.failures, 0u) << tally.first;
}

INSTANTIATE_TEST_SUITE_P(Row, Stability, ::testing::ValuesIn(cases()), name_of);

}  // namespace
}  // namespace luch::stress
