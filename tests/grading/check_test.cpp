#include "framework/grading/check.h"

#include "framework/base/error.h"
#include "framework/base/files.h"
#include "framework/base/json_reader.h"
#include "tests/grading/fake.h"
#include "tests/testing/own_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luch::grading {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Report checked(int (*yours)(int)) {
    CheckOptions options;
    options.judge.limit_s = 0.3;
    return check(fake::homework(yours), options);
}

const TestResult& squares_of(const Report& report) {
    return report.tasks.at(0).tests.at(0);
}

TEST(Check, GivesAllPointsForWhatIsRight) {
    const Report report = checked(fake::right);
    EXPECT_EQ(report.points(), 6);
    EXPECT_EQ(report.max_points(), 6);
    EXPECT_TRUE(report.complete);
    EXPECT_EQ(report.tasks[0].status(), Status::pass);
}

TEST(Check, SaysNotAttemptedForAHoleAndGoesOn) {
    const Report report = checked(fake::hole);
    EXPECT_EQ(report.tasks[0].status(), Status::not_written);
    EXPECT_EQ(report.tasks[1].status(), Status::pass);
    EXPECT_EQ(report.points(), 2);
    EXPECT_THAT(task_text(report, report.tasks[0]),
                HasSubstr("NOT ATTEMPTED fake.t1  0/4  squares — homework/fake/README.md#t1"));
    EXPECT_THAT(sum_text(report), HasSubstr("2 of 6 points; not attempted: fake.t1"));
}

TEST(Check, TakesOnlyThePointsOfTheCasesThatCrash) {
    const Report report = checked(fake::crash);  // on the larger numbers
    EXPECT_EQ(squares_of(report).cases.at(0).status, Status::pass);
    EXPECT_EQ(squares_of(report).cases.at(1).status, Status::crashed);
    EXPECT_THAT(squares_of(report).cases.at(1).finding.what, HasSubstr("Segmentation fault"));
    EXPECT_EQ(report.points(), 4);
}

TEST(Check, EndsALoopAndGoesOn) {
    const Report report = checked(fake::loop);
    EXPECT_EQ(squares_of(report).status(), Status::timed_out);
    EXPECT_THAT(task_text(report, report.tasks[0]), HasSubstr("TIMEOUT fake.t1.squares  0/4"));
    EXPECT_EQ(report.points(), 2);
}

TEST(Check, IsNotFooledByAProgramThatEndsWell) {
    const Report report = checked(fake::leaves);
    EXPECT_EQ(squares_of(report).status(), Status::crashed);
    EXPECT_EQ(report.points(), 2);
}

TEST(Check, ShowsTheWordsOfAnException) {
    const Report report = checked(fake::throws);
    EXPECT_THAT(task_text(report, report.tasks[0]), HasSubstr("no squares today"));
}

TEST(Check, NamesTheMistakeThatTheFailureLooksLike) {
    EXPECT_EQ(checked(fake::doubled).tasks[0].likely, "2x instead of x²");
    EXPECT_EQ(checked(fake::off_by_one).tasks[0].likely, "1 too many");
    EXPECT_EQ(checked([](int x) { return x == 7 ? 0 : x * x; }).tasks[0].likely, "");
    EXPECT_EQ(checked(fake::right).tasks[0].likely, "");
}

TEST(Check, WritesTheReportAfterEveryTest) {
    const auto folder = own_folder();
    CheckOptions options;
    options.json = folder / "report.json";
    std::vector<std::size_t> tests_in_report;
    std::vector<bool> complete;
    options.on_task = [&](const Report&, const Report::Task&) {
        const JsonDocument document(read_text(options.json), "report.json");
        std::size_t count = 0;
        const JsonValue tasks = *document.root().member("tasks");
        for (std::size_t i = 0; i < tasks.size(); ++i) count += tasks.at(i).member("tests")->size();
        tests_in_report.push_back(count);
        complete.push_back(*document.root().member("complete")->boolean());
        EXPECT_EQ(document.root().member("max_score")->number(), 6);
    };
    check(fake::homework(fake::doubled), options);
    EXPECT_THAT(tests_in_report, ElementsAre(1u, 2u));
    EXPECT_THAT(complete, ElementsAre(false, false));
    const JsonDocument document(read_text(options.json), "report.json");
    EXPECT_EQ(document.root().member("complete")->boolean(), true);
    EXPECT_EQ(document.root().member("score")->number(), 2);
    std::filesystem::remove_all(folder);
}

TEST(Check, KeepsOneTaskOrTestWhenAsked) {
    Homework homework = fake::homework(fake::right);
    keep_only(homework, "fake.t2");
    ASSERT_EQ(homework.tasks.size(), 1u);
    EXPECT_EQ(points_of(homework), 2);
    homework = fake::homework(fake::right);
    keep_only(homework, "fake.t1.squares");
    EXPECT_EQ(points_of(homework), 4);
}

TEST(Check, FailsWhenAFilterMatchesNothing) {
    Homework homework = fake::homework(fake::right);
    try {
        keep_only(homework, "fake.t3");
        FAIL() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("no task or test of fake is called \"fake.t3\""));
        EXPECT_THAT(error.what(), HasSubstr("fake.t1"));
    }
}

TEST(Check, FailsWhenATestHasNothingToBeTriedOn) {
    Homework homework = fake::homework(fake::right);
    homework.tasks[0].tests[0].cases.clear();
    EXPECT_THROW(keep_only(homework, ""), Error);
}

}  // namespace
}  // namespace luch::grading
