#include "framework/scene/loader/loader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace luch {
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;

/// The course's scenes are not part of this project; they lie beside it where somebody has them.
class CourseScenes : public testing::Test {
 protected:
    void SetUp() override {
        if (!fs::exists(folder_)) GTEST_SKIP() << "no course scenes at " << folder_;
    }
    Loaded loaded(const std::string& name) const { return load_scene(folder_ / name); }
    fs::path folder_ = LUCH_SOURCE_DIR "/../shared/course-scenes";
};

std::size_t triangles(const Scene& scene) {
    std::size_t count = 0;
    for (const Geometry& geometry : scene.geometries) {
        if (const auto* mesh = std::get_if<Mesh>(&geometry)) count += mesh->triangles.size();
    }
    return count;
}

TEST_F(CourseScenes, Lecture8LoadsWithoutAWarning) {
    const Loaded result = loaded("Lecture8.hexray");
    EXPECT_THAT(result.warnings, IsEmpty());
    EXPECT_EQ(result.scene.nodes.size(), 3u);
    EXPECT_EQ(triangles(result.scene), 44u + 992u);
    EXPECT_EQ(result.scene.settings.max_depth, 5);
    ASSERT_TRUE(result.scene.environment);
    for (const auto& side : std::get<CubemapEnvironment>(*result.scene.environment).sides)
        EXPECT_GT(side.width(), 0);
}

TEST_F(CourseScenes, BoxedLoadsWithoutAWarning) {
    const Loaded result = loaded("boxed.hexray");
    EXPECT_THAT(result.warnings, IsEmpty());
    EXPECT_EQ(result.scene.lights.size(), 2u);
    // Nine nodes and the face of the rect light.
    EXPECT_EQ(result.scene.nodes.size(), 10u);
}

TEST_F(CourseScenes, CornellBoxLoadsWithoutAWarning) {
    const Loaded result = loaded("cornell_box.hexray");
    EXPECT_THAT(result.warnings, IsEmpty());
    EXPECT_TRUE(result.scene.settings.global_illumination);
    EXPECT_EQ(triangles(result.scene), 5u * 2 + 2 * 10);
}

TEST_F(CourseScenes, ZaphodLoadsWithoutAWarning) {
    const Loaded result = loaded("zaphod.hexray");
    EXPECT_THAT(result.warnings, IsEmpty());
    EXPECT_TRUE(result.scene.camera.depth_of_field);
    EXPECT_EQ(result.scene.camera.focal_distance, 25.29);
}

TEST_F(CourseScenes, HeightfieldIsReadAndBlurred) {
    const Loaded result = loaded("heightfield.hexray");
    EXPECT_TRUE(result.warnings.empty());
    const auto& field = std::get<Heightfield>(result.scene.geometries.at(2));
    EXPECT_EQ(field.width(), 512);
    EXPECT_EQ(field.height(), 512);
    // As high as in the course's own picture, which is the island's outline against the sky.
    EXPECT_NEAR(bounds_of(field).hi.y, 0.5806, 1e-3);
}

}  // namespace
}  // namespace luch
