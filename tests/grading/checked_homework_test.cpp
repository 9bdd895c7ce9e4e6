// What holds for every homework; compiled once for each.
#include "tests/grading/checked_homework.h"

#include "framework/base/files.h"
#include "framework/grading/check.h"
#include "framework/image/io.h"
#include "tests/testing/own_folder.h"
#include "tests/testing/shell.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

namespace luch {
namespace {

using ::testing::HasSubstr;

class Checks : public ::testing::TestWithParam<std::string> {
 protected:
    [[nodiscard]] Ran check(const std::string& arguments) const {
        return shell("'" LUCH_PROGRAM "' check " + homework_.topic + " " + arguments);
    }
    [[nodiscard]] std::filesystem::path folder() const {
        return std::filesystem::path(LUCH_SOURCE_DIR) / "homework" / homework_.topic;
    }

    const testing::CheckedHomework homework_ = testing::checked_homework();
};

INSTANTIATE_TEST_SUITE_P(Homework, Checks, ::testing::Values(testing::checked_homework().topic),
                         [](const auto& topic) { return topic.param; });

TEST_P(Checks, ScoreTheirFloorAsTheHomeworkIsHandedOut) {
    const Ran ran = check("");
    EXPECT_EQ(ran.status, 1);
    for (std::size_t task = 1; task <= homework_.points.size(); ++task) {
        EXPECT_THAT(ran.text, HasSubstr(fmt::format("NOT ATTEMPTED {}.t{}  0/{:g}", homework_.topic,
                                                    task, homework_.points[task - 1])));
    }
    const double all = std::accumulate(homework_.points.begin(), homework_.points.end(), 0.0);
    EXPECT_THAT(ran.text, HasSubstr(fmt::format("\n0 of {:g} points", all)));
}

TEST_P(Checks, FindEveryKnownMistakeAndKnowItByItsFailures) {
    const Ran ran = check("--mutants");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_THAT(ran.text, HasSubstr(fmt::format("{} mutants, every one fails", homework_.mutants)));
}

TEST_P(Checks, LetEveryHonestVariantPass) {
    const Ran ran = check("--variants");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_THAT(ran.text, HasSubstr(fmt::format("{} honest variants, every one has all points",
                                                homework_.variants)));
}

TEST_P(Checks, DoSoOnHiddenSamplesToo) {
    const Ran ran = check("--mutants --variants --seed 20261122");
    EXPECT_EQ(ran.status, 0) << ran.text;
}

TEST_P(Checks, HaveTheReferenceOutputsOfTheReferenceSteps) {
    const Ran ran = check("--regenerate");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_EQ(ran.text, "nothing has changed\n");
}

TEST_P(Checks, KeepTheirReferenceOutputsSmall) {
    std::uintmax_t bytes = 0;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(folder() / "reference")) {
        if (entry.is_regular_file()) bytes += entry.file_size();
    }
    EXPECT_GT(bytes, 20'000u);
    EXPECT_LE(bytes, 300'000u);
}

TEST_P(Checks, HaveTheHandoutsPicturesOfTheReferenceSteps) {
    ASSERT_NE(homework_.checker.handout, nullptr);
    const auto own = own_folder();
    std::uintmax_t bytes = 0;
    for (const auto& picture : homework_.checker.handout(LUCH_SOURCE_DIR)) {
        const std::string file = "pictures/" + picture.name + ".png";
        write_picture(own / "made.png", picture.pixels.view());
        EXPECT_EQ(read_picture(folder() / file).pixels, read_picture(own / "made.png").pixels)
            << file << ": luch check " << homework_.topic << " --handout makes it again";
        for (const char* handout : {"README.md", "README.bg.md"}) {
            EXPECT_THAT(read_text(folder() / handout), HasSubstr("](" + file + ")")) << handout;
        }
        bytes += file_size(folder() / file);
    }
    EXPECT_GT(bytes, 10'000u);
    EXPECT_LE(bytes, 250'000u);
    std::filesystem::remove_all(own);
}

TEST_P(Checks, LetEachTaskBeDoneFirst) {
    ASSERT_EQ(homework_.alone.size(), homework_.points.size());
    for (std::size_t task = 0; task < homework_.alone.size(); ++task) {
        grading::Homework homework = homework_.checker.make(LUCH_SOURCE_DIR, std::nullopt);
        homework.yours = homework_.alone[task];
        std::vector<double> points, expected(homework_.points.size(), 0);
        for (const auto& each : grading::check(homework, {}).tasks) points.push_back(each.points());
        expected[task] = homework_.points[task];
        EXPECT_EQ(points, expected) << "t" << task + 1;
    }
}

TEST_P(Checks, CallAnUnknownTaskAUsersMistake) {
    const Ran ran = check("--task " + homework_.topic + ".t99");
    EXPECT_EQ(ran.status, 2);
    EXPECT_THAT(ran.text, HasSubstr("did you mean " + homework_.topic + ".t"));
    EXPECT_EQ(check("--seed x").status, 2);
}

}  // namespace
}  // namespace luch
