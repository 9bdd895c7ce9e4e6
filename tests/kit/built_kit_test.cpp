// The students' kit as a student has it, built alone. It is at LUCH_KIT; ctest sees to that.
#include "framework/base/files.h"
#include "framework/image/io.h"
#include "tests/testing/shell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace luch {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

const fs::path kit = LUCH_KIT;
const fs::path root = LUCH_SOURCE_DIR;

/// A homework of the kit.
struct Topic {
    std::string name;
    int tasks, points;
    /// What a student would have written, below techniques/NAME.
    std::vector<std::string> solution;
    /// What must read otherwise in one file with the rest: from, to.
    std::vector<std::pair<std::string, std::string>> changes;
    /// Arguments of the technique here and of the kit's, and scenes where both make one picture.
    std::string reference, yours;
    std::vector<std::string> scenes;
};

void PrintTo(const Topic& topic, std::ostream* out) {
    *out << topic.name;
}

const Topic layered{
    .name = "layered",
    .tasks = 5,
    .points = 22,
    .solution = {"confusion.cpp", "steps.cpp"},
    .changes = {},
    .reference = "-p mode=classic",
    .yours = "-p mode=classic",
    .scenes = {"homework/layered/scenes/posts.scene", "scenes/fence/fence.scene --size 80x60"}};

const Topic ldr{.name = "ldr",
                .tasks = 7,
                .points = 28,
                .solution = {"swar.h", "spans.h", "spans.cpp", "steps.cpp"},
                // One file instead of a kernel for each processor; and what is given is the kit's.
                .changes = {{"#define LUCH_NAME(", "#define LUCH_LEVEL plain\n#define LUCH_NAME("},
                            {"constexpr Spans spans{", "constexpr Spans loops{"},
                            {"return spans;", "return loops;"},
                            {"void gather(std", "[[maybe_unused]] void gather(std"},
                            {"void tint(std", "[[maybe_unused]] void tint(std"},
                            {"resolve, gather, tint}",
                             "resolve, techniques::ldr::reference().gather, "
                             "techniques::ldr::reference().tint}"}},
                .reference = "",
                .yours = "",
                .scenes = {"scenes/toys/toys.scene --size 80x60",
                           "scenes/toys/toys.scene --size 80x60 --spp 2 -p wide=off",
                           "homework/ldr/scenes/flat.scene --size 40x30 --spp 3"}};

const Topic shadow_map{
    .name = "shadow_map",
    .tasks = 7,
    .points = 28,
    .solution = {"cube.h", "cube.cpp", "steps.cpp"},
    .changes = {},
    // The lecture's maps, without what makes them quick or exact.
    .reference = "-p fit=off -p offset=off -p points=4 -p side=64",
    .yours = "-p points=4 -p side=64",
    .scenes = {"homework/shadow_map/scenes/columns.scene",
               "homework/shadow_map/scenes/stack.scene --size 80x60 -p pcf=off"}};

const Topic ssao{
    .name = "ssao",
    .tasks = 7,
    .points = 32,
    .solution = {"steps.cpp"},
    .changes = {},
    .reference = "-p mode=classic -p normals=picture",
    .yours = "",
    .scenes = {"homework/ssao/scenes/balls.scene", "scenes/clay/clay.scene --size 80x60",
               "scenes/toys/toys.scene --size 80x60 -p half=on"}};

const Topic vista{
    .name = "vista",
    .tasks = 7,
    .points = 28,
    .solution = {"tessellate.cpp", "steps.cpp"},
    .changes = {},
    .reference = "-p mode=classic",
    .yours = "",
    .scenes = {"homework/vista/scenes/balls.scene", "scenes/spheres/spheres.scene --size 80x60"}};

const std::string balls = vista.scenes[0], posts = layered.scenes[0];

std::string homework(const Topic& topic) {
    return "homework/" + topic.name;
}

std::string skeleton(const Topic& topic) {
    return read_text(root / homework(topic) / "steps.cpp");
}

void replace(std::string& text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
}

