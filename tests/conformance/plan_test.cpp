#include "framework/baseline/stages.h"
#include "framework/scene/loader/loader.h"
#include "framework/technique/catalogue.h"
#include "tests/testing/everything.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>

// What a plan leaves out exactly changes no bit: every technique, every scene, every stage.
namespace luch {
namespace {

constexpr Size small{24, 18};

/// The project's scene files.
std::vector<std::filesystem::path> scene_files() {
    std::vector<std::filesystem::path> files;
    const std::filesystem::path folder = LUCH_SOURCE_DIR "/scenes";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const auto name = entry.path().filename().string();
        if (std::filesystem::exists(entry.path() / (name + ".scene"))) {
            files.push_back(entry.path() / (name + ".scene"));
        }
    }
    std::ranges::sort(files);
    return files;
}

/// A scene, and accelerators for it that leave out what it does not need, or nothing.
struct Subject {
    explicit Subject(Scene of) : scene(std::move(of)) {
        scene.settings.frame = small;
        lean = build_accelerator(scene);
        full = build_accelerator(scene, parsed_isa(""), Backend::luch, false);
    }
    [[nodiscard]] Outcome rendered(const TechniqueInfo& info, const Budget& budget,
                                   bool skip = true) const {
        Shot shot = shot_of(scene);
        if (info.name == "path") shot.spp = 2;
        const auto technique = info.create();
        return run(*technique, {scene, skip ? *lean : *full, workers}, shot, budget, {0, 1});
    }

    Scene scene;
    std::unique_ptr<Accelerator> lean, full;
    Workers workers{2};
};

/// Forces on what the technique's plan leaves out exactly: each stage alone, then all at once.
void expect_same_picture(const Subject& subject, const TechniqueInfo& info) {
    const Outcome planned = subject.rendered(info, {});
    if (!planned.plan.applies) return;
    Budget all;
    for (const Stage& stage : planned.plan.stages) {
        if (stage.needed || stage.kind != Stage::exact) continue;
        all.forced.push_back(stage.name);
        const Outcome forced = subject.rendered(info, {.forced = {stage.name}}, false);
        EXPECT_EQ(testing::different_pixels(planned, forced), 0u)
            << subject.scene.name << ", " << info.name << ": " << stage.name;
    }
    EXPECT_EQ(testing::different_pixels(planned, subject.rendered(info, all, false)), 0u)
        << subject.scene.name << ", " << info.name << ": all stages";
}

class ExactPlan : public ::testing::TestWithParam<std::filesystem::path> {};

TEST_P(ExactPlan, LosesNoBitOfAnyTechniquesPicture) {
    const Subject subject(load_scene(GetParam()).scene);
    for (const TechniqueInfo& info : catalogue()) expect_same_picture(subject, info);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ExactPlan, ::testing::ValuesIn(scene_files()),
                         [](const auto& scene) { return scene.param.stem().string(); });

/// Black things that would show a bright sky.
Scene black_mirror(float brightness) {
    Scene scene = testing::empty_scene();
    scene.settings.background = Rgb(brightness);
    testing::add(scene, Sphere{.centre = {0, 0, 3}}, Reflection{.multiplier = Rgb(0)});
    testing::add(scene, Sphere{.centre = {2, 0, 4}}, Refraction{.multiplier = Rgb(0)});
    return scene;
}

TEST(ExactPlan, KeepsBlackBlackUnderAnInfinitelyBrightSky) {
    const Subject subject(black_mirror(std::numeric_limits<float>::infinity()));
    expect_same_picture(subject, find_technique("baseline"));
}

TEST(ExactPlan, LosesNoBitOfScenesThatNeedNextToNothing) {
    Scene unlit = testing::sixty_spheres();
    unlit.lights.clear();
    Scene flat = testing::one_of_each();
    flat.settings.max_depth = 0;
    for (Scene scene : {testing::empty_scene(), testing::one_triangle(), black_mirror(1), unlit,
                        flat, testing::bit_of_everything()}) {
        const Subject subject(std::move(scene));
        for (const TechniqueInfo& info : catalogue()) expect_same_picture(subject, info);
    }
}

const Stage& stage_of(const Plan& plan, Part part) {
    return *std::ranges::find(plan.stages, name_of(part).name, &Stage::name);
}

/// Every stage that has something to do in this scene is at work, and a stage that is left out is
/// not.
TEST(PlanOfTheBaseline, TellsWhatEachStageDid) {
    const Subject everything(testing::bit_of_everything());
    const TechniqueInfo& baseline = find_technique("baseline");
    const Outcome planned = everything.rendered(baseline, {});
    for (const Stage& stage : planned.plan.stages) {
        EXPECT_EQ(stage.work > 0, stage.needed) << stage.name;
        EXPECT_NE(stage.worked_on, "") << stage.name;
    }
    Scene scene = testing::one_triangle();
    scene.materials.emplace_back(Reflection{.multiplier = Rgb(0)});
    scene.nodes[0].material = static_cast<MaterialId>(scene.materials.size() - 1);
    const Subject one(std::move(scene));
    const Outcome lean = one.rendered(baseline, {}),
                  full = one.rendered(baseline, {.skip = false}, false);
    for (const Part part :
         {Part::bump, Part::texture_coordinates, Part::smooth_normals, Part::black_branches,
          Part::scene_tree, Part::lens, Part::environment, Part::shared_shadows}) {
        EXPECT_FALSE(stage_of(lean.plan, part).needed) << name_of(part).name;
        EXPECT_EQ(stage_of(lean.plan, part).work, 0u) << name_of(part).name;
        EXPECT_GT(stage_of(full.plan, part).work, 0u) << name_of(part).name;
    }
}

TEST(PlanOfTheBaseline, NamesTheStageThatWasMeantWhenThereIsNoSuch) {
    const Subject subject(testing::one_triangle());
    try {
        static_cast<void>(subject.rendered(find_technique("baseline"), {.forced = {"mirror"}}));
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("mirrors"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace luch
