#include "framework/apps/ray_log.h"

#include "framework/base/error.h"
#include "framework/base/files.h"
#include "framework/base/text.h"
#include "framework/image/io.h"
#include "framework/measure/ray_view.h"

#include <fmt/format.h>

namespace luch {
namespace {

Camera second_camera(const Session& session, const RayLogOptions& options, const RayLog& log) {
    const Studio studio = session.studio();
    const Camera chosen = overview_camera(log, studio.accelerator, session.shot().size);
    if (options.camera.empty()) return chosen;
    return moved_camera(chosen, options.camera, "--log-camera");
}

Json camera_json(const Camera& camera) {
    return Json::object()
        .set("position",
             Json::array().push(camera.position.x).push(camera.position.y).push(camera.position.z))
        .set("yaw", camera.yaw_deg)
        .set("pitch", camera.pitch_deg)
        .set("roll", camera.roll_deg)
        .set("fov", camera.fov_deg);
}

}  // namespace

void RayLogOptions::declare(Arguments& arguments) {
    arguments.option("--ray-log", pixel, "X,Y",
                     "write the tree of that pixel's rays: NAME-rays.json, .png and .svg");
    arguments.option("--log-camera", camera, "X,Y,Z,YAW,PITCH[,ROLL[,FOV]]",
                     "draw those rays as seen from here [chosen]");
}

std::optional<Watch> RayLogOptions::watch(Size frame, RayLog& log) const {
    if (pixel.empty()) {
        if (camera.empty()) return std::nullopt;
        throw Error("--log-camera draws what --ray-log X,Y records; give both");
    }
    const auto pieces = split(pixel, ',');
    const auto coordinate = [&](std::size_t i, int side) {
        const auto number =
            pieces.size() == 2 ? parsed_number(trimmed(pieces[i])) : std::optional<double>();
        if (!number || *number < 0 || *number >= side || *number != std::floor(*number)) {
            throw Error(
                fmt::format("--ray-log {}: give a pixel X,Y of the {}x{} frame, 0,0 is the "
                            "top left one",
                            pixel, frame.width, frame.height));
        }
        return static_cast<int>(*number);
    };
    return Watch{coordinate(0, frame.width), coordinate(1, frame.height), &log};
}

void write_ray_log(const Session& session, const RayLogOptions& options, const Watch& watch,
                   const std::filesystem::path& picture) {
    const RayLog& log = *watch.log;
    const Scene& scene = session.scene();
    Shot shot = session.shot();
    shot.camera = second_camera(session, options, log);
    shot.spp = 0;
    const auto base = (picture.parent_path() / picture.stem()).string() + "-rays";
    const auto baseline = make_technique("baseline");
    const Outcome seen = run(*baseline, session.studio(), shot, {}, {.warm_up = 0, .frames = 1});
    write_picture(base + ".png", seen.frame.colour.view());
    const Screen screen(shot.camera, shot.size);
    const auto strokes = ray_strokes(log, session.studio().accelerator, screen);
    write_text(base + ".svg", ray_svg(log, scene, strokes, shot.size, base + ".png"));
    Json::object()
        .set("scene", scene.name)
        .set("pixel", Json::array().push(watch.x).push(watch.y))
        .set("camera", camera_json(session.shot().camera))
        .set("log_camera", camera_json(shot.camera))
        .set("rays", ray_log_json(log, scene))
        .write(base + ".json");
    fmt::print("{} rays of pixel {},{}: {}.json .png .svg\n", log.rays().size(), watch.x, watch.y,
               base);
}

}  // namespace luch
