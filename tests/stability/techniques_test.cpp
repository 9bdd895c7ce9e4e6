#include "framework/stress/cases.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

// The same cases as `luch stress`, quick, for every technique of the catalogue, a homework too.
namespace luch::stress {
namespace {

/// A row of a technique; "" is the core.
struct TechniqueRow {
    std::string_view technique;
    int row;
};

void PrintTo(const TechniqueRow& tested, std::ostream* out) {
    *out << "row " << tested.row << " of " << tested.technique;
}

std::vector<StressCase> cases_of(std::string_view technique) {
    return technique_cases(find_technique(technique), find_technique("baseline"), false);
}

std::vector<TechniqueRow> technique_rows() {
    std::vector<TechniqueRow> rows;
    for (const TechniqueInfo& info : catalogue()) {
        std::set<int> numbers;
        for (const StressCase& each : cases_of(info.name)) numbers.insert(each.row);
        for (const int row : numbers) rows.push_back({info.name, row});
    }
    return rows;
}

std::string name_of(const ::testing::TestParamInfo<TechniqueRow>& tested) {
    std::string name = fmt::format("{}_Row{}", tested.param.technique, tested.param.row);
    std::replace(name.begin(), name.end(), '/', '_');
    return name;
}

/// Runs cases; those that fail, fail the test.
std::map<StressVerdict, int> ends_of(const std::vector<StressCase>& cases, int row) {
    std::map<StressVerdict, int> ends;
    for (const StressCase& each : cases) {
        if (each.row != row) continue;
        const StressResult result = result_of(each);
        ++ends[result.verdict];
        EXPECT_NE(result.verdict, StressVerdict::fail) << each.name << ": " << result.got;
        EXPECT_NE(result.got, "") << each.name;
    }
    return ends;
}

class StressOf : public ::testing::TestWithParam<TechniqueRow> {};

TEST_P(StressOf, HasNoFailure) {
    const auto [technique, row] = GetParam();
    auto ends = ends_of(cases_of(technique), row);
    if (technique == "homework/layered") {
        // Without a lens it is the baseline: no step is at work.
        const bool has_lens = row == 12 || row == 13 || row == 18 || row == 21;
        EXPECT_EQ(ends[StressVerdict::not_written] > 0, has_lens);
    } else if (technique.starts_with("homework/")) {
        // As it is handed out nothing is written.
        EXPECT_EQ(ends[StressVerdict::pass], 0);
    } else if (technique == "baseline" || technique == "path") {
        EXPECT_EQ(ends[StressVerdict::not_written], 0);
        EXPECT_EQ(ends[StressVerdict::pass] > 0, row != 15);  // they have no plane of ids
    }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, StressOf, ::testing::ValuesIn(technique_rows()), name_of);

TEST(StressOfTheCore, HasNoFailureInItsLoaderAndLoop) {
    std::vector<StressCase> cases;
    for (StressCase& each : core_cases(false)) {
        const bool rays = each.name.find(", ") != std::string::npos && each.row != 20;
        if (!rays || each.name.starts_with("a file")) cases.push_back(std::move(each));
    }
    EXPECT_EQ(ends_of(cases, 11)[StressVerdict::pass], 10);
    EXPECT_EQ(ends_of(cases, 20)[StressVerdict::pass], 1);
}

}  // namespace
}  // namespace luch::stress
