#include "framework/scene/loader/blocks.h"

#include <fmt/format.h>

#include <string>

namespace luch::loader {
namespace {

/// Whether a block of which a scene has one is the first; a second one is read for its mistakes,
/// but does not count. `seen` is the class of the first, "" while there was none.
bool is_first(Properties& block, std::string& seen) {
    if (seen.empty()) {
        seen = block.block().class_name;
        return true;
    }
    block.diagnostics().warn(block.block().line,
                             fmt::format("the scene has its {} already, and the first one counts; "
                                         "remove one of the two",
                                         seen));
    return false;
}

/// What all cameras have.
Camera common_camera(Properties& block, Projection projection) {
    Camera camera;
    camera.projection = projection;
    camera.position = block.required_vector({"pos", "position"});
    camera.yaw_deg = block.number("yaw", camera.yaw_deg);
    camera.pitch_deg = block.number("pitch", camera.pitch_deg, {-90, 90});
    camera.roll_deg = block.number("roll", camera.roll_deg);
    camera.aspect = block.number({"aspectRatio", "aspect"}, camera.aspect, {1e-4, 1e4});
    camera.depth_of_field = block.flag("dof", camera.depth_of_field);
    camera.f_number = block.number("fNumber", camera.f_number, {0.5, 128});
    camera.focal_distance = block.number("focalPlaneDist", camera.focal_distance, {1e-3, 1e6});
    camera.auto_focus = block.flag("autoFocus", camera.auto_focus);
    camera.lens_samples = block.integer("numSamples", camera.lens_samples, {1, 1e6});
    camera.stereo_separation = block.number("stereoSeparation", camera.stereo_separation);
    if (camera.depth_of_field && !camera.has_lens()) {
        block.diagnostics().warn(block.find("dof")->line,
                                 fmt::format("dof is ignored: a {} has no lens; use a Camera, or "
                                             "remove the line",
                                             block.block().class_name));
    }
    return camera;
}

void keep_first(Properties& block, Loading& loading, const Camera& camera) {
    if (is_first(block, loading.camera_class)) loading.scene.camera = camera;
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
    if (is_first(block, loading.settings_class)) loading.scene.settings = settings;
}

void read_camera(Properties& block, Loading& loading) {
    Camera camera = common_camera(block, Projection::perspective);
    camera.fov_deg = block.number("fov", camera.fov_deg, {0.0001, 179});
    keep_first(block, loading, camera);
}

void read_fisheye_camera(Properties& block, Loading& loading) {
    Camera camera = common_camera(block, Projection::fisheye);
    camera.fov_deg = block.number("fov", 180, {1, 360});
    keep_first(block, loading, camera);
}

void read_spherical_camera(Properties& block, Loading& loading) {
    keep_first(block, loading, common_camera(block, Projection::spherical));
}

void read_orthographic_camera(Properties& block, Loading& loading) {
    Camera camera = common_camera(block, Projection::orthographic);
    camera.width = block.number("width", camera.width, positive);
    keep_first(block, loading, camera);
}

void read_spherical_lens_camera(Properties& block, Loading& loading) {
    loading.diagnostics.warn(block.block().line,
                             "SphericalLensCamera is read as a Camera, whose lens has no spherical "
                             "aberration; write Camera");
    block.accept({"lensDist", "convexity", "sensorScaling"});
    read_camera(block, loading);
}

}  // namespace luch::loader
