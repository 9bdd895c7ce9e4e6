#include "framework/measure/ray_view.h"

#include "framework/base/files.h"
#include "framework/image/io.h"
#include "tests/testing/everything.h"
#include "tests/testing/own_folder.h"
#include "tests/testing/scenes.h"
#include "tests/testing/shell.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace luch {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A wall across x = 0 and two rays through the air: one in front of it, one that a box hides in
/// the middle; and a shadow ray that ends at the box half-way.
struct Drawn {
    Scene scene = testing::empty_scene();
    std::unique_ptr<Accelerator> accelerator;
    RayLog log;
    Camera camera;
    Size size{200, 200};

    Drawn() {
        testing::add(scene, Cube{.centre = {0, 0, 0}, .side = 2}, Const{});
        scene.nodes[0].name = "a box & more";
        accelerator = build_accelerator(scene);
        const Ray in_front{{-4, 0, -3}, {1, 0, 0}, 0, 8};
        const Ray behind{{-4, 0, 3}, {1, 0, 0}, 0, 8};
        Hit end;
        end.t = 8;
        end.node = 0;
        log.closest(RayKind::primary, {&in_front, 1}, {&end, 1});
        log.closest(RayKind::glossy, {&behind, 1}, {&end, 1});
        const Ray through{{-4, 2, 0}, {8, -2, 0}, 0, 1};
        end.t = 0.5;
        log.occluded(RayKind::shadow, {&through, 1}, {&end, 1});
        camera.position = {0, 0, -20};
        camera.aspect = 1;
        camera.fov_deg = 60;
    }
    [[nodiscard]] std::vector<RayStroke> strokes(int ray) const {
        std::vector<RayStroke> some;
        for (const RayStroke& stroke : ray_strokes(log, *accelerator, Screen(camera, size))) {
            if (stroke.ray == ray) some.push_back(stroke);
        }
        return some;
    }
};

TEST(RayView, DrawsARayInOnePieceBetweenItsEnds) {
    const Drawn drawn;
    const auto strokes = drawn.strokes(0);
    ASSERT_EQ(strokes.size(), 1u);
    EXPECT_FALSE(strokes[0].hidden);
    const Screen screen(drawn.camera, drawn.size);
    const Vec2d from = *screen.project(screen.to_view({-4, 0, -3}));
    const Vec2d to = *screen.project(screen.to_view({4, 0, -3}));
    EXPECT_NEAR(glm::distance(strokes[0].from_px, from), 0, 1e-9);
    EXPECT_NEAR(glm::distance(strokes[0].to_px, to), 0, 1e-9);
}

TEST(RayView, HidesWhatLiesBehindASurface) {
    const auto strokes = Drawn().strokes(1);
    ASSERT_EQ(strokes.size(), 3u);
    EXPECT_FALSE(strokes[0].hidden);
    EXPECT_TRUE(strokes[1].hidden);
    EXPECT_FALSE(strokes[2].hidden);
    EXPECT_EQ(strokes[0].to_px, strokes[1].from_px);
    EXPECT_EQ(strokes[1].to_px, strokes[2].from_px);
}

TEST(RayView, MarksTheBlockedPartOfAShadowRay) {
    const auto strokes = Drawn().strokes(2);
    ASSERT_GE(strokes.size(), 2u);
    EXPECT_FALSE(strokes.front().blocked);
    EXPECT_TRUE(strokes.back().blocked);
}

TEST(RayView, ChoosesACameraThatSeesTheRays) {
    const Drawn drawn;
    const Camera camera = overview_camera(drawn.log, *drawn.accelerator, drawn.size);
    const Screen screen(camera, drawn.size);
    for (const LoggedRay& ray : drawn.log.rays()) {
        for (const Vec3d& end : {ray.ray.origin, ray.end()}) {
            const auto at = screen.project(screen.to_view(end));
            ASSERT_TRUE(at);
            EXPECT_TRUE(at->x > 0 && at->x < 200 && at->y > 0 && at->y < 200);
        }
    }
    int hidden = 0, all = 0;
    for (const RayStroke& stroke : ray_strokes(drawn.log, *drawn.accelerator, screen)) {
        ++all;
        hidden += stroke.hidden ? 1 : 0;
    }
    EXPECT_LT(2 * hidden, all);
}

TEST(RayView, OfNoRaysIsACameraAllTheSame) {
    const Drawn drawn;
    EXPECT_TRUE(all_finite(overview_camera(RayLog(), *drawn.accelerator, {64, 48}).position));
}

