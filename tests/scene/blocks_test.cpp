#include "framework/image/io.h"
#include "tests/scene/scene_file.h"

#include <numbers>

namespace luch {
namespace {

using Blocks = SceneFile;

template <class T>
const T& only(const auto& all) {
    EXPECT_EQ(all.size(), 1u);
    return std::get<T>(all.at(0));
}

TEST_F(Blocks, HaveTheDocumentedDefaults) {
    const Scene scene = loaded("GlobalSettings {\n}").scene;
    EXPECT_EQ(scene.settings.frame, (Size{800, 600}));
    EXPECT_EQ(scene.settings.ambient_light, Rgb(0.15f));
    EXPECT_EQ(scene.settings.background, Rgb(0));
    EXPECT_EQ(scene.settings.max_depth, 8);
    EXPECT_TRUE(scene.settings.anti_aliasing);
    EXPECT_FALSE(scene.settings.global_illumination);
    EXPECT_EQ(scene.camera.fov_deg, 90);
    EXPECT_EQ(scene.camera.aspect, 4.0 / 3);
    EXPECT_EQ(scene.camera.lens_samples, 32);
    EXPECT_EQ(scene.name, "t");
}

TEST_F(Blocks, SetEverySetting) {
    const Settings settings = loaded(
                                  "GlobalSettings {\nframeWidth 64\nframeHeight 48\n"
                                  "ambientLight 0.1 0.2 0.3\nbackgroundColor 0.4 0.5 0.6\n"
                                  "maxTraceDepth 3\nwantAA off\ngi on\nnumPaths 7\nnumThreads 2\n"
                                  "interactive on\nprepassSamples 3\nfoveatedRadius 9\ndbg 1\n}",
                                  true)
                                  .scene.settings;
    EXPECT_EQ(settings.frame, (Size{64, 48}));
    EXPECT_EQ(settings.ambient_light, Rgb(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(settings.background, Rgb(0.4f, 0.5f, 0.6f));
    EXPECT_EQ(settings.max_depth, 3);
    EXPECT_FALSE(settings.anti_aliasing);
    EXPECT_TRUE(settings.global_illumination);
    EXPECT_EQ(settings.paths, 7);
    EXPECT_EQ(settings.threads, 2);
}

TEST_F(Blocks, SetTheWholeCameraAndTheFirstOneCounts) {
    const Loaded result = loaded(
        "Camera c {\npos 1 2 3\nyaw 4\npitch 5\nroll 6\nfov 7\naspect 2\n"
        "dof on\nfNumber 2.8\nfocalPlaneDist 9\nautoFocus on\n"
        "numSamples 10\nstereoSeparation 0.5\n}");
    const Camera& camera = result.scene.camera;
    EXPECT_EQ(camera.position, Vec3d(1, 2, 3));
    EXPECT_EQ(camera.yaw_deg, 4);
    EXPECT_EQ(camera.pitch_deg, 5);
    EXPECT_EQ(camera.roll_deg, 6);
    EXPECT_EQ(camera.fov_deg, 7);
    EXPECT_EQ(camera.aspect, 2);
    EXPECT_TRUE(camera.depth_of_field);
    EXPECT_EQ(camera.f_number, 2.8);
    EXPECT_EQ(camera.focal_distance, 9);
    EXPECT_TRUE(camera.auto_focus);
    EXPECT_EQ(camera.lens_samples, 10);
    EXPECT_EQ(camera.stereo_separation, 0.5);
    ASSERT_EQ(result.warnings.size(), 1u);
    EXPECT_EQ(
        without_folder(result.warnings[0]),
        "t.scene:15: the scene has its Camera already, and the first one counts; remove one of the "
        "two");
}

TEST_F(Blocks, SetEveryKindOfCameraWithItsOwnDefaults) {
    const auto camera = [&](const std::string& text) { return loaded(text).scene.camera; };
    const Camera fisheye = camera("FisheyeCamera c {\npos 1 2 3\nyaw 4\naspect 2\n}");
    EXPECT_EQ(fisheye.projection, Projection::fisheye);
    EXPECT_EQ(fisheye.fov_deg, 180);
    EXPECT_EQ(fisheye.position, Vec3d(1, 2, 3));
    EXPECT_EQ(fisheye.yaw_deg, 4);
    EXPECT_EQ(fisheye.aspect, 2);
    EXPECT_EQ(camera("FisheyeCamera c {\npos 1 2 3\nfov 222\n}").fov_deg, 222);
    EXPECT_EQ(camera("SphericalCamera c {\npos 1 2 3\n}").projection, Projection::spherical);
    const Camera parallel = camera("OrthographicCamera c {\npos 1 2 3\n}");
    EXPECT_EQ(parallel.projection, Projection::orthographic);
    EXPECT_EQ(parallel.width, 10);
    EXPECT_EQ(camera("OrthographicCamera c {\npos 1 2 3\nwidth 7\n}").width, 7);
}

TEST_F(Blocks, ReadLights) {
    const Scene scene = loaded(
                            "PointLight p {\npos 1 2 3\ncolor 4 5 6\npower 7\n}\n"
                            "RectLight r {\ncolor 1 0.5 0\npower 8\nxSubd 2\nySubd 5\n"
                            "scale 4 1 2\ntranslate 0 9 0\n}")
                            .scene;
    const auto& point = std::get<PointLight>(scene.lights.at(0));
    EXPECT_EQ(point.position, Vec3d(1, 2, 3));
    EXPECT_EQ(point.color, Rgb(4, 5, 6));
    EXPECT_EQ(point.power, 7);
    const auto& rect = std::get<RectLight>(scene.lights.at(1));
    EXPECT_EQ(rect.x_samples, 2);
    EXPECT_EQ(rect.y_samples, 5);
    EXPECT_EQ(rect.to_world.point({0.5, 0, 0.5}), Vec3d(2, 9, 1));
    // Its visible face is a node whose radiance is color · power / area.
    ASSERT_EQ(scene.nodes.size(), 1u);
    const auto& face = std::get<Emission>(scene.materials.at(scene.nodes[0].material));
    EXPECT_EQ(face.radiance, Rgb(1, 0.5f, 0));
}

TEST_F(Blocks, ReadShapes) {
    const Scene scene = loaded(
                            "Plane {\ny 2\nlimit 7\n}\nSphere {\nO 1 2 3\nR 4\nuvscaling 5\n}\n"
                            "Cube {\nO 1 2 3\nside 4\n}\nCube {\nhalfSide 3\n}\nPlane {\n}",
                            true)
                            .scene;
    EXPECT_EQ(std::get<Plane>(scene.geometries[0]).y, 2);
    EXPECT_EQ(std::get<Plane>(scene.geometries[0]).limit, 7);
    const auto& sphere = std::get<Sphere>(scene.geometries[1]);
    EXPECT_EQ(sphere.centre, Vec3d(1, 2, 3));
    EXPECT_EQ(sphere.radius, 4);
    EXPECT_EQ(sphere.uv_scaling, 5);
    EXPECT_EQ(std::get<Cube>(scene.geometries[2]).centre, Vec3d(1, 2, 3));
    EXPECT_EQ(std::get<Cube>(scene.geometries[2]).side, 4);
    EXPECT_EQ(std::get<Cube>(scene.geometries[3]).side, 6);
    EXPECT_TRUE(std::isinf(std::get<Plane>(scene.geometries[4]).limit));
}

TEST_F(Blocks, ReadShaders) {
    const Scene scene =
        loaded(
            "Checker t {\n}\nLambert l {\ncolor 0.1 0.2 0.3\ntexture t\n}\n"
            "Phong p {\nspecular 2\nexponent 3\n}\nReflection r {\nreflColor 1 0 1\n"
            "glossiness 0.5\nnumSamples 9\n}\nRefl m {\nmultiplier 0.25\n}\nConst c {\n"
            "color 7 8 9\n}\nLayered {\nlayer c (1, 2, 3)\nlayer r 4 5 6 t\n}",
            true)
            .scene;
    EXPECT_EQ(std::get<Lambert>(scene.materials[0]).color, Rgb(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(std::get<Lambert>(scene.materials[0]).texture, 0u);
    const auto& phong = std::get<Phong>(scene.materials[1]);
    EXPECT_EQ(phong.color, Rgb(0.5f));
    EXPECT_EQ(phong.texture, no_texture);
    EXPECT_EQ(phong.specular, Rgb(2));
    EXPECT_EQ(phong.exponent, 3);
    const auto& reflection = std::get<Reflection>(scene.materials[2]);
    EXPECT_EQ(reflection.multiplier, Rgb(1, 0, 1));
    EXPECT_EQ(reflection.glossiness, 0.5);
    EXPECT_EQ(reflection.samples, 9);
    EXPECT_EQ(std::get<Reflection>(scene.materials[3]).multiplier, Rgb(0.25f));
    EXPECT_EQ(std::get<Const>(scene.materials[4]).color, Rgb(7, 8, 9));
    const auto& layers = std::get<Layered>(scene.materials[5]).layers;
    ASSERT_EQ(layers.size(), 2u);
    EXPECT_EQ(layers[0].material, 4u);
    EXPECT_EQ(layers[0].blend, Rgb(1, 2, 3));
    EXPECT_EQ(layers[0].texture, no_texture);
    EXPECT_EQ(layers[1].material, 2u);
    EXPECT_EQ(layers[1].texture, 0u);
}

TEST_F(Blocks, DecodePicturesWithTheGammaTheSceneAssumes) {
    write_picture(folder_ / "p.png", Image<Rgb>({1, 1}, Rgb(srgb_decoded(0.5f))).view());
    const auto value = [&](const std::string& line) {
        const Scene scene = loaded("BitmapTexture {\nfile p.png\n" + line + "\n}").scene;
        return only<BitmapTexture>(scene.textures).pixels(0, 0).r;
    };
    const float stored = 128 / 255.0f;
    EXPECT_FLOAT_EQ(value(""), stored);
    EXPECT_FLOAT_EQ(value("assumedGamma 2.2"), srgb_decoded(stored));
    EXPECT_FLOAT_EQ(value("assumedGamma 1.5"), std::pow(stored, 1.5f));
}

TEST_F(Blocks, ReadBumpsAsSlopes) {
    Image<Rgb> heights({2, 1}, Rgb(0));
    heights(0, 0) = Rgb(1);
    write_picture(folder_ / "p.png", heights.view());
    const Scene scene = loaded("BumpTexture {\nfile p.png\nstrength 3\nscaling 2\n}").scene;
    const auto& bump = only<BumpTexture>(scene.textures);
    EXPECT_EQ(bump.slopes(0, 0), Vec2(1, 0));
    EXPECT_EQ(bump.strength, 3);
    EXPECT_EQ(bump.scaling, 2);
}

TEST_F(Blocks, FindTheSidesOfACubemapUnderAnyEnding) {
    int brightness = 0;
    for (const char* name :
         {"negx.bmp", "negy.png", "negz.exr", "posx.hdr", "posy.bmp", "posz.bmp", "posz.png"}) {
        const float value = srgb_decoded(static_cast<float>(10 * ++brightness) / 255);
        write_picture(folder_ / "sky" / name, Image<Rgb>({2, 2}, Rgb(value)).view());
    }
    const Scene scene = loaded("CubemapEnvironment {\nfolder sky\n}").scene;
    ASSERT_TRUE(scene.environment);
    EXPECT_FLOAT_EQ(
        std::get<CubemapEnvironment>(*scene.environment).sides[CubemapEnvironment::neg_x](0, 0).r,
        10 / 255.0f);
    EXPECT_FLOAT_EQ(
        std::get<CubemapEnvironment>(*scene.environment).sides[CubemapEnvironment::neg_y](0, 0).r,
        20 / 255.0f);
    EXPECT_NEAR(
        std::get<CubemapEnvironment>(*scene.environment).sides[CubemapEnvironment::neg_z](0, 0).r,
        srgb_decoded(30 / 255.0f), 1e-4);
    EXPECT_FLOAT_EQ(
        std::get<CubemapEnvironment>(*scene.environment).sides[CubemapEnvironment::pos_z](0, 0).r,
        60 / 255.0f);
}

TEST_F(Blocks, DrawNoNodeWithoutAShader) {
    EXPECT_TRUE(loaded("Plane g {\n}\nNode {\ngeometry g\n}").scene.nodes.empty());
}

Transform transform_of(const Scene& scene) {
    return scene.nodes.at(0).to_world;
}

const std::string node = "Plane g {\n}\nLambert s {\n}\nNode {\ngeometry g\nshader s\n";

TEST_F(Blocks, NeitherRotateNorScaleATranslation) {
    const Transform first =
        transform_of(loaded(node + "translate 1 2 3\nscale 2 2 2\nrotate 90 0 0\n}").scene);
    const Transform last =
        transform_of(loaded(node + "scale 2 2 2\nrotate 90 0 0\ntranslate 1 2 3\n}").scene);
    EXPECT_EQ(first.offset, Vec3d(1, 2, 3));
    EXPECT_LT(max_norm(first.point({4, 5, 6}) - last.point({4, 5, 6})), 1e-12);
}

TEST_F(Blocks, ScaleAndRotateInTheOrderOfTheirLines) {
    // Yaw by 90° sends z to −x; a later scale of x stretches that, an earlier one of z too.
    const Transform rotated_first =
        transform_of(loaded(node + "rotate 90 0 0\nscale 5 1 1\n}").scene);
    EXPECT_LT(max_norm(rotated_first.direction({0, 0, 1}) - Vec3d(-5, 0, 0)), 1e-12);
    const Transform scaled_first =
        transform_of(loaded(node + "scale 5 1 1\nrotate 90 0 0\n}").scene);
    EXPECT_LT(max_norm(scaled_first.direction({0, 0, 1}) - Vec3d(-1, 0, 0)), 1e-12);
}

TEST_F(Blocks, AddUpTransformLinesOfOneKind) {
    const Transform transform = transform_of(
        loaded(node + "scale 2 2 2\nscale 3 1 1\ntranslate 1 0 0\ntranslate 0 1 0\n}", true).scene);
    EXPECT_EQ(transform.point({1, 1, 1}), Vec3d(7, 3, 2));
}

TEST_F(Blocks, PutAMeshesOwnFrameBeforeItsNode) {
    write_text(folder_ / "m.obj", "v 100 0 0\nv 104 0 0\nv 100 8 0\nf 1 2 3\n");
    const Scene scene = loaded(
                            "Mesh m {\nfile m.obj\n}\nLambert s {\n}\nNode {\ngeometry m\n"
                            "shader s\nscale 2 2 2\ntranslate 0 0 1\n}")
                            .scene;
    const auto& mesh = std::get<Mesh>(scene.geometries[0]);
    const Vec3d world = scene.nodes[0].to_world.point(Vec3d(mesh.corner(0, 2)));
    EXPECT_LT(max_norm(world - Vec3d(200, 16, 1)), 1e-12);
}

TEST_F(Blocks, RefuseMorePicturesThanFitByTheirHeaders) {
    write_picture(folder_ / "small.tga", Image<Rgb>({1, 1}).view());
    // A header of 16,384 × 16,384 pixels, which is all that a scene may have, and enough bytes for
    // it not to look damaged.
    std::string bytes = read_text(folder_ / "small.tga").substr(0, 18);
    bytes[12] = bytes[14] = 0;
    bytes[13] = bytes[15] = 0x40;
    write_text(folder_ / "large.tga", bytes + std::string(200000, '\0'));
    EXPECT_EQ(answer("BitmapTexture {\nfile small.tga\n}\nBitmapTexture {\nfile large.tga\n}"),
              "t.scene:5: large.tga: brings the scene's pictures over 256 megapixels; make them "
              "smaller");
}

}  // namespace
}  // namespace luch
