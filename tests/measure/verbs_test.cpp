#include "framework/base/files.h"
#include "framework/image/io.h"
#include "framework/measure/magma.h"
#include "tests/testing/own_folder.h"
#include "tests/testing/shell.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace luch {
namespace {

using ::testing::HasSubstr;

/// Runs the program in a folder that holds grey.png, lighter.png, wide.png and broken.exr.
class CompareVerb : public ::testing::Test {
 protected:
    CompareVerb() {
        write_picture(folder_ / "grey.png", Image<Rgb>({4, 4}, Rgb(0.2f)).view());
        write_picture(folder_ / "lighter.png", Image<Rgb>({4, 4}, Rgb(0.3f)).view());
        write_picture(folder_ / "wide.png", Image<Rgb>({5, 4}, Rgb(0.3f)).view());
        Image<Rgb> broken({4, 4}, Rgb(0.2f));
        broken(3, 2) = Rgb(std::numeric_limits<float>::quiet_NaN());
        write_picture(folder_ / "broken.exr", broken.view());
    }
    ~CompareVerb() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] Ran luch_compare(const std::string& arguments) const {
        return shell("cd '" + folder_.string() + "' && '" LUCH_PROGRAM "' compare " + arguments);
    }

    std::filesystem::path folder_ = own_folder();
};

TEST_F(CompareVerb, EndsWithZeroForAComparisonWithoutALimit) {
    const Ran ran = luch_compare("grey.png lighter.png");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_THAT(ran.text, HasSubstr("as displayed (sRGB"));
    EXPECT_THAT(ran.text, HasSubstr("16 of 16 pixels differ"));
}

TEST_F(CompareVerb, ComparesAsIsAskedFor) {
    EXPECT_THAT(luch_compare("broken.exr broken.exr").text, HasSubstr("in linear light"));
    EXPECT_THAT(luch_compare("broken.exr broken.exr --displayed").text,
                HasSubstr("as displayed (sRGB"));
    EXPECT_THAT(luch_compare("grey.png lighter.png --linear").text, HasSubstr("in linear light"));
    EXPECT_EQ(luch_compare("grey.png lighter.png --linear --displayed").status, 2);
}

TEST_F(CompareVerb, SetsParametersOfWhatIsCompared) {
    const std::string scene = " '" LUCH_SOURCE_DIR "/scenes/clay/clay.scene' --size 24x18 --spp 1";
    const Ran same = luch_compare("ldr ldr -p levels=256" + scene);
    EXPECT_THAT(same.text, HasSubstr("ldr levels=256"));
    EXPECT_THAT(same.text, ::testing::Not(HasSubstr("pixels differ")));
    EXPECT_THAT(luch_compare("ldr ldr -p levels=16" + scene).text, HasSubstr("pixels differ"));
    const Ran wrong = luch_compare("ldr ldr -p level=4" + scene);
    EXPECT_EQ(wrong.status, 2);
    EXPECT_THAT(wrong.text, HasSubstr("levels"));
    const Ran picture = luch_compare("grey.png lighter.png -p levels=4");
    EXPECT_EQ(picture.status, 2);
    EXPECT_THAT(picture.text, HasSubstr("lighter.png is no technique"));
}

TEST_F(CompareVerb, EndsWithOneWhenALimitIsExceededAndOnlyThen) {
    EXPECT_EQ(luch_compare("grey.png lighter.png --fail-above rmse=0.5").status, 0);
    const Ran ran =
        luch_compare("grey.png lighter.png --fail-above rmse=0.5 --fail-above max=0.01");
    EXPECT_EQ(ran.status, 1);
    EXPECT_THAT(ran.text, HasSubstr("FAILED: max"));
    EXPECT_EQ(luch_compare("grey.png lighter.png --fail-below psnr=90").status, 1);
}

