#include "framework/base/files.h"
#include "framework/scene/loader/loader.h"
#include "tests/testing/own_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace luch {
namespace {

namespace fs = std::filesystem;

/// Every broken scene says in its first line, a comment, what the loader must answer.
std::vector<std::string> broken_scenes() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(LUCH_SOURCE_DIR "/tests/hostile/scenes")) {
        if (entry.path().extension() == ".scene") names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::string expected(const fs::path& scene) {
    const std::string text = read_text(scene);
    const std::string start = "// expects: ";
    if (!text.starts_with(start)) return "a first line \"" + start + "...\"";
    std::string message = text.substr(start.size(), text.find('\n') - start.size());
    const std::string mark = "{root}";
    if (const auto at = message.find(mark); at != std::string::npos) {
        message.replace(at, mark.size(), fs::canonical(LUCH_SOURCE_DIR).string());
    }
    return message;
}

std::string answer(const fs::path& scene, const LoadOptions& options) {
    try {
        load_scene(scene, options);
        return "loaded without an error";
    } catch (const Error& error) {
        return error.what();
    }
}

class BrokenScene : public testing::TestWithParam<std::string> {
    void SetUp() override { fs::current_path(LUCH_SOURCE_DIR); }
};

TEST_P(BrokenScene, IsRefusedWithItsOwnWords) {
    const fs::path scene = "tests/hostile/scenes/" + GetParam() + ".scene";
    const LoadOptions options{.root = {}, .strict = GetParam().starts_with("strict_")};
    EXPECT_EQ(answer(scene, options), expected(scene));
}

INSTANTIATE_TEST_SUITE_P(All, BrokenScene, testing::ValuesIn(broken_scenes()),
                         [](const auto& test) { return test.param; });

TEST(BrokenScenes, AreManyEnoughToMeanSomething) {
    EXPECT_GE(broken_scenes().size(), 55u);
}

class Folder : public testing::Test {
 protected:
    void SetUp() override {
        folder_ = own_folder();
        fs::create_directories(folder_ / "inside");
    }
    void TearDown() override { fs::remove_all(folder_); }

    /// A scene in inside/ that names one mesh.
    fs::path scene_with_mesh(const std::string& name) const {
        const fs::path scene = folder_ / "inside" / "one.scene";
        write_text(scene,
                   "Camera camera {\n pos (0, 0, 0)\n}\nMesh mesh {\n file \"" + name + "\"\n}\n");
        return scene;
    }
    void write_triangle(const std::string& name) const {
        write_text(folder_ / name, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    }
    fs::path folder_;
};

using Root = Folder;

TEST_F(Root, IsTheScenesOwnFolderWhenTheSceneLiesElsewhere) {
    write_triangle("outside.obj");
    EXPECT_EQ(answer(scene_with_mesh("../outside.obj"), {}),
              (folder_ / "inside" / "one.scene").string() +
                  ":5: \"../outside.obj\" lies outside the root " +
                  fs::canonical(folder_ / "inside").string() +
                  "; move it there, or name a wider one with --root DIR");
}

TEST_F(Root, WidensWithTheOption) {
    write_triangle("outside.obj");
    EXPECT_EQ(answer(scene_with_mesh("../outside.obj"), {.root = folder_, .strict = false}),
              "loaded without an error");
}

TEST_F(Root, IsTheWorkingFolderWhenTheSceneLiesUnderIt) {
    write_triangle("outside.obj");
    fs::current_path(folder_);
    const std::string said = answer(scene_with_mesh("../outside.obj"), {});
    fs::current_path(LUCH_SOURCE_DIR);
    EXPECT_EQ(said, "loaded without an error");
}

TEST_F(Root, IsNotLeftOverALink) {
    write_triangle("outside.obj");
    fs::create_symlink(folder_ / "outside.obj", folder_ / "inside" / "link.obj");
    EXPECT_EQ(answer(scene_with_mesh("link.obj"), {}),
              (folder_ / "inside" / "one.scene").string() +
                  ":5: \"link.obj\" lies outside the root " +
                  fs::canonical(folder_ / "inside").string() +
                  "; move it there, or name a wider one with --root DIR");
}

TEST_F(Root, IsNotLeftForASiblingWithALongerName) {
    fs::create_directories(folder_ / "inside_too");
    write_triangle("inside_too/mesh.obj");
    EXPECT_NE(answer(scene_with_mesh("../inside_too/mesh.obj"), {}).find("lies outside the root"),
              std::string::npos);
}

TEST_F(Root, AllowsALinkThatStaysInside) {
    write_triangle("inside/mesh.obj");
    fs::create_symlink(folder_ / "inside" / "mesh.obj", folder_ / "inside" / "link.obj");
    EXPECT_EQ(answer(scene_with_mesh("link.obj"), {}), "loaded without an error");
}

TEST_F(Folder, CannotStandForAScene) {
    EXPECT_EQ(answer(folder_, {}), folder_.string() + ": is a folder; name a scene in it");
}

TEST_F(Folder, CannotStandForAMesh) {
    fs::create_directories(folder_ / "inside" / "mesh.obj");
    EXPECT_EQ(answer(scene_with_mesh("mesh.obj"), {}),
              (folder_ / "inside" / "one.scene").string() + ":5: " +
                  (folder_ / "inside" / "mesh.obj").string() + ": does not exist; check the name");
}

}  // namespace
}  // namespace luch
