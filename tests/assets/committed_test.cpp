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

/// The bytes of some scenes' folders.
std::uintmax_t bytes_of(std::initializer_list<const char*> names) {
    std::uintmax_t bytes = 0;
    for (const char* name : names) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(scenes / name)) {
            if (entry.is_regular_file()) bytes += entry.file_size();
        }
    }
    return bytes;
}

TEST(CommittedAssets, StaySmall) {
    const std::uintmax_t bytes = bytes_of({"room", "spheres", "mirrors"});
    EXPECT_GT(bytes, 0u);
    EXPECT_LE(bytes, 1500000u);
    EXPECT_LE(bytes_of({"toys", "many_lights"}), 500000u);
    EXPECT_LE(bytes_of({"forest"}), 3000000u);
}

TEST(CommittedAssets, HaveALicenceInEveryScene) {
    for (const char* scene : {"room", "spheres", "mirrors", "toys", "many_lights", "forest"}) {
        EXPECT_NE(read_text(scenes / scene / "LICENSE").find("CC0"), std::string::npos) << scene;
    }
}

}  // namespace
}  // namespace luch::assets