TEST_F(CompareVerb, LimitsEveryMetric) {
    const std::string names[] = {"rmse", "relmse", "flip", "mae", "max", "p999", "foveal_rmse"};
    std::string wide = "grey.png lighter.png --gaze 2,2 --fail-below ssim=0.5", narrow = wide;
    for (const std::string& name : names) wide += " --fail-above " + name + "=9";
    for (const std::string& name : names) narrow += " --fail-above " + name + "=1e-6";
    EXPECT_EQ(luch_compare(wide).status, 0);
    const Ran ran = luch_compare(narrow + " --fail-below ssim=0.9999");
    EXPECT_EQ(ran.status, 1);
    for (const std::string& name : names) EXPECT_THAT(ran.text, HasSubstr("FAILED: " + name));
    EXPECT_THAT(ran.text, HasSubstr("FAILED: ssim"));
}

TEST_F(CompareVerb, EndsWithOneForAPixelThatIsNotFinite) {
    for (const char* pair : {"grey.png broken.exr", "broken.exr broken.exr"}) {
        const Ran ran = luch_compare(pair + std::string(" --json o.json --flip-map flip.png"));
        EXPECT_EQ(ran.status, 1);
        EXPECT_THAT(ran.text, HasSubstr("1 pixels are not finite, the first at (3, 2)"));
        const std::string json = read_text(folder_ / "o.json");
        EXPECT_THAT(json, HasSubstr("\"non_finite\": 1"));
        EXPECT_THAT(json, ::testing::ContainsRegex("non_finite_at\": \\[[ \n]*3,[ \n]*2"));
        EXPECT_EQ(read_picture(folder_ / "flip.png").pixels(3, 2), Rgb(0, 1, 0));
    }
}

TEST_F(CompareVerb, TakesHdrFlipForLightAndLdrFlipForWhatIsDisplayed) {
    write_picture(folder_ / "one.exr", Image<Rgb>({4, 4}, Rgb(1)).view());
    write_picture(folder_ / "two.exr", Image<Rgb>({4, 4}, Rgb(2)).view());
    EXPECT_EQ(luch_compare("one.exr two.exr --json o.json --flip-map flip.png").status, 0);
    EXPECT_THAT(read_text(folder_ / "o.json"), HasSubstr("\"flip_kind\": \"hdr\""));
    EXPECT_EQ(read_picture(folder_ / "flip.png").pixels(1, 1), magma(0.1447528f));
    EXPECT_EQ(luch_compare("one.exr two.exr --displayed --json o.json").status, 0);
    EXPECT_THAT(read_text(folder_ / "o.json"), HasSubstr("\"flip_kind\": \"ldr\""));
    EXPECT_THAT(read_text(folder_ / "o.json"), HasSubstr("\"flip\": 0.0,"));
}

TEST_F(CompareVerb, ExplainsAMistakeAndEndsWithTwo) {
    const auto expect = [&](const std::string& arguments, const std::string& word) {
        const Ran ran = luch_compare(arguments);
        EXPECT_EQ(ran.status, 2) << arguments;
        EXPECT_THAT(ran.text, HasSubstr(word)) << arguments;
    };
    expect("grey.png wide.png", "4x4 and 5x4");
    expect("grey.png missing.png", "missing.png");
    expect("grey.png baselin", "baseline");
    expect("grey.png baseline", "name a scene");
    expect("grey.png lighter.png x.scene", "two pictures need no scene");
    expect("grey.png lighter.png --fail-above rsme=1", "rmse");
    expect("grey.png lighter.png --fail-above rmse", "METRIC=NUMBER");
    expect("grey.png lighter.png --fail-above psnr=40", "--fail-below psnr=40");
    expect("grey.png lighter.png --amplify -1", "--amplify");
    expect("grey.png lighter.png --gaze 3", "X,Y in pixels");
    expect("grey.png lighter.png --gaze 1,2,3", "X,Y in pixels");
    expect("grey.png lighter.png --fail-above ssim=0.9", "--fail-below ssim=0.9");
    expect("grey.png lighter.png --fail-above misclassified=0", "black and white");
    expect("grey.png lighter.png --fail-above foveal_rmse=0", "--gaze X,Y");
}

