#include "framework/stress/cases.h"
#include "framework/stress/subject.h"
#include "framework/technique/context.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

// Techniques that are wrong, each in its own way: the table must say so.
namespace luch::stress {
namespace {

using ::testing::HasSubstr;

enum class Fault {
    none,
    nan,
    throws,
    forgets,  // its pictures differ from instance to instance
    cuts,
    counts_workers,
    skips_too_much,
    declines_silently,
    declines,
    unwritten,
    ages,
    leaks,
};

std::atomic<int> instances = 0;

template <Fault fault>
class Wrong final : public Technique {
 public:
    [[nodiscard]] Plan plan(const Scene&, const Shot&) const override {
        if (fault == Fault::declines_silently) return {.applies = false, .why = "", .stages = {}};
        if (fault == Fault::declines) return {.applies = false, .why = "too hot", .stages = {}};
        return {.applies = true, .why = "", .stages = {{"sparkle", false, Stage::exact, "", 0}}};
    }
    void render(const Scene&, const Shot& shot, Frame& frame, Context& context) override {
        constexpr float nan = std::numeric_limits<float>::quiet_NaN();
        Rgb colour(0.5f);
        if (fault == Fault::throws) throw std::runtime_error("out of ink");
        if (fault == Fault::forgets) colour *= static_cast<float>(instance_);
        if (fault == Fault::counts_workers) colour *= static_cast<float>(context.workers());
        if (fault == Fault::skips_too_much && context.plan().needed("sparkle")) colour *= 2.0f;
        if (fault == Fault::unwritten) context.not_written("ink.t1");
        if (fault == Fault::ages && ++frames_ > 10) colour *= 2.0f;
        if (fault == Fault::leaks) ink_.resize(ink_.size() + 100'000, 'x');
        for (Rgb& pixel : frame.colour.pixels()) pixel = colour;
        if (fault == Fault::nan) frame.colour(shot.size.width - 1, 0) = Rgb(nan);
        if (fault == Fault::cuts) frame.resize({1, 1});
    }

 private:
    int instance_ = ++instances;
    int frames_ = 0;
    std::string ink_;
};

template <Fault fault>
TechniqueInfo info_of() {
    return {
        .name = "wrong", .title = "", .topic = "", .create = []() -> std::unique_ptr<Technique> {
            return std::make_unique<Wrong<fault>>();
        }};
}

template <Fault fault>
StressResult looked_at_with(const Check& check = {}) {
    const TechniqueInfo info = info_of<fault>();
    return looked_at({&info, &info, false}, one_triangle(), check);
}

void expect_failure(const StressResult& result, const std::string& why) {
    EXPECT_EQ(result.verdict, StressVerdict::fail);
    EXPECT_THAT(result.got, HasSubstr(why));
}

TEST(StressJudge, PassesASoundPicture) {
    EXPECT_EQ(looked_at_with<Fault::none>().verdict, StressVerdict::pass);
    EXPECT_EQ(looked_at_with<Fault::none>(all_of(Rgb(0.5f))).verdict, StressVerdict::pass);
}

TEST(StressJudge, NamesWhatAPictureOwes) {
    expect_failure(looked_at_with<Fault::nan>(), "1 pixels are not finite, the first at (159, 0)");
    expect_failure(looked_at_with<Fault::forgets>(), "another picture on 1 thread than on 2");
    expect_failure(looked_at_with<Fault::counts_workers>(),
                   "another picture on 1 thread than on 2");
    expect_failure(looked_at_with<Fault::cuts>(), "1 × 1 pixels, not 160 × 120");
    expect_failure(looked_at_with<Fault::skips_too_much>(), "left out as exact");
    expect_failure(looked_at_with<Fault::declines_silently>(), "no word why");
    expect_failure(looked_at_with<Fault::none>(all_of(Rgb(0.25f))), "19200 of 19200 pixels wrong");
}

TEST(StressJudge, CountsApartWhatSaysNothing) {
    const StressResult declined = looked_at_with<Fault::declines>();
    EXPECT_EQ(declined.verdict, StressVerdict::does_not_apply);
    EXPECT_EQ(declined.got, "too hot");
    const StressResult unwritten = looked_at_with<Fault::unwritten>();
    EXPECT_EQ(unwritten.verdict, StressVerdict::not_written);
    EXPECT_EQ(unwritten.got, "ink.t1");
    expect_failure(looked_at_with<Fault::unwritten>(all_of(Rgb(0.25f))), "pixels wrong");
}

/// The verdicts of a row, quick.
template <Fault fault>
std::vector<StressResult> results_of(int row) {
    const TechniqueInfo info = info_of<fault>();
    std::vector<StressResult> results;
    for (const StressCase& each : technique_cases(info, info, false)) {
        if (each.row == row) results.push_back(result_of(each));
    }
    return results;
}

TEST(StressJudge, GoesOnWhenATechniqueThrows) {
    const auto results = results_of<Fault::throws>(12);
    EXPECT_GT(results.size(), 10u);
    for (const StressResult& result : results) expect_failure(result, "threw: out of ink");
}

TEST(StressJudge, SeesWhatALoopDoesToATechnique) {
    for (const StressResult& result : results_of<Fault::ages>(20)) {
        expect_failure(result, "frame 16 is not frame 0");
    }
    for (const StressResult& result : results_of<Fault::leaks>(20)) {
        expect_failure(result, "grown by");
    }
}

TEST(StressJudge, SeesPicturesThatDependOnThreads) {
    for (const StressResult& result : results_of<Fault::counts_workers>(21)) {
        expect_failure(result, "another picture on 2 threads");
    }
}

TEST(StressJudge, SeesAPaintedSkyWhereAThingStands) {
    int wrong = 0;
    for (const StressResult& result : results_of<Fault::none>(13)) {
        wrong += result.verdict == StressVerdict::fail ? 1 : 0;
    }
    EXPECT_GT(wrong, 20);  // all but those that only ask for finite pixels
}

TEST(StressJudge, TakesATechniquesOwnCases) {
    TechniqueInfo info = info_of<Fault::none>();
    info.stress_cases = [](const TechniqueInfo& subject, bool full) {
        const std::string name = std::string(subject.name) + (full ? ", full" : ", quick");
        const auto run = [] { return StressResult{StressVerdict::fail, "acne"}; };
        return std::vector<StressCase>{{16, name, "no acne", run}};
    };
    int own = 0;
    for (const StressCase& each : technique_cases(info, info, false)) {
        if (each.row != 16) continue;
        ++own;
        EXPECT_EQ(each.name, "wrong, quick");
        expect_failure(result_of(each), "acne");
    }
    EXPECT_EQ(own, 1);
}

TEST(StressJudge, CallsTwoPicturesUnlikeBySizeNotByAnAbsoluteNumber) {
    Image<Rgb> small({2, 1}, Rgb(1e-20f)), off = small;
    off(1, 0) = Rgb(1.01e-20f);
    EXPECT_EQ(unlike(small.view(), small.view(), 0), 0u);
    EXPECT_EQ(unlike(small.view(), off.view(), 1e-3), 1u);
    EXPECT_EQ(unlike(small.view(), off.view(), 0.1), 0u);
    EXPECT_EQ(unlike(small.view(), Image<Rgb>({3, 1}).view(), 1), 3u);
    off(1, 0) = Rgb(std::numeric_limits<float>::quiet_NaN());
    EXPECT_EQ(unlike(small.view(), off.view(), 1), 1u);
}

/// A technique whose colours come in steps and end at white.
TEST(Unlike, AllowsAStepAndTakesWhatIsBrighterForWhite) {
    const Image<Rgb> truth({2, 1}, Rgb(3)), white({2, 1}, Rgb(1)), dim({2, 1}, Rgb(0.97f));
    EXPECT_EQ(unlike(truth.view(), white.view(), 0, 0.02), 0u);
    EXPECT_EQ(unlike(truth.view(), white.view(), 0), 2u);
    EXPECT_EQ(unlike(truth.view(), dim.view(), 0, 0.02), 2u);
    EXPECT_EQ(unlike(truth.view(), dim.view(), 0, 0.04), 0u);
}

}  // namespace
}  // namespace luch::stress
