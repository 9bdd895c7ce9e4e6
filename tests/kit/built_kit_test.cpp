// The students' kit as a student has it, built alone. It is at LUCH_KIT; ctest sees to that.
#include "framework/base/files.h"
#include "framework/image/io.h"
#include "tests/testing/shell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace luch {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

const fs::path kit = LUCH_KIT;
const fs::path root = LUCH_SOURCE_DIR;
const std::string skeleton = read_text(root / "homework/vista/steps.cpp");
const std::string balls = "homework/vista/scenes/balls.scene";

void replace(std::string& text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
}

/// The reference steps as a student would hand them in.
std::string solution() {
    std::string text = read_text(root / "techniques/vista/tessellate.cpp") +
                       read_text(root / "techniques/vista/steps.cpp");
    for (int file = 0; file < 2; ++file) {
        replace(text, "namespace luch::techniques::vista {",
                "namespace luch::homework::vista {\nusing namespace techniques::vista;");
    }
    replace(text, "Steps reference() {", "Steps steps() {");
    const std::size_t describe = skeleton.find("TechniqueInfo describe() {");
    return "#include \"framework/technique/catalogue.h\"\n#include "
           "\"framework/technique/todo.h\"\n" +
           text + "namespace luch::homework::vista {\n" + skeleton.substr(describe);
}

class BuiltKit : public ::testing::Test {
 protected:
    ~BuiltKit() override {
        if (written_) write_text(kit / "homework/vista/steps.cpp", skeleton);
    }

    void write_steps(const std::string& text) {
        written_ = true;
        write_text(kit / "homework/vista/steps.cpp", text);
        const Ran built = in_kit("cmake --build --preset release --target luch");
        ASSERT_EQ(built.status, 0) << built.text;
    }

    static Ran in_kit(const std::string& command) {
        return shell("cd '" + kit.string() + "' && " + command);
    }
    static Ran luch(const std::string& arguments) {
        return in_kit("build/release/luch " + arguments);
    }
    /// A picture that a program makes of a scene.
    static Image<Rgb> picture(const std::string& program, const std::string& technique,
                              const std::string& scene) {
        const std::string out = (kit / "out/picture.exr").string();
        const Ran ran = in_kit(program + " render " + scene + " -t " + technique + " -o " + out);
        EXPECT_EQ(ran.status, 0) << ran.text;
        return read_picture(out).pixels;
    }

 private:
    bool written_ = false;
};

TEST_F(BuiltKit, ScoresItsFloor) {
    in_kit("cmake --build --preset release");
    const Ran ran = luch("check vista");
    EXPECT_EQ(ran.status, 1);
    for (const char* task : {"t1", "t2", "t3", "t4", "t5", "t6", "t7"}) {
        EXPECT_THAT(ran.text, HasSubstr(std::string("NOT ATTEMPTED vista.") + task + "  0/"));
    }
    EXPECT_THAT(ran.text, HasSubstr("0 of 28 points"));
}

TEST_F(BuiltKit, ShowsWhatIsThereBeforeAnythingIsWritten) {
    in_kit("cmake --build --preset release");
    const Ran compared = luch("compare baseline homework/vista " + balls);
    EXPECT_EQ(compared.status, 0) << compared.text;
    EXPECT_THAT(compared.text, HasSubstr("homework/vista: vista.t7 is still to be written"));
    const Ran seen = luch(
        "view scenes/spheres/spheres.scene -t homework/vista --frames 1 "
        "--size 64x48 --screenshot out/view.png");
    EXPECT_EQ(seen.status, 0) << seen.text;
    EXPECT_EQ(read_picture(kit / "out/view.png").pixels.size(), Size(64, 48));
    const Ran listed = in_kit("./run list");
    EXPECT_THAT(listed.text, HasSubstr("\nhomework/vista "));
    EXPECT_THAT(listed.text, Not(HasSubstr("\nvista ")));
    EXPECT_EQ(luch("kit out/kit").status, 2) << "a kit makes no kits";
}

TEST_F(BuiltKit, GivesAllPointsToASolutionAndMakesTheReferencesPicture) {
    write_steps(solution());
    const Ran ran = luch("check vista");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_THAT(ran.text, HasSubstr("28 of 28 points"));
    for (const std::string& scene :
         {balls, std::string("scenes/spheres/spheres.scene --size 80x60")}) {
        EXPECT_EQ(picture("build/release/luch", "homework/vista", scene),
                  picture("'" LUCH_PROGRAM "'", "'vista' -p mode=classic", scene))
            << scene;
    }
}

TEST_F(BuiltKit, PutsStoredOutputsInThePlaceOfAStepThatIsNotWritten) {
    write_steps(solution());
    const std::string eight = "homework/vista -p segments=8";  // as the stored ones are
    const Image<Rgb> whole = picture("build/release/luch", eight, balls);
    std::string hole = solution();
    replace(hole, "project, rasterise, look_up};",
            "project,\n[](std::span<const ScreenTri>, Tile, Hidden, ImageView<NodeId>, "
            "ImageView<float>) { LUCH_TODO(\"vista.t6\"); }, look_up};");
    replace(hole, "void rasterise(", "[[maybe_unused]] void rasterise(");
    write_steps(hole);
    const Image<Rgb> patched = picture("build/release/luch", eight, balls);
    std::size_t differ = 0;
    for (std::size_t i = 0; i < whole.pixels().size(); ++i) {
        differ += whole.pixels()[i] != patched.pixels()[i] ? 1 : 0;
    }
    EXPECT_LT(differ, whole.pixels().size() / 1000);
    EXPECT_THAT(luch("render " + balls + " -t homework/vista -o out/a.png").text,
                HasSubstr("vista.t6 is still to be written"));

    // Elsewhere nobody knows: two greys, in stripes.
    const Image<Rgb> hatched = picture("build/release/luch", "homework/vista",
                                       "scenes/spheres/spheres.scene --size 64x48");
    std::vector<float> greys;
    for (const Rgb& pixel : hatched.pixels()) {
        EXPECT_EQ(pixel.x, pixel.z);
        if (std::ranges::find(greys, pixel.x) == greys.end()) greys.push_back(pixel.x);
    }
    EXPECT_EQ(greys.size(), 2u);
}

}  // namespace
}  // namespace luch