TEST_F(CompareVerb, WritesTheDifferenceAndJson) {
    const Ran ran =
        luch_compare("grey.png lighter.png --difference off.png --amplify 2 --json o.json");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_THAT(ran.text, HasSubstr("2 × amplified"));
    const float off = 2 * (byte_of(srgb_encoded(0.3f)) - byte_of(srgb_encoded(0.2f))) / 255.0f;
    EXPECT_NEAR(read_picture(folder_ / "off.png").pixels(1, 1).r, off, 1e-6);
    const std::string json = read_text(folder_ / "o.json");
    for (const char* key :
         {"rmse", "relmse", "psnr", "ssim", "flip", "mae", "max", "p999", "non_finite"}) {
        EXPECT_THAT(json, HasSubstr(fmt::format("\"{}\": ", key)));
    }
}

TEST(LabVerb, ExplainsAMistakeAndEndsWithTwo) {
    const Ran spp = shell("'" LUCH_PROGRAM "' lab x.scene --spp 4");
    EXPECT_EQ(spp.status, 2);
    EXPECT_THAT(spp.text, HasSubstr("leave it out"));
    const Ran name = shell("'" LUCH_PROGRAM "' lab x.scene -t baselin");
    EXPECT_EQ(name.status, 2);
    EXPECT_THAT(name.text, HasSubstr("baseline"));
}

TEST(LabVerb, RefusesAYardstickThatIsNone) {
    const auto expect = [](const std::string& at, const std::string& word) {
        const Ran ran = shell("'" LUCH_PROGRAM "' lab x.scene --at " + at);
        EXPECT_EQ(ran.status, 2) << at;
        EXPECT_THAT(ran.text, HasSubstr(word)) << at;
    };
    expect("rmse", "METRIC=ERROR");
    expect("rmse=0", "above 0");
    expect("rsme=1", "rmse");
    expect("psnr=30", "rises with quality");
}

/// A lab over the page's scene, small, killed for good once `measurements` files lie in the
/// journal; the status of the killed shell command is of no interest.
std::string killed_after(int measurements, const std::string& command, const std::string& out) {
    return fmt::format(
        "{} > /dev/null 2>&1 & lab=$!; for i in $(seq 2000); do "
        "n=$(ls '{}/journal' 2>/dev/null | grep -c 'luch$'); "
        "[ \"$n\" -ge {} ] && break; kill -0 $lab 2>/dev/null || break; "
        "sleep 0.01; done; kill -9 $lab; wait $lab; echo killed with $?",
        command, out, measurements);
}

TEST(LabVerb, GoesOnAfterItWasKilled) {
    const std::filesystem::path folder = own_folder();
    const std::string scene = LUCH_SOURCE_DIR "/scenes/page/page.scene";
    const auto lab = [&](const std::string& out) {
        return fmt::format(
            "'{}' lab '{}' -t vista --quick --size 96x72 --cache '{}/cache' --out '{}'",
            LUCH_PROGRAM, scene, folder.string(), (folder / out).string());
    };
    const Ran killed = shell(killed_after(1, lab("killed"), (folder / "killed").string()));
    ASSERT_THAT(killed.text, HasSubstr("killed with 137"));
    EXPECT_FALSE(std::filesystem::exists(folder / "killed" / "report.json"));
    const Ran resumed = shell(lab("killed"));
    EXPECT_EQ(resumed.status, 0) << resumed.text;
    EXPECT_THAT(resumed.text, HasSubstr("taken over from an interrupted run"));
    EXPECT_FALSE(std::filesystem::exists(folder / "killed" / "journal"));
    ASSERT_EQ(shell(lab("whole")).status, 0);
    // All but times is the same: every error and every count. (The truth's name has a comma.)
    const auto csv = [&](const char* out) {
        return shell("tail -n +2 '" + (folder / out / "report.csv").string() +
                     "' | cut -d, -f1-9,13,15-")
            .text;
    };
    EXPECT_EQ(csv("killed"), csv("whole"));
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace luch
