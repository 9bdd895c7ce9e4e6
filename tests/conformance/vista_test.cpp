#include "framework/scene/census.h"
#include "framework/scene/loader/loader.h"
#include "framework/technique/catalogue.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

#include <filesystem>

// The item buffer's exact mode: the baseline's picture, bit for bit, of every scene.
namespace luch {
namespace {

struct SceneFile {
    std::filesystem::path path, root;
};

std::vector<SceneFile> scene_files() {
    std::vector<SceneFile> files;
    const std::filesystem::path ours = LUCH_SOURCE_DIR "/scenes",
                                courses = LUCH_SOURCE_DIR "/../shared/course-scenes";
    for (const auto& entry : std::filesystem::directory_iterator(ours)) {
        const auto path = entry.path() / (entry.path().filename().string() + ".scene");
        if (std::filesystem::exists(path)) files.push_back({path, entry.path()});
    }
    if (std::filesystem::exists(courses)) {
        for (const auto& entry : std::filesystem::directory_iterator(courses)) {
            if (entry.path().extension() == ".hexray") files.push_back({entry.path(), courses});
        }
    }
    std::ranges::sort(files, {}, &SceneFile::path);
    return files;
}

std::ostream& operator<<(std::ostream& out, const SceneFile& file) {
    return out << file.path.filename();
}

std::size_t triangles_of(const Scene& scene) {
    std::size_t count = 0;
    for (const Node& node : scene.nodes) {
        const auto* mesh = std::get_if<Mesh>(&scene.geometries[node.geometry]);
        if (mesh != nullptr) count += mesh->triangles.size();
    }
    return count;
}

class ExactVista : public ::testing::TestWithParam<SceneFile> {};

TEST_P(ExactVista, MakesTheBaselinesPictureBitForBit) {
    const testing::OwnStudio studio(load_scene(GetParam().path, {GetParam().root, false}).scene);
    Shot shot = shot_of(studio.scene());
    shot.size = {96, 72};
    shot.spp = 1;
    // The buffer is used even where it does not pay, but for what would take long to set up.
    Budget used;
    if (triangles_of(studio.scene()) < 1'000'000) used.forced = {"item buffer"};
    const auto vista = find_technique("vista").create();
    if (const Plan plan = vista->plan(studio.scene(), shot); !plan.applies) {
        EXPECT_NE(plan.why, "");
        GTEST_SKIP() << plan.why;
    }
    const Outcome outcome = studio.render(*vista, shot, used);
    const Outcome truth = studio.render(*find_technique("baseline").create(), shot);
    EXPECT_EQ(testing::different_pixels(outcome, truth), 0u);
    const double share = double(outcome.counts.fallbacks) / double(shot.size.area());
    RecordProperty("fallback_percent", std::to_string(100 * share));
    const bool without_solids = census_of(studio.scene()).solids == 0;
    EXPECT_LT(share, without_solids ? 0.01 : 1);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ExactVista, ::testing::ValuesIn(scene_files()),
                         [](const auto& file) { return file.param.path.stem().string(); });

}  // namespace
}  // namespace luch
