#include "tests/scene/scene_file.h"

namespace luch {
namespace {

/// What the older dialects of the course wrote otherwise.
using Dialects = SceneFile;

TEST_F(Dialects, NameTheCamerasPlaceAndShapeDifferently) {
    write_text(folder_ / "t.scene", "Camera c {\nposition (1, +2, 3.)\naspect 2\n}\n");
    const Camera camera =
        load_scene(folder_ / "t.scene", {.root = {}, .strict = true}).scene.camera;
    EXPECT_EQ(camera.position, Vec3d(1, 2, 3));
    EXPECT_EQ(camera.aspect, 2);
}

TEST_F(Dialects, CallTheScalingOfACheckerItsSize) {
    const Scene scene = loaded("Checker c {\nsize 5\n}", true).scene;
    EXPECT_EQ(std::get<CheckerTexture>(scene.textures.at(0)).scaling, 5);
    EXPECT_EQ(answer("Checker c {\nsize 0\n}"), "t.scene:2: size is 0; choose another number");
}

TEST_F(Dialects, HaveOtherNamesForHighlightsAndMultipliers) {
    const Scene scene = loaded(
                            "Phong a {\nspecularMultiplier 0.25\nspecularExponent 7\n}\n"
                            "Phong b {\nstrength 2\n}\nPhong c {\nspecular (15, 1, 0)\n}\n"
                            "Refl d {\ncolor 1 0 1\n}\nRefr e {\ncolor 0 1 0\n}",
                            true)
                            .scene;
    EXPECT_EQ(std::get<Phong>(scene.materials.at(0)).specular, Rgb(0.25f));
    EXPECT_EQ(std::get<Phong>(scene.materials.at(0)).exponent, 7);
    EXPECT_EQ(std::get<Phong>(scene.materials.at(1)).specular, Rgb(2));
    EXPECT_EQ(std::get<Phong>(scene.materials.at(2)).specular, Rgb(15, 1, 0));
    EXPECT_EQ(std::get<Reflection>(scene.materials.at(3)).multiplier, Rgb(1, 0, 1));
    EXPECT_EQ(std::get<Refraction>(scene.materials.at(4)).multiplier, Rgb(0, 1, 0));
}

TEST_F(Dialects, SetALightAmongTheSettingsWhichIsWarnedAbout) {
    EXPECT_EQ(answer("GlobalSettings {\nlightPos (1, 2, 3)\nlightIntensity 5\n}"),
              "t.scene:2: lightPos has no effect; write a PointLight with pos, color and power "
              "instead\n"
              "t.scene:3: lightIntensity has no effect; write a PointLight with pos, color and "
              "power instead\n");
}

TEST_F(Dialects, HaveALensWithSphericalAberrationWhichIsReadAsACamera) {
    write_text(folder_ / "t.scene",
               "SphericalLensCamera c {\npos 1 2 3\nlensDist 2\nconvexity 0.4\n"
               "sensorScaling 3\n}\n");
    const Loaded result = load_scene(folder_ / "t.scene");
    EXPECT_EQ(result.scene.camera.position, Vec3d(1, 2, 3));
    ASSERT_EQ(result.warnings.size(), 1u);
    EXPECT_EQ(without_folder(result.warnings[0]),
              "t.scene:1: SphericalLensCamera is read as a Camera, whose lens has no spherical "
              "aberration; write Camera");
}

}  // namespace
}  // namespace luch
