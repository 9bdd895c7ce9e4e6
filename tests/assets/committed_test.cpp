#include "framework/base/files.h"
#include "scenes/generator/assets.h"
#include "tests/testing/own_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

namespace luch::assets {
namespace {

const std::filesystem::path scenes = std::filesystem::path(LUCH_SOURCE_DIR) / "scenes";

TEST(CommittedAssets, AreWhatTheGeneratorWrites) {
    const auto assets = all_assets();
    ASSERT_FALSE(assets.empty());
    const auto folder = own_folder();
    for (const auto& [path, bytes] : assets) {
        write_text(folder / path, bytes);
        EXPECT_TRUE(read_text(folder / path) == read_text(scenes / path))
            << path << " differs: run luch_assets scenes, and commit what it wrote";
    }
    std::filesystem::remove_all(folder);
}

/// The folders of scenes/ that hold a scene.
std::vector<std::filesystem::path> scene_folders() {
    std::vector<std::filesystem::path> folders;
    for (const auto& entry : std::filesystem::directory_iterator(scenes)) {
        const auto& folder = entry.path();
        const auto scene = folder / (folder.filename().string() + ".scene");
        if (std::filesystem::exists(scene)) folders.push_back(folder);
    }
    return folders;
}

TEST(CommittedAssets, StaySmall) {
    for (const auto& folder : scene_folders()) {
        std::uintmax_t bytes = 0;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
            if (entry.is_regular_file()) bytes += entry.file_size();
        }
        EXPECT_GT(bytes, 0u);
        EXPECT_LE(bytes, 800000u) << folder;
    }
}

TEST(CommittedAssets, HaveALicenceInEveryScene) {
    EXPECT_GE(scene_folders().size(), 5u);
    for (const auto& folder : scene_folders()) {
        EXPECT_NE(read_text(folder / "LICENSE").find("CC0"), std::string::npos) << folder;
    }
}

}  // namespace
}  // namespace luch::assets