TEST(RaySvg, HoldsThePictureTheLinesAndALegend) {
    const Drawn drawn;
    const auto folder = own_folder();
    write_picture(folder / "scene.png", Image<Rgb>({4, 4}, Rgb(0.2f)).view());
    const auto strokes =
        ray_strokes(drawn.log, *drawn.accelerator, Screen(drawn.camera, drawn.size));
    const std::string svg =
        ray_svg(drawn.log, drawn.scene, strokes, drawn.size, folder / "scene.png");
    std::filesystem::remove_all(folder);
    EXPECT_THAT(svg, HasSubstr("href=\"data:image/png;base64,"));
    EXPECT_THAT(svg, HasSubstr("viewBox=\"0 0 200 200\""));
    EXPECT_THAT(svg, HasSubstr(">primary 1<"));
    EXPECT_THAT(svg, HasSubstr(">glossy 1<"));
    EXPECT_THAT(svg, HasSubstr(">blocked 1<"));
    EXPECT_THAT(svg, Not(HasSubstr(">reflection")));
    EXPECT_THAT(svg, HasSubstr("meets a box &amp; more"));
    EXPECT_THAT(svg, HasSubstr("opacity=\"0.28\""));
    EXPECT_THAT(svg, HasSubstr("#ffd400"));
}

/// luch render with these arguments, in a folder of its own, on a small scene.
Ran luch_render(const std::filesystem::path& folder, const std::string& arguments) {
    write_text(folder / "t.scene",
               "GlobalSettings {\nframeWidth 16\nframeHeight 12\n}\n"
               "Camera camera {\npos 0 5 -9\npitch -20\n}\n"
               "PointLight lamp {\npos 0 9 0\npower 80\n}\nPlane floor {\n}\n"
               "Reflection mirror {\n}\nNode floor {\ngeometry floor\nshader mirror\n}\n"
               "Sphere ball {\nO 0 2 0\n}\nLambert white {\n}\n"
               "Node ball {\ngeometry ball\nshader white\n}\n");
    return shell("cd '" + folder.string() +
                 "' && '" LUCH_PROGRAM "' render t.scene -o picture.png " + arguments);
}

TEST(RayLogOption, WritesTreeAndPictures) {
    const auto folder = own_folder();
    const Ran ran = luch_render(folder, "--ray-log 8,6");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_THAT(ran.text, HasSubstr("rays of pixel 8,6: picture-rays.json .png .svg"));
    EXPECT_THAT(read_text(folder / "picture-rays.json"), HasSubstr("\"kind\": \"primary\""));
    EXPECT_THAT(read_text(folder / "picture-rays.svg"), HasSubstr("<svg"));
    EXPECT_EQ(picture_size(folder / "picture-rays.png"), (Size{16, 12}));
    const std::string watched = read_text(folder / "picture.png");
    luch_render(folder, "");
    EXPECT_TRUE(watched == read_text(folder / "picture.png"));
    std::filesystem::remove_all(folder);
}

TEST(RayLogOption, IsSeenFromACameraOfOnesOwn) {
    const auto folder = own_folder();
    const Ran ran = luch_render(folder, "--ray-log 8,6 --log-camera 1,2,3,40,-50,6,70");
    EXPECT_EQ(ran.status, 0) << ran.text;
    const std::string json = read_text(folder / "picture-rays.json");
    std::filesystem::remove_all(folder);
    EXPECT_THAT(json.substr(json.find("log_camera")), HasSubstr("\"yaw\": 40.0"));
}

TEST(RayLogOption, RefusesWhatItCannotDo) {
    const auto folder = own_folder();
    const auto answer = [&](const std::string& arguments) {
        const Ran ran = luch_render(folder, arguments);
        EXPECT_EQ(ran.status, 2);
        return ran.text;
    };
    const std::string pixel = "give a pixel X,Y of the 16x12 frame, 0,0 is the top left one\n";
    EXPECT_EQ(answer("--ray-log 16,0"), "luch: --ray-log 16,0: " + pixel);
    EXPECT_EQ(answer("--ray-log 3"), "luch: --ray-log 3: " + pixel);
    EXPECT_EQ(answer("--ray-log 1,1 --frames 3"),
              "luch: --ray-log records one frame; leave --frames out\n");
    EXPECT_EQ(answer("--log-camera 1,2,3,4,5"),
              "luch: --log-camera draws what --ray-log X,Y records; give both\n");
    EXPECT_THAT(answer("--ray-log 1,1 --log-camera 1,2"),
                HasSubstr("luch: --log-camera: give x,y,z,yaw,pitch"));
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace luch
