#include "framework/measure/lab.h"

#include "framework/base/error.h"
#include "framework/technique/context.h"
#include "tests/measure/samples.h"
#include "tests/testing/scenes.h"

#include <gmock/gmock.h>

#include <array>
#include <limits>

namespace luch {
namespace {

using testing::OwnStudio;

/// Grey everywhere; off by `error` at one sample a pixel, and by 1/spp more with several.
class Grey : public Technique {
 public:
    void visit(ParamVisitor& visitor) override {
        visitor.visit({"error", "", "how far off"}, error_, 0, 1);
    }
    Plan plan(const Scene&, const Shot&) const override { return {}; }
    void render(const Scene&, const Shot& shot, Frame& frame, Context& context) override {
        const double noise = shot.spp > 1 ? 1.0 / shot.spp : 0;
        frame.colour = Image<Rgb>(shot.size, Rgb(static_cast<float>(0.25 + error_ + noise)));
        context.tracer(0).counts().of(RayKind::primary) += shot.size.area();
    }

 private:
    double error_ = 0;
};

class NotFinite final : public Grey {
 public:
    void render(const Scene& scene, const Shot& shot, Frame& frame, Context& context) override {
        Grey::render(scene, shot, frame, context);
        frame.colour(2, 1) = Rgb(std::numeric_limits<float>::quiet_NaN());
    }
};

class DoesNotApply final : public Grey {
 public:
    Plan plan(const Scene&, const Shot&) const override {
        return {.applies = false, .why = "no lights", .stages = {}};
    }
};

class Throws final : public Grey {
 public:
    void render(const Scene&, const Shot&, Frame&, Context&) override {
        throw Error("a hole in it");
    }
};

template <class T>
std::unique_ptr<Technique> create() {
    return std::make_unique<T>();
}

constexpr std::array<double, 3> errors{0.5, 0.25, 0};
const TechniqueInfo grey{"grey", "grey", "", create<Grey>, {}};
const TechniqueInfo swept{"swept", "swept", "", create<Grey>, {"error", errors}};

SceneReport lab_of(const TechniqueInfo& info, LabOptions options = LabOptions::quick()) {
    Scene scene = testing::one_triangle();
    scene.settings.frame = {8, 4};
    const OwnStudio studio(std::move(scene), 1);
    const LabScene in{"tiny", studio.studio(), shot_of(studio.scene()), {}};
    const std::array<const TechniqueInfo*, 1> techniques{&info};
    return run_lab(in, grey, techniques, options);
}

TEST(Lab, WalksATechniqueAlongItsSweepAgainstTheBaseline) {
    const SceneReport report = lab_of(swept);
    ASSERT_EQ(report.series.size(), 2u);
    const LabSeries& series = report.series[0];
    EXPECT_EQ(series.parameter, "error");
    EXPECT_EQ(series.truth, "grey, 1 sample a pixel");
    ASSERT_EQ(series.points.size(), 3u);
    EXPECT_GT(series.points[0].errors.rmse, series.points[1].errors.rmse);
    EXPECT_GT(series.points[1].errors.rmse, 0);
    EXPECT_EQ(series.points[2].errors.rmse, 0);
    EXPECT_TRUE(series.points[2].identical);
    EXPECT_FALSE(series.points[1].identical);
    EXPECT_EQ(series.points[0].counts.of(RayKind::primary), 32u);
}

TEST(Lab, MeasuresErrorsAsDisplayed) {
    const SceneReport report = lab_of(swept);
    const double expected = srgb_encoded(0.75f) - srgb_encoded(0.25f);
    EXPECT_NEAR(report.series[0].points[0].errors.rmse, expected, 1e-6);
}

TEST(Lab, ComparesTheBaselinesSamplesWithATruthOfTheirOwn) {
    LabOptions options;
    options.spp = {1, 4, 16};
    options.repeat = {0, 1};
    const SceneReport report = lab_of(grey, options);
    const LabSeries& series = report.series.back();
    EXPECT_TRUE(series.by_samples);
    EXPECT_EQ(series.truth, "grey, 64 samples a pixel, seed 1");
    ASSERT_EQ(series.points.size(), 3u);
    EXPECT_EQ(series.setting(series.points[1]), "spp=4");
    EXPECT_GT(series.points[1].errors.rmse, series.points[2].errors.rmse);
    EXPECT_GT(series.points[2].errors.rmse, 0);
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
    const LabScene in{"tiny", studio.studio(), shot_of(studio.scene()), {}};
    EXPECT_THAT(
        [&] {
            run_lab(in, {"idle", "", "", create<DoesNotApply>, {}}, {});
        },
        ::testing::ThrowsMessage<Error>(::testing::HasSubstr("no lights")));
}

TEST(Lab, TellsHowFarItIsAndNeverGoesBack) {
    LabOptions options = LabOptions::quick();
    std::vector<LabStep> steps;
    options.on_step = [&](const LabStep& step) { steps.push_back(step); };
    lab_of(swept, options);
    ASSERT_EQ(steps.size(), 6u);
    EXPECT_EQ(steps[0].begun, 0);
    EXPECT_EQ(steps[1].what, "swept error=0.5");
    for (std::size_t i = 1; i < steps.size(); ++i) EXPECT_GT(steps[i].begun, steps[i - 1].begun);
    EXPECT_LT(steps.back().begun, 1);
}

TEST(Lab, WritesPicturesAndAPageThatHoldsThem) {
    LabOptions options = LabOptions::quick();
    const auto folder = testing::empty_folder("lab");
    options.pictures = folder / "pictures";
    LabReport report;
    report.scenes.push_back(lab_of(swept, options));
    write_report(report, folder);
    for (const char* file : {"report.csv", "report.json", "report.html", "tiny.svg",
                             "pictures/tiny-swept-error=0.5.png"}) {
        EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
    }
    // The baseline; best, which is exact; worst and where it differs.
    EXPECT_EQ(testing::occurrences(report_html(report), "data:image/png;base64,iVBOR"), 4u);
}

}  // namespace
}  // namespace luch
