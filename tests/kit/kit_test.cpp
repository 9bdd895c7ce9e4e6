#include "framework/grading/kit.h"

#include "framework/base/error.h"
#include "framework/base/files.h"
#include "tests/testing/own_folder.h"
#include "tests/testing/shell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace luch::grading {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const fs::path root = LUCH_SOURCE_DIR;

/// A small tree with rules, or this tree's kit, in a folder that is removed at the end.
class Kits : public ::testing::Test {
 protected:
    ~Kits() override { fs::remove_all(folder_); }

    void file(const fs::path& name, const std::string& text = "text\n") const {
        write_text(folder_ / name, text);
    }

    Kit with_rules(const std::string& rules) const {
        file("homework/kit.txt", rules);
        return kit_of(folder_);
    }

    std::string error_of(const std::string& rules) const {
        try {
            with_rules(rules);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

    fs::path folder_ = own_folder();
};

std::vector<std::string> names(const Kit& kit) {
    std::vector<std::string> all;
    for (const KitFile& each : kit.files) {
        const std::string from = each.from == each.to ? "" : " from " + each.from.generic_string();
        all.push_back(each.to.generic_string() + from);
    }
    return all;
}

TEST_F(Kits, HoldOnlyWhatARuleKeepsAndTheLastRuleDecides) {
    for (const char* name : {"a/one.cpp", "a/two.cpp", "ab/three.cpp", "b/four.cpp"}) file(name);
    EXPECT_THAT(names(with_rules("# a comment\n\nkeep a\ndrop a/two.cpp  why it is\n")),
                ElementsAre("a/one.cpp"));
    EXPECT_THAT(names(with_rules("keep a*\ndrop a/*.cpp\nkeep a/t*o.cpp\n")),
                ElementsAre("a/two.cpp", "ab/three.cpp"));
}

TEST_F(Kits, PutFilesInThePlaceOfOthers) {
    for (const char* name : {"a/one.cpp", "a/two.cpp", "a/kit/one.cpp"}) file(name);
    EXPECT_THAT(names(with_rules("keep a\nput a/kit a\n")),
                ElementsAre("a/one.cpp from a/kit/one.cpp", "a/two.cpp"));
    EXPECT_THAT(names(with_rules("keep a/two.cpp\nput a/kit .\n")),
                ElementsAre("a/two.cpp", "one.cpp from a/kit/one.cpp"));
}

TEST_F(Kits, SayWhichRuleIsWrong) {
    file("a/one.cpp");
    EXPECT_THAT(error_of("keep a\nhide a\n"), HasSubstr("homework/kit.txt:2: \"hide\""));
    EXPECT_THAT(error_of("put a\n"), HasSubstr("homework/kit.txt:1: put of what?"));
    EXPECT_THAT(error_of("keep a\ndrop a/two.cpp\n"),
                HasSubstr("homework/kit.txt:2: no file fits a/two.cpp"));
    fs::remove(folder_ / "homework/kit.txt");
    EXPECT_THROW(kit_of(folder_), Error);
}

TEST_F(Kits, OfThisTreeHoldNoSolution) {
    const Kit kit = kit_of(root);
    std::vector<std::string> solutions;
    for (const fs::path& each : kit.solutions) solutions.push_back(each.generic_string());
    for (const char* name : {"techniques/vista/steps.cpp",
                             "techniques/vista/tessellate.cpp",
                             "homework/vista/mutants/raster.cpp",
                             "homework/vista/variants/variants.cpp",
                             "techniques/layered/steps.cpp",
                             "techniques/layered/confusion.cpp",
                             "techniques/ldr/steps.cpp",
                             "techniques/ldr/spans.cpp",
                             "techniques/ldr/swar.h",
                             "homework/ldr/mutants/mutants.cpp",
                             "homework/layered/mutants/mutants.cpp",
                             "homework/layered/variants/variants.cpp",
                             "techniques/shadow_map/steps.cpp",
                             "techniques/shadow_map/cube.h",
                             "techniques/shadow_map/cube.cpp",
                             "homework/shadow_map/mutants/maps.cpp",
                             "homework/shadow_map/variants/maps.cpp",
                             "techniques/ssao/steps.cpp",
                             "homework/ssao/mutants/occlusion.cpp",
                             "homework/ssao/variants/variants.cpp"}) {
        EXPECT_THAT(solutions, Contains(name));
    }
    write_kit(root, kit, folder_);
    EXPECT_THAT(leaks(root, kit, folder_), IsEmpty());
    // Of techniques only what was looked at, as it may be given away.
    const std::vector<std::string> known{
        "techniques/layered/composite.cpp",
        "techniques/layered/composite.h",
        "techniques/layered/fragments.cpp from homework/layered/kit/technique/fragments.cpp",
        "techniques/layered/fragments.h from homework/layered/kit/technique/fragments.h",
        "techniques/layered/layered.h",
        "techniques/layered/lens.cpp",
        "techniques/layered/stress.cpp",
        "techniques/layered/stress.h",
        "techniques/ldr/canvas.cpp",
        "techniques/ldr/canvas.h",
        "techniques/ldr/ldr.cpp from homework/ldr/kit/technique/ldr.cpp",
        "techniques/ldr/ldr.h",
        "techniques/ldr/levels.cpp",
        "techniques/ldr/plan.cpp",
        "techniques/ldr/plan.h",
        "techniques/ldr/planes.cpp",
        "techniques/ldr/planes.h",
        "techniques/ldr/render.cpp",
        "techniques/ldr/render.h",
        "techniques/ldr/stress.cpp",
        "techniques/ldr/stress.h",
        "techniques/ldr/swar.h from homework/ldr/kit/technique/swar.h",
        "techniques/ldr/word.h",
        "techniques/ldr/word_sample.cpp",
        "techniques/shadow_map/content.cpp",
        "techniques/shadow_map/content.h",
        "techniques/shadow_map/judged.cpp",
        "techniques/shadow_map/judged.h",
        "techniques/shadow_map/shadow_map.h",
        "techniques/shadow_map/stress.cpp",
        "techniques/shadow_map/stress.h",
        "techniques/ssao/ambient.cpp",
        "techniques/ssao/ambient.h",
        "techniques/ssao/passes.cpp",
        "techniques/ssao/passes.h",
        "techniques/ssao/plan.cpp",
        "techniques/ssao/plan.h",
        "techniques/ssao/rays.cpp",
        "techniques/ssao/rays.h",
        "techniques/ssao/render.cpp",
        "techniques/ssao/render.h",
        "techniques/ssao/slices.cpp",
        "techniques/ssao/slices.h",
        "techniques/ssao/ssao.h",
        "techniques/ssao/stress.cpp",
        "techniques/ssao/stress.h",
        "techniques/ssao/view.h",
        "techniques/vista/vista.h"};
    std::vector<std::string> techniques = names(kit);
    std::erase_if(techniques,
                  [](const std::string& each) { return !each.starts_with("techniques/"); });
    EXPECT_EQ(techniques, known);
    for (const KitFile& each : kit.files) {
        const std::string name = each.to.generic_string();
        EXPECT_FALSE(name.starts_with("tests/") || name.ends_with("_test.cpp")) << name;
        EXPECT_FALSE(name.starts_with("framework/raster/") ||
                     name.starts_with("framework/measure/mix/"));
    }
}

/// Some lines of a solution, indented in another way, among others.
TEST_F(Kits, AreSearchedForLinesOfTheSolutions) {
    const Kit kit = kit_of(root);
    for (const auto& [file, word] : {std::pair("techniques/vista/steps.cpp", "double s = "),
                                     {"techniques/layered/steps.cpp", "double diameter = "},
                                     {"techniques/layered/confusion.cpp", "double radius = "},
                                     {"techniques/ssao/steps.cpp", "double height = "},
                                     {"techniques/ldr/swar.h", "const std::uint32_t out = "},
                                     {"techniques/ldr/steps.cpp", "const double part = "},
                                     {"techniques/shadow_map/steps.cpp", "const float along = "},
                                     {"techniques/shadow_map/cube.cpp", "const int over = "}}) {
        std::ifstream in(root / file);
        std::vector<std::string> lines;
        for (std::string line; std::getline(in, line);) lines.push_back(line);
        const auto first = std::ranges::find_if(
            lines, [word = word](const std::string& line) { return line.find(word) != line.npos; });
        ASSERT_LT(first + 3, lines.end()) << file;
        std::string planted = "// notes\n";
        for (auto line = first - 2; line < first + 2; ++line) planted += "\t \t" + *line + " \n\n";
        write_text(folder_ / "scenes/notes.txt", planted);
        EXPECT_THAT(leaks(root, kit, folder_),
                    Contains(HasSubstr(std::string("scenes/notes.txt:2: as in ") + file + ":")));
    }
}

TEST_F(Kits, GoIntoNewFoldersOnly) {
    file("something");
    const Ran full = shell("'" LUCH_PROGRAM "' kit " + folder_.string());
    EXPECT_EQ(full.status, 2);
    EXPECT_THAT(full.text, HasSubstr(folder_.string() + ": is not empty; name a new folder"));
    EXPECT_EQ(shell("'" LUCH_PROGRAM "' kit").status, 2);
    const Ran made = shell("'" LUCH_PROGRAM "' kit " + (folder_ / "new").string());
    EXPECT_EQ(made.status, 0);
    EXPECT_THAT(made.text, HasSubstr("no line of a solution is in it"));
    EXPECT_TRUE(fs::exists(folder_ / "new/homework/vista/steps.cpp"));
}

}  // namespace
}  // namespace luch::grading