/// The reference steps as a student would hand them in.
std::string solution(const Topic& topic) {
    std::string text, given = skeleton(topic);
    std::istringstream includes(given);
    for (std::string line; std::getline(includes, line);) {
        if (line.starts_with("#include")) text += line + "\n";
    }
    const std::string technique = "techniques/" + topic.name + "/";
    for (const std::string& file : topic.solution) {
        std::istringstream lines(read_text(root / technique / file));
        for (std::string line; std::getline(lines, line);) {
            // Its headers are not in the kit, but for those that the skeleton includes.
            if (line.starts_with("#include \"" + technique) || line == "#pragma once") continue;
            text += line + "\n";
        }
    }
    for (std::size_t file = 0; file < topic.solution.size(); ++file) {
        replace(text, "namespace luch::techniques::" + topic.name + " {",
                "namespace luch::homework::" + topic.name +
                    " {\nusing namespace techniques::" + topic.name + ";");
    }
    replace(text, "Steps reference() {", "Steps steps() {");
    for (const auto& [from, to] : topic.changes) replace(text, from, to);
    return text + "namespace luch::homework::" + topic.name + " {\n" +
           given.substr(given.find("TechniqueInfo describe() {"));
}

/// A solution where a function is not written.
std::string without(std::string solution, const std::string& function, const std::string& task) {
    const std::size_t at = solution.find("void " + function + "(");
    EXPECT_NE(at, std::string::npos) << function;
    return solution.insert(solution.find(") {\n", at) + 4, "    LUCH_TODO(\"" + task + "\");\n");
}

class BuiltKit : public ::testing::Test {
 protected:
    ~BuiltKit() override {
        if (written_ != nullptr) {
            write_text(kit / homework(*written_) / "steps.cpp", skeleton(*written_));
        }
    }

