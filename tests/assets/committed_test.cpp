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

TEST(CommittedAssets, StaySmall) {
    std::uintmax_t bytes = 0;
    for (const char* scene : {"room", "spheres", "mirrors", "cornell"}) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(scenes / scene)) {
            if (entry.is_regular_file()) bytes += entry.file_size();
        }
    }
    EXPECT_GT(bytes, 0u);
    EXPECT_LE(bytes, 1500000u);
}

TEST(CommittedAssets, HaveALicenceInEveryScene) {
    for (const char* scene : {"room", "spheres", "mirrors", "cornell"}) {
        EXPECT_NE(read_text(scenes / scene / "LICENSE").find("CC0"), std::string::npos) << scene;
    }
}

}  // namespace
}  // namespace luch::assets
