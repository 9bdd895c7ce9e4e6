#include "framework/base/files.h"
#include "scenes/generator/assets.h"
#include "tests/testing/own_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

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

/// Every folder of scenes/ with a scene in it.
std::vector<std::filesystem::path> scene_folders() {
    std::vector<std::filesystem::path> folders;
    for (const auto& entry : std::filesystem::directory_iterator(scenes)) {
        const auto name = entry.path().filename();
        if (std::filesystem::exists(entry.path() / (name.string() + ".scene"))) {
            folders.push_back(entry.path());
        }
    }
    return folders;
}

TEST(CommittedAssets, StaySmall) {
    ASSERT_GE(scene_folders().size(), 12u);
    for (const auto& folder : scene_folders()) {
        std::uintmax_t bytes = 0;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
            if (entry.is_regular_file()) bytes += entry.file_size();
        }
        EXPECT_LE(bytes, folder.filename() == "forest" ? 3000000u : 1500000u) << folder;
    }
}

TEST(CommittedAssets, HaveALicenceInEveryScene) {
    for (const auto& folder : scene_folders()) {
        EXPECT_NE(read_text(folder / "LICENSE").find("CC0"), std::string::npos) << folder;
    }
}

}  // namespace
}  // namespace luch::assets
