#include "framework/measure/reference.h"

#include "framework/base/error.h"
#include "framework/base/files.h"
#include "tests/measure/toys.h"
#include "tests/testing/own_folder.h"
#include "tests/testing/scenes.h"

#include <gmock/gmock.h>

namespace luch {
namespace {

namespace fs = std::filesystem;
using testing::noisy;
using testing::toy_frames;

/// A studio for toys, and a folder for references.
class References : public ::testing::Test {
 protected:
    ~References() override { fs::remove_all(folder_); }

    static Shot small_shot() {
        Shot shot;
        shot.size = {24, 16};
        return shot;
    }
    /// Frames that making a reference took.
    int frames_for(const std::string& content, int samples = 64,
                   const Subject& subject = {&noisy}) {
        const int before = toy_frames;
        const ReferenceCache cache(Store(folder_), content);
        last_ = cache.reference(subject, bench_, samples);
        return toy_frames - before;
    }

    fs::path folder_ = own_folder();
    testing::OwnStudio own_{testing::one_triangle(), 1};
    Studio studio_ = own_.studio();
    Shot shot_ = small_shot();
    Budget budget_;
    Workbench bench_{studio_, shot_, budget_};
    Reference last_;
};

TEST_F(References, AreMadeOnceAndKnownByTheirContent) {
    EXPECT_EQ(frames_for("scene"), 4);  // two halves, and what each looks like with two samples
    EXPECT_FALSE(last_.from_cache);
    const Reference made = last_;
    EXPECT_EQ(frames_for("scene"), 2);
    EXPECT_TRUE(last_.from_cache);
    EXPECT_EQ(last_.linear, made.linear);
    EXPECT_EQ(last_.displayed_error, made.displayed_error);
}

TEST_F(References, AreAnewForAnotherSceneSettingSeedOrSize) {
    ASSERT_EQ(frames_for("scene"), 4);
    EXPECT_EQ(frames_for("scene, changed"), 4);
    EXPECT_EQ(frames_for("scene", 128), 4);
    EXPECT_EQ(frames_for("scene", 64, {&noisy, "", 1, false}), 4);
    shot_.seed = 7;
    EXPECT_EQ(frames_for("scene"), 4);
    shot_.seed = 0;
    shot_.size = {16, 24};
    EXPECT_EQ(frames_for("scene"), 4);
    shot_.size = {24, 16};
    EXPECT_EQ(frames_for("scene"), 2);
}

/// The same technique by name, with other pixels: a program that was changed.
class Brighter final : public testing::Noisy {
 public:
    void render(const Scene& scene, const Shot& shot, Frame& frame, Context& context) override {
        Noisy::render(scene, shot, frame, context);
        frame.colour(3, 3) *= 1.01f;
    }
};

TEST_F(References, AreAnewWhenTheProgramMakesOtherPictures) {
    ASSERT_EQ(frames_for("scene"), 4);
    TechniqueInfo changed = noisy;
    changed.create = testing::create<Brighter>;
    EXPECT_EQ(frames_for("scene", 64, {&changed}), 4);
}

TEST_F(References, AreMadeAnewWhenTheirFileIsDamaged) {
    ASSERT_EQ(frames_for("scene"), 4);
    const Reference made = last_;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
        std::string bytes = read_text(entry.path());
        bytes[bytes.size() / 2] ^= 4;
        write_text(entry.path(), bytes);
    }
    EXPECT_EQ(frames_for("scene"), 4);
    EXPECT_EQ(last_.linear, made.linear);
    EXPECT_EQ(frames_for("scene"), 2);
}

TEST_F(References, AreNotKeptWithoutContent) {
    EXPECT_EQ(frames_for(""), 2);
    EXPECT_EQ(frames_for(""), 2);
    EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(References, KnowTheirStandardErrorFromTheirHalves) {
    frames_for("scene", 64);
    // A sample is uniform in 0..½, so that the mean of 64 has a standard deviation of ½/√(12·64);
    // 384 pixels tell it to within some percent.
    EXPECT_NEAR(last_.linear_error, 0.5 / std::sqrt(12.0 * 64), 0.0025);
    double squared = 0;
    for (const Rgb& pixel : last_.linear.pixels()) squared += (pixel.r - 0.25) * (pixel.r - 0.25);
    EXPECT_NEAR(std::sqrt(squared / 384), last_.linear_error, 0.0025);
    EXPECT_EQ(last_.samples, 64);
}

TEST_F(References, SayWhyThereCanBeNone) {
    class Idle final : public testing::Noisy {
     public:
        Plan plan(const Scene&, const Shot&) const override { return {false, "no lights", {}}; }
    };
    TechniqueInfo idle = noisy;
    idle.create = testing::create<Idle>;
    EXPECT_THAT([&] { frames_for("scene", 64, {&idle}); },
                ::testing::ThrowsMessage<Error>("noisy does not apply: no lights"));
}

TEST_F(References, MeanOfIndependentFramesConvergesWithThePowerOfOneHalf) {
    const LabPasses passes =
        independent_passes({&noisy}, bench_, Image<Rgb>(shot_.size, Rgb(0.25f)), 32);
    EXPECT_THAT(passes.count, ::testing::ElementsAre(1, 2, 4, 8, 16, 32));
    for (std::size_t i = 0; i < passes.count.size(); ++i) {
        const double expected = 0.5 / std::sqrt(12 * 2 * passes.count[i]);
        EXPECT_NEAR(passes.linear_rmse[i] / expected, 1, 0.12) << i;
    }
    const std::optional<LabPasses> read = passes_of(bytes_of(passes));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->linear_rmse, passes.linear_rmse);
    EXPECT_FALSE(passes_of("{"));
}

}  // namespace
}  // namespace luch
