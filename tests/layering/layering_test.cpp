#include "tests/layering/rules.h"
#include "tests/testing/own_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace luch::layering {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A copy of this source tree that a test may spoil; removed at the end.
class Copy {
 public:
    Copy() {
        const fs::path source = LUCH_SOURCE_DIR;
        for (const char* name : {"CMakeLists.txt", "CMakePresets.json"}) {
            fs::copy(source / name, root_ / name);
        }
        for (const char* top : {"framework", "techniques", "homework", "scenes", "tests"}) {
            if (fs::exists(source / top)) copy_code(source / top, root_ / top);
        }
    }
    ~Copy() { fs::remove_all(root_); }
    Copy(const Copy&) = delete;
    Copy& operator=(const Copy&) = delete;

    void append(const fs::path& file, const std::string& text) const {
        fs::create_directories((root_ / file).parent_path());
        std::ofstream(root_ / file, std::ios::app) << text;
    }
    [[nodiscard]] const fs::path& root() const { return root_; }

 private:
    /// Code and build files only: a scene's assets may be large.
    static void copy_code(const fs::path& from, const fs::path& to) {
        for (const auto& entry : fs::recursive_directory_iterator(from)) {
            const auto ending = entry.path().extension();
            if (ending != ".h" && ending != ".cpp" && ending != ".txt" && ending != ".cmake")
                continue;
            const fs::path copy = to / fs::relative(entry.path(), from);
            fs::create_directories(copy.parent_path());
            fs::copy_file(entry.path(), copy);
        }
    }

    fs::path root_ = own_folder();
};

struct Planted {
    std::string name, file, text, breach;
};

void PrintTo(const Planted& planted, std::ostream* out) {
    *out << planted.file;
}

class Spoilt : public testing::TestWithParam<Planted> {};
class Allowed : public testing::TestWithParam<Planted> {};

std::string name_of(const testing::TestParamInfo<Planted>& info) {
    return info.param.name;
}

std::string include(const std::string& name) {
    return "#include \"" + name + "\"\n";
}

TEST(Layering, TheTreeKeepsTheRules) {
    EXPECT_THAT(breaches(LUCH_SOURCE_DIR), IsEmpty());
}

TEST(Layering, ATreeWithoutAFrameworkIsAnError) {
    EXPECT_THROW(breaches(fs::path(LUCH_SOURCE_DIR) / "tests"), fs::filesystem_error);
}

TEST_P(Spoilt, IsFoundInACopyOfTheTree) {
    const Copy copy;
    copy.append(GetParam().file, GetParam().text);
    EXPECT_THAT(breaches(copy.root()), ElementsAre(HasSubstr(GetParam().breach)));
}

const auto planted = testing::Values(
    Planted{"UpwardInclude", "framework/math/planted.h", include("framework/scene/scene.h"),
            "framework/math/planted.h:1: math may not include scene"},
    Planted{"SidewaysInclude", "framework/grading/planted.h",
            "\n  # include \"framework/baseline/baseline.h\"\n",
            "framework/grading/planted.h:2: grading may not include baseline"},
    Planted{"UnknownLayer", "framework/attic/planted.h", include("framework/math/ray.h"),
            "no such layer: attic"},
    Planted{"FrameworkKnowsATechnique", "framework/technique/planted.cpp",
            include("techniques/vista/vista.h"), "the framework knows no techniques"},
    Planted{"FrameworkKnowsATest", "framework/base/planted.cpp", include("tests/testing/noise.h"),
            "the framework knows no tests"},
    Planted{"TechniqueKnowsAnother", "techniques/vista/planted.cpp",
            include("techniques/ssao/ssao.h"), "techniques/vista may not include techniques/ssao"},
    Planted{"TechniqueKnowsTheWindow", "techniques/vista/planted.cpp",
            include("framework/window/window.h"),
            "techniques/vista may not include framework/window"},
    Planted{"TechniqueKnowsATest", "techniques/vista/planted.cpp", include("tests/testing/noise.h"),
            "techniques/vista may not include tests/testing"},
    Planted{"TechniqueKnowsItsHomework", "techniques/vista/planted.cpp",
            include("homework/vista/steps.h"), "techniques/vista may not include homework/vista"},
    Planted{"HomeworkKnowsAnotherTechnique", "homework/vista/planted.cpp",
            include("techniques/ssao/ssao.h"), "homework/vista may not include techniques/ssao"},
    Planted{"TechniqueKnowsAScene", "techniques/vista/planted.cpp",
            include("scenes/generator/noise.h"),
            "techniques/vista may not include scenes/generator"},
    Planted{"FrameworkKnowsAScene", "framework/scene/planted.cpp",
            include("scenes/generator/noise.h"), "the framework knows no scenes"},
    Planted{"HeavyHeaderInTheWrongFile", "framework/accel/planted.cpp",
            "#include <nlohmann/json.hpp>\n",
            "nlohmann/json.hpp may be named only in framework/base/json.cpp"},
    Planted{"HeavyHeaderInAHeader", "framework/window/planted.h", "#include <SDL2/SDL.h>\n",
            "a heavy header belongs into a .cpp: SDL2/SDL.h"},
    Planted{"IncludeNotFromTheRoot", "framework/accel/planted.h", include("hit.h"),
            "spell the include from the root: hit.h"},
    Planted{"IncludeWithDots", "framework/accel/planted.h",
            include("framework/accel/../math/ray.h"), "spell the include from the root"},
    Planted{"OurHeaderInAngles", "framework/accel/planted.h", "#include <framework/math/ray.h>\n",
            "our own headers are quoted"},
    Planted{"LongFile", "framework/math/planted.cpp", std::string(401, '\n'), "401 lines"},
    Planted{"FastMath", "techniques/vista/CMakeLists.txt", "add_compile_options(-ffast-math)\n",
            "ruled out: -ffast-math"},
    Planted{"NativeInstructions", "framework/cmake/settings.cmake", "# -march=native\n",
            "ruled out: march=native"});
INSTANTIATE_TEST_SUITE_P(Layering, Spoilt, planted, name_of);

TEST_P(Allowed, IsNoBreachInACopyOfTheTree) {
    const Copy copy;
    copy.append(GetParam().file, GetParam().text);
    EXPECT_THAT(breaches(copy.root()), IsEmpty());
}

const auto harmless = testing::Values(
    Planted{"DownwardInclude", "framework/apps/planted.cpp", include("framework/base/error.h"), ""},
    Planted{"TechniqueKnowsTheFramework", "techniques/vista/planted.cpp",
            include("framework/trace/tracer.h"), ""},
    Planted{"HomeworkKnowsItsTechnique", "homework/vista/planted.cpp",
            include("techniques/vista/vista.h"), ""},
    Planted{"ModuleTestKnowsTheTestTools", "techniques/vista/planted_test.cpp",
            include("tests/testing/noise.h"), ""},
    Planted{"FourHundredLines", "framework/math/planted.cpp", std::string(400, '\n'), ""});
INSTANTIATE_TEST_SUITE_P(Layering, Allowed, harmless, name_of);

}  // namespace
}  // namespace luch::layering