    void write_steps(const Topic& topic, const std::string& text) {
        written_ = &topic;
        write_text(kit / homework(topic) / "steps.cpp", text);
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
    const Topic* written_ = nullptr;
};

class BuiltKitOf : public BuiltKit, public ::testing::WithParamInterface<Topic> {};

INSTANTIATE_TEST_SUITE_P(Homework, BuiltKitOf,
                         ::testing::Values(layered, ldr, shadow_map, ssao, vista),
                         [](const auto& topic) { return topic.param.name; });

TEST_P(BuiltKitOf, ScoresItsFloor) {
    const Topic& topic = GetParam();
    in_kit("cmake --build --preset release");
    const Ran ran = luch("check " + topic.name);
    EXPECT_EQ(ran.status, 1);
    for (int task = 1; task <= topic.tasks; ++task) {
        EXPECT_THAT(ran.text, HasSubstr("NOT ATTEMPTED " + topic.name + ".t" +
                                        std::to_string(task) + "  0/"));
    }
    EXPECT_THAT(ran.text, HasSubstr("\n0 of " + std::to_string(topic.points) + " points"));
}

TEST_P(BuiltKitOf, ShowsWhatIsThereBeforeAnythingIsWritten) {
    const Topic& topic = GetParam();
    in_kit("cmake --build --preset release");
    const Ran compared = luch("compare baseline " + homework(topic) + " " + topic.scenes[0]);
    EXPECT_EQ(compared.status, 0) << compared.text;
    EXPECT_THAT(compared.text, HasSubstr(homework(topic) + ": " + topic.name + ".t" +
                                         std::to_string(topic.tasks) + " is still to be written"));
    const std::string listed = in_kit("./run list").text;
    EXPECT_THAT(listed, HasSubstr("\n" + homework(topic) + " "));
    EXPECT_THAT(listed, Not(HasSubstr("\n" + topic.name + " ")));
}

TEST_P(BuiltKitOf, GivesAllPointsToASolutionAndMakesTheReferencesPicture) {
    const Topic& topic = GetParam();
    write_steps(topic, solution(topic));
    const Ran ran = luch("check " + topic.name);
    EXPECT_EQ(ran.status, 0) << ran.text;
    const std::string points = std::to_string(topic.points);
    EXPECT_THAT(ran.text, HasSubstr("\n" + points + " of " + points + " points"));
    for (const std::string& scene : topic.scenes) {
        EXPECT_EQ(picture("build/release/luch", homework(topic) + " " + topic.yours, scene),
                  picture("'" LUCH_PROGRAM "'", topic.name + " " + topic.reference, scene))
            << scene;
    }
}

TEST_F(BuiltKit, OpensTheViewerAndMakesNoKits) {
    in_kit("cmake --build --preset release --target luch");
    const Ran seen = luch(
        "view scenes/spheres/spheres.scene -t homework/vista --frames 1 "
        "--size 64x48 --screenshot out/view.png");
    EXPECT_EQ(seen.status, 0) << seen.text;
    EXPECT_EQ(read_picture(kit / "out/view.png").pixels.size(), Size(64, 48));
    EXPECT_EQ(luch("kit out/kit").status, 2) << "a kit makes no kits";
}

/// Nothing but a sky, through a lens.
std::string sky_scene() {
    const std::string name = "out/sky.scene";
    write_text(kit / name,
               "GlobalSettings {\n frameWidth 32\n frameHeight 24\n"
               " backgroundColor (0.75, 0.75, 0.75)\n}\n"
               "Camera eye {\n pos (0, 0, 0)\n dof on\n}\n");
    return name;
}

/// Two greys, in stripes.
void expect_hatched(const Image<Rgb>& picture) {
    std::vector<float> greys;
    for (const Rgb& pixel : picture.pixels()) {
        EXPECT_EQ(pixel.x, pixel.z);
        if (std::ranges::find(greys, pixel.x) == greys.end()) greys.push_back(pixel.x);
    }
    EXPECT_EQ(greys.size(), 2u);
}

TEST_F(BuiltKit, PutsStoredIdsInThePlaceOfAStepThatIsNotWritten) {
    write_steps(vista, solution(vista));
    const std::string eight = "homework/vista -p segments=8";  // as the stored ones are
    const Image<Rgb> whole = picture("build/release/luch", eight, balls);
    write_steps(vista, without(solution(vista), "rasterise", "vista.t6"));
    const Image<Rgb> patched = picture("build/release/luch", eight, balls);
    std::size_t differ = 0;
    for (std::size_t i = 0; i < whole.pixels().size(); ++i) {
        differ += whole.pixels()[i] != patched.pixels()[i] ? 1 : 0;
    }
    EXPECT_LT(differ, whole.pixels().size() / 1000);
    EXPECT_THAT(luch("render " + balls + " -t homework/vista -o out/a.png").text,
                HasSubstr("vista.t6 is still to be written"));
    // Elsewhere nobody knows.
    expect_hatched(picture("build/release/luch", "homework/vista",
                           "scenes/spheres/spheres.scene --size 64x48"));
}

TEST_F(BuiltKit, PutsStoredCutsAndCirclesInThePlaceOfStepsThatAreNotWritten) {
    write_steps(layered, solution(layered));
    const std::string five = "homework/layered -p layers=5";  // as the stored ones are
    const Image<Rgb> whole = picture("build/release/luch", five, posts);
    write_steps(layered,
                without(without(solution(layered), "cut", "layered.t1"), "coc", "layered.t2"));
    const Image<Rgb> patched = picture("build/release/luch", five, posts);
    double sum = 0;
    for (std::size_t i = 0; i < whole.pixels().size(); ++i) {
        sum += max_norm(whole.pixels()[i] - patched.pixels()[i]);
    }
    EXPECT_LT(sum / static_cast<double>(whole.pixels().size()), 0.004);
    EXPECT_THAT(luch("render " + posts + " -t homework/layered -o out/a.png").text,
                HasSubstr("layered.t2 is still to be written"));
    // Elsewhere nobody knows.
    expect_hatched(picture("build/release/luch", "homework/layered", sky_scene()));
}

TEST_F(BuiltKit, PutsStoredSurfacesInThePlaceOfStepsThatAreNotWritten) {
    const std::string crates = "homework/ssao/scenes/crates.scene", own = "homework/ssao";
    write_steps(ssao, solution(ssao));
    const Image<Rgb> whole = picture("build/release/luch", own, crates);
    write_steps(ssao,
                without(without(solution(ssao), "positions", "ssao.t1"), "normals", "ssao.t2"));
    EXPECT_EQ(picture("build/release/luch", own, crates), whole);
    // Elsewhere nobody knows.
    write_text(kit / "out/grey.scene",
               "GlobalSettings {\n frameWidth 32\n frameHeight 24\n"
               " backgroundColor (0.75, 0.75, 0.75)\n}\nCamera eye {\n pos (0, 0, 0)\n}\n");
    expect_hatched(picture("build/release/luch", own, "out/grey.scene"));
}

TEST_F(BuiltKit, HatchesWordsWhileAStepIsNotWritten) {
    in_kit("cmake --build --preset release --target luch");
    expect_hatched(picture("build/release/luch", "homework/ldr", sky_scene()));
}

}  // namespace
}  // namespace luch
