#include "framework/measure/lab.h"

#include "framework/base/error.h"
#include "framework/measure/findings.h"
#include "framework/measure/lab_point.h"
#include "tests/measure/samples.h"
#include "tests/measure/toys.h"
#include "tests/testing/own_folder.h"
#include "tests/testing/scenes.h"

#include <gmock/gmock.h>

#include <limits>

namespace luch {
namespace {

using testing::create;
using testing::noisy;
using testing::off;
using testing::OwnStudio;

class NotFinite final : public testing::Off {
 public:
    void render(const Scene& scene, const Shot& shot, Frame& frame, Context& context) override {
        Off::render(scene, shot, frame, context);
        frame.colour(2, 1) = Rgb(std::numeric_limits<float>::quiet_NaN());
    }
};

class DoesNotApply final : public testing::Off {
 public:
    Plan plan(const Scene&, const Shot&) const override {
        return {.applies = false, .why = "no lights", .stages = {}};
    }
};

class Throws final : public testing::Off {
 public:
    void render(const Scene&, const Shot&, Frame&, Context&) override {
        throw Error("a hole in it");
    }
};

/// Another grey for every seed.
class ByChance final : public testing::Off {
 public:
    void render(const Scene&, const Shot& shot, Frame& frame, Context&) override {
        frame.colour = Image<Rgb>(shot.size, Rgb(static_cast<float>(Key(shot.seed).uniform(0))));
    }
};

LabOptions small() {
    LabOptions options = LabOptions::quick();
    options.repeat = {0, 3};
    return options;
}

SceneReport lab_of(const TechniqueInfo& info, const LabOptions& options = small(),
                   const std::string& content = "", bool lens = false) {
    Scene scene = testing::one_triangle();
    scene.settings.frame = {24, 16};
    scene.camera.depth_of_field = lens;
    const OwnStudio studio(std::move(scene), 1);
    const Budget budget;
    const LabScene in{"tiny", studio.studio(), shot_of(studio.scene()), budget, content};
    const std::array<const TechniqueInfo*, 1> techniques{&info};
    return run_lab(in, noisy, techniques, options);
}

TEST(Lab, WalksATechniqueAlongItsSweepAgainstTheBaseline) {
    const SceneReport report = lab_of(off);
    ASSERT_EQ(report.series.size(), 2u);
    const LabSeries& series = report.series[0];
    EXPECT_EQ(series.parameter, "error");
    EXPECT_EQ(series.truth, "noisy, 1 sample a pixel");
    EXPECT_TRUE(report.truth(series.truth)->exact);
    ASSERT_EQ(series.points.size(), 3u);
    EXPECT_GT(series.points[0].errors.rmse, series.points[1].errors.rmse);
    EXPECT_GT(series.points[1].errors.rmse, 0);
    EXPECT_EQ(series.points[2].errors.rmse, 0);
    EXPECT_TRUE(series.points[2].identical);
    EXPECT_FALSE(series.points[1].identical);
    EXPECT_EQ(series.points[0].counts.of(RayKind::primary), 24u * 16u);
    EXPECT_EQ(series.points[0].frames, 3);
}

TEST(Lab, MeasuresErrorsAsDisplayedAndTheSlopesInLinearLight) {
    const LabPoint point = lab_of(off).series[0].points[0];
    EXPECT_NEAR(point.errors.rmse, srgb_encoded(0.75f) - srgb_encoded(0.25f), 1e-6);
    EXPECT_NEAR(point.linear_rmse, 0.5, 1e-6);
}

TEST(Lab, TakesWhatIsBrighterThanWhiteForWhiteWhereATechniquesColoursEndThere) {
    const TruthPicture truth = truth_picture({}, Image<Rgb>({2, 1}, Rgb(5, 1, 0.5f)));
    EXPECT_DOUBLE_EQ(rmse_within_white(truth, Image<Rgb>({2, 1}, Rgb(1, 2, 0.5f))), 0);
    EXPECT_DOUBLE_EQ(rmse_within_white(truth, Image<Rgb>({2, 1}, Rgb(1, 1, 0.25f))),
                     std::sqrt(0.25 * 0.25 / 3));
}

TEST(Lab, ComparesSamplesWithATruthOfTheirOwnAndEverythingWithThatTruthToo) {
    const SceneReport report = lab_of(off);
    const LabSeries& series = report.series.back();
    EXPECT_TRUE(series.by_samples);
    EXPECT_EQ(series.truth, report.converged);
    ASSERT_EQ(series.points.size(), 4u);
    EXPECT_EQ(series.setting(series.points[3]), "spp=8");
    EXPECT_GT(series.points[1].errors.rmse, series.points[3].errors.rmse);
    EXPECT_GT(series.points[3].errors.rmse, 0);
    EXPECT_EQ(series.points[1].converged->rmse, series.points[1].errors.rmse);
    const LabPoint& exact = report.series[0].points[2];
    ASSERT_TRUE(exact.converged);
    EXPECT_GT(exact.converged->rmse, 0);  // the baseline's frame is not the converged one
    EXPECT_LT(exact.converged->rmse, report.series[0].points[0].converged->rmse);
}

TEST(Lab, ComparesWhatShowsAWholeLensWithManySamplesOfIt) {
    TechniqueInfo info = off;
    info.whole_lens = true;
    const SceneReport with_lens = lab_of(info, small(), "", true);
    const LabSeries& series = with_lens.series[0];
    EXPECT_EQ(series.truth, with_lens.converged);
    EXPECT_EQ(series.points[0].errors.rmse, series.points[0].converged->rmse);
    EXPECT_THAT(verdicts(with_lens)[0], ::testing::HasSubstr(" against noisy, "));
    EXPECT_EQ(lab_of(info).series[0].truth, "noisy, 1 sample a pixel") << "there is no lens";
    EXPECT_EQ(lab_of(off, small(), "", true).series[0].truth, "noisy, 1 sample a pixel");
}

TEST(Lab, MeasuresATechniqueAgainstATruthOfItsOwnMaking) {
    TechniqueInfo info = off;
    info.approximates = false;
    info.truth = "error=0.5";
    const SceneReport report = lab_of(info);
    const LabSeries& series = report.series[0];
    EXPECT_EQ(series.truth, std::string(info.name) + " error=0.5");
    EXPECT_EQ(report.truth(series.truth)->standard_error, 0);  // nothing is random
    EXPECT_EQ(series.points[0].errors.rmse, 0);
    EXPECT_GT(series.points[2].errors.rmse, 0);
    // The baseline is what the last setting shows, and no better.
    ASSERT_TRUE(report.truth(series.truth)->baseline);
    EXPECT_EQ(report.truth(series.truth)->baseline->rmse, series.points[2].errors.rmse);
    const auto planes = planes_of(report, find_metric("rmse"));
    const auto own = std::ranges::find(planes, series.truth, &ErrorPlane::truth);
    ASSERT_NE(own, planes.end());
    EXPECT_EQ(own->points.back().series, nullptr);
    EXPECT_EQ(own->points.back().at.error, series.points[2].errors.rmse);
}

TEST(Lab, KnowsTheErrorOfATruthThatATechniqueMakesByChance) {
    TechniqueInfo info{"chance", "by chance", "", create<ByChance>, {}};
    info.approximates = false;
    info.truth = "error=0";
    const SceneReport report = lab_of(info);
    const LabTruth* truth = report.truth("chance error=0");
    ASSERT_NE(truth, nullptr);
    EXPECT_GT(truth->standard_error, 0);
    EXPECT_FALSE(truth->exact);
}

TEST(Lab, MakesTheTruthBetterUntilItIsGoodEnoughAndSaysHowGoodItIs) {
    const SceneReport report = lab_of(off);
    const LabTruth* truth = report.truth(report.converged);
    ASSERT_NE(truth, nullptr);
    // One sample happens to be exact, so that no number of samples is enough: 32 · 8 are the end.
    EXPECT_EQ(truth->samples, 256);
    // Uniform in 0..½: σ = ½/√12; the mean of 256, through the slope of the sRGB curve at ¼.
    const double slope = (srgb_encoded(0.251f) - srgb_encoded(0.249f)) / 0.002;
    EXPECT_NEAR(truth->standard_error, slope * 0.5 / std::sqrt(12.0 * 256), 2e-3);
    EXPECT_FALSE(truth->good_to(4.9 * truth->standard_error));
    EXPECT_TRUE(truth->good_to(5.1 * truth->standard_error));
}

TEST(Lab, FindsTheSlopeOfSamplesAndOfIndependentFrames) {
    LabOptions options = small();
    options.most_spp = 32;
    const SceneReport report = lab_of(off, options);
    const auto slope = slope_of(report.series.back());
    ASSERT_TRUE(slope);
    EXPECT_NEAR(slope->fit.slope, -0.5, 0.05);
    EXPECT_EQ(slope->fit.points, 5);
    EXPECT_FALSE(slope->differs());
    const auto passes = passes_slope(report.series.back());
    ASSERT_TRUE(passes);
    EXPECT_NEAR(passes->fit.slope, -0.5, 0.05);
}

TEST(Lab, TimesTheBaselineBesideEveryPointAndWhatIsLeftOut) {
    const SceneReport report = lab_of(off);
    const LabPoint& point = report.series[0].points[0];
    EXPECT_GT(point.beside_ms, 0);
    EXPECT_EQ(report.speedup(point), point.beside_ms / point.frame_ms);
    EXPECT_FALSE(report.series[0].left_out);  // it leaves nothing out
    ASSERT_TRUE(report.series[1].left_out);
    EXPECT_GT(report.series[1].left_out->forced_ms, 0);
    EXPECT_EQ(report.series[1].left_out->setting, "spp=1");
}

TEST(Lab, SaysWhyAPlanDoesNotApply) {
    const SceneReport report = lab_of({"idle", "", "", create<DoesNotApply>, {}});
    const LabPoint& point = report.series[0].points.at(0);
    EXPECT_FALSE(point.ran());
    EXPECT_EQ(point.not_run, "does not apply: no lights");
}

TEST(Lab, GoesOnWhenATechniqueFails) {
    const SceneReport report = lab_of({"bad", "", "", create<Throws>, {}});
    EXPECT_EQ(report.series[0].points.at(0).not_run, "failed: a hole in it");
    EXPECT_TRUE(report.series.back().points.at(0).ran());
}

TEST(Lab, FlagsPixelsThatAreNotFinite) {
    const SceneReport report = lab_of({"nan", "", "", create<NotFinite>, {}});
    const LabPoint& point = report.series[0].points.at(0);
    EXPECT_EQ(point.errors.non_finite.count, 1u);
    EXPECT_EQ(point.errors.non_finite.first_x, 2);
    EXPECT_FALSE(point.identical);
}

TEST(Lab, RefusesABaselineThatDoesNotApply) {
    const OwnStudio studio(testing::one_triangle(), 1);
    const Budget budget;
    const LabScene in{"tiny", studio.studio(), shot_of(studio.scene()), budget, ""};
    EXPECT_THAT(
        [&] {
            run_lab(in, {"idle", "", "", create<DoesNotApply>, {}}, {});
        },
        ::testing::ThrowsMessage<Error>(::testing::HasSubstr("no lights")));
}

TEST(Lab, TellsHowFarItIsAndNeverGoesBack) {
    LabOptions options = small();
    std::vector<LabStep> steps;
    options.on_step = [&](const LabStep& step) { steps.push_back(step); };
    lab_of(off, options);
    ASSERT_GE(steps.size(), 10u);
    EXPECT_EQ(steps[0].begun, 0);
    EXPECT_THAT(steps, ::testing::Contains(::testing::Field(&LabStep::what, "off error=0.5")));
    for (std::size_t i = 1; i < steps.size(); ++i) EXPECT_GE(steps[i].begun, steps[i - 1].begun);
    EXPECT_LT(steps.back().begun, 1);
}

TEST(Lab, WritesPicturesAndAPageThatHoldsThem) {
    LabOptions options = small();
    const auto folder = own_folder();
    options.pictures = folder / "pictures";
    LabReport report;
    report.scenes.push_back(lab_of(off, options));
    write_report(report, folder);
    for (const char* file : {"report.csv", "report.json", "report.html", "tiny.svg",
                             "pictures/tiny-off-error=0.5.png", "pictures/tiny-noisy-truth.png"}) {
        EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
    }
    // The baseline; best, which is exact; worst, where it differs and what is seen of that; the
    // truth of the samples, the best and the worst of them, and both maps of each.
    EXPECT_EQ(testing::occurrences(report_html(report), "data:image/png;base64,iVBOR"), 12u);
    std::filesystem::remove_all(folder);
}

/// What an interruption looks like from within.
struct Interrupted {};

TEST(Lab, GoesOnWhereItWasInterruptedAndReportsTheSame) {
    const auto folder = own_folder();
    LabOptions options = small();
    options.journal = Store(folder);
    const SceneReport whole = lab_of(off, small(), "scene");
    int steps = 0;
    options.on_step = [&](const LabStep&) {
        if (++steps == 6) throw Interrupted{};
    };
    EXPECT_THROW(lab_of(off, options, "scene"), Interrupted);
    options.on_step = nullptr;
    EXPECT_EQ(lab_of(off, options, "another scene").resumed, 0);
    const SceneReport resumed = lab_of(off, options, "scene");
    EXPECT_EQ(resumed.resumed, 5);
    ASSERT_EQ(resumed.series.size(), whole.series.size());
    for (std::size_t i = 0; i < whole.series.size(); ++i) {
        const auto &a = whole.series[i].points, &b = resumed.series[i].points;
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t k = 0; k < a.size(); ++k) {
            EXPECT_EQ(a[k].errors.rmse, b[k].errors.rmse);
            EXPECT_EQ(a[k].linear_rmse, b[k].linear_rmse);
            EXPECT_EQ(a[k].identical, b[k].identical);
            EXPECT_EQ(a[k].counts.rays, b[k].counts.rays);
            EXPECT_EQ(a[k].frames, b[k].frames);
            EXPECT_EQ(a[k].plan.stages.size(), b[k].plan.stages.size());
        }
        EXPECT_EQ(whole.series[i].passes.linear_rmse, resumed.series[i].passes.linear_rmse);
    }
    options.measured_by = "another program";
    EXPECT_EQ(lab_of(off, options, "scene").resumed, 0);
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace luch
