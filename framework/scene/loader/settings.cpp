#include "framework/scene/loader/blocks.h"

#include <fmt/format.h>

#include <utility>

namespace luch::loader {
namespace {

/// Blocks that a scene has one of: a second one is read for its mistakes, but does not count.
bool is_first(Properties& block, bool& seen) {
    if (seen) {
        block.diagnostics().warn(block.block().line,
                                 fmt::format("there is a {} already, and the first one counts; "
                                             "remove one of the two",
                                             block.block().class_name));
    }
    return !std::exchange(seen, true);
}

}  // namespace

void read_settings(Properties& block, Loading& loading) {
    constexpr Range side{1, 16384};
    Settings settings;
    settings.frame.width = block.integer("frameWidth", settings.frame.width, side);
    settings.frame.height = block.integer("frameHeight", settings.frame.height, side);
    settings.ambient_light = block.color("ambientLight", settings.ambient_light);
    settings.background = block.color("backgroundColor", settings.background);
    settings.max_depth = block.integer("maxTraceDepth", settings.max_depth, {0, 256});
    settings.anti_aliasing = block.flag("wantAA", settings.anti_aliasing);
    settings.global_illumination = block.flag("gi", settings.global_illumination);
    settings.paths = block.integer("numPaths", settings.paths, {1, 1e6});
    settings.threads = block.integer("numThreads", settings.threads, {0, 1024});
    block.accept({"interactive", "prepassSamples", "foveatedRadius", "dbg"});
    for (const Property* line :
         block.lines({"lightPos", "lightColor", "lightPower", "lightIntensity"})) {
        loading.diagnostics.warn(line->line,
                                 fmt::format("{} has no effect; write a PointLight with pos, color "
                                             "and power instead",
                                             line->name));
    }
    if (is_first(block, loading.has_settings)) loading.scene.settings = settings;
}

void read_camera(Properties& block, Loading& loading) {
    Camera camera;
    camera.position = block.required_vector({"pos", "position"});
    camera.yaw_deg = block.number("yaw", camera.yaw_deg);
    camera.pitch_deg = block.number("pitch", camera.pitch_deg, {-90, 90});
    camera.roll_deg = block.number("roll", camera.roll_deg);
    camera.fov_deg = block.number("fov", camera.fov_deg, {0.0001, 179});
    camera.aspect = block.number({"aspectRatio", "aspect"}, camera.aspect, {1e-4, 1e4});
    camera.depth_of_field = block.flag("dof", camera.depth_of_field);
    camera.f_number = block.number("fNumber", camera.f_number, {0.5, 128});
    camera.focal_distance = block.number("focalPlaneDist", camera.focal_distance, {1e-3, 1e6});
    camera.auto_focus = block.flag("autoFocus", camera.auto_focus);
    camera.lens_samples = block.integer("numSamples", camera.lens_samples, {1, 1e6});
    camera.stereo_separation = block.number("stereoSeparation", camera.stereo_separation);
    if (is_first(block, loading.has_camera)) loading.scene.camera = camera;
}

void read_spherical_lens_camera(Properties& block, Loading& loading) {
    loading.diagnostics.warn(block.block().line,
                             "SphericalLensCamera is read as a Camera, whose lens has no spherical "
                             "aberration; write Camera");
    block.accept({"lensDist", "convexity", "sensorScaling"});
    read_camera(block, loading);
}

}  // namespace luch::loader
