#include "framework/apps/session.h"

#include "framework/base/error.h"
#include "framework/base/text.h"
#include "framework/scene/loader/loader.h"
#include "framework/technique/catalogue.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstdio>

namespace luch {
namespace {

double ms_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

void set_field_of_view(Camera& camera, double fov_deg, const std::string& option) {
    if (camera.projection == Projection::spherical ||
        camera.projection == Projection::orthographic) {
        throw Error(option +
                    ": this scene's camera has no field of view; leave the last number out");
    }
    const bool fisheye = camera.projection == Projection::fisheye;
    if (!(fov_deg >= (fisheye ? 1 : 1e-4) && fov_deg <= (fisheye ? 360 : 179))) {
        throw Error(fmt::format("{}: the field of view is not in {}", option,
                                fisheye ? "1..360, as a fisheye's is" : "0.0001..179"));
    }
    camera.fov_deg = fov_deg;
}

int checked_threads(int threads) {
    if (threads >= 0 && threads <= Workers::most_threads) return threads;
    throw Error(fmt::format("--threads {}: give 1 to {}, or 0 for all cores", threads,
                            Workers::most_threads));
}

}  // namespace

void SceneOptions::declare(Arguments& arguments) {
    arguments.option("--size", size, "WxH", "frame size in pixels [the scene's]");
    arguments.option("--spp", spp, "N",
                     "samples a pixel: 1 its centre, more: random; 0: as the scene says, adaptive");
    arguments.option("--threads", threads, "N", "threads; 0: one for every core");
    arguments.option("--seed", seed, "N", "of all random numbers");
    arguments.option("--camera", camera, "X,Y,Z,YAW,PITCH[,ROLL[,FOV]]",
                     "look from elsewhere; degrees");
    arguments.option("--root", root, "DIR", "the scene may read files under this folder only");
    arguments.option("--backend", backend, "NAME",
                     "luch, or embree where it is installed: finds the triangles; pictures differ "
                     "at most where two are at the same distance, or at a rim, by rounding");
    arguments.flag("--strict", strict, "warnings about the scene file are errors");
    arguments.flag("--no-skip", no_skip,
                   "run every stage, also those that the scene does not need");
    arguments.option("--force", forced, "STAGE",
                     "run this stage of the plan, needed or not (luch plan lists them)");
}

Camera moved_camera(Camera camera, const std::string& text, const std::string& option) {
    std::vector<double> numbers;
    for (const std::string& piece : split(text, ',')) {
        const auto number = parsed_number(trimmed(piece));
        if (!number) throw Error(option + ": \"" + piece + "\" is not a number");
        numbers.push_back(*number);
    }
    if (numbers.size() < 5 || numbers.size() > 7) {
        throw Error(option + ": give x,y,z,yaw,pitch and, if you like, roll and fov, in degrees");
    }
    camera.position = {numbers[0], numbers[1], numbers[2]};
    camera.yaw_deg = numbers[3];
    camera.pitch_deg = numbers[4];
    if (numbers.size() > 5) camera.roll_deg = numbers[5];
    if (!(std::abs(camera.pitch_deg) <= 90)) throw Error(option + ": the pitch is not in -90..90");
    if (numbers.size() > 6) set_field_of_view(camera, numbers[6], option);
    return camera;
}

Size parsed_size(const std::string& text) {
    constexpr int largest = 16384;
    const auto sides = split(text, 'x');
    std::array<double, 2> numbers{};
    for (std::size_t i = 0; i < 2; ++i) {
        const auto number = sides.size() == 2 ? parsed_number(sides[i]) : std::nullopt;
        if (!number || *number < 1 || *number > largest || *number != std::floor(*number)) {
            throw Error(fmt::format("\"{}\" is not a frame size; write 640x480, each side 1 to {}",
                                    text, largest));
        }
        numbers[i] = *number;
    }
    return {static_cast<int>(numbers[0]), static_cast<int>(numbers[1])};
}

/// Whether a stage is forced that the accelerator would leave out.
bool forces_accelerator(const std::vector<std::string>& forced) {
    return std::ranges::any_of(forced, [](const std::string& stage) {
        return stage == name_of(Part::transforms).name || stage == name_of(Part::scene_tree).name;
    });
}

Session::Session(const std::string& scene_file, const SceneOptions& options)
    : workers_(checked_threads(options.threads)) {
    if (options.spp < 0 || options.spp > 1'000'000) {
        throw Error(
            fmt::format("--spp {}: give 1 to 1000000, or 0 for the scene's own", options.spp));
    }
    const Backend backend = parsed_backend(options.backend);
    const auto loading = std::chrono::steady_clock::now();
    Loaded loaded = load_scene(scene_file, {.root = options.root, .strict = options.strict});
    for (const std::string& warning : loaded.warnings) {
        std::fprintf(stderr, "luch: warning: %s\n", warning.c_str());
    }
    scene_ = std::make_unique<Scene>(std::move(loaded.scene));
    files_ = std::move(loaded.files);
    load_ms_ = ms_since(loading);
    const auto building = std::chrono::steady_clock::now();
    accelerator_ = build_accelerator(*scene_, parsed_isa(""), backend,
                                     !options.no_skip && !forces_accelerator(options.forced));
    build_ms_ = ms_since(building);
    shot_ = shot_of(*scene_);
    if (!options.size.empty()) shot_.size = parsed_size(options.size);
    if (!options.camera.empty())
        shot_.camera = moved_camera(shot_.camera, options.camera, "--camera");
    shot_.spp = options.spp;
    shot_.seed = options.seed;
    budget_.skip = !options.no_skip;
    budget_.forced = options.forced;
}

std::string default_technique(const Scene& scene) {
    return scene.settings.global_illumination ? "path" : "baseline";
}

std::unique_ptr<Technique> make_technique(const std::string& name,
                                          const std::vector<std::string>& params) {
    auto technique = find_technique(name).create();
    for (const std::string& assignment : params) set_param(*technique, assignment);
    return technique;
}

}  // namespace luch
