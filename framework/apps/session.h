#pragma once

#include "framework/apps/arguments.h"
#include "framework/technique/run.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace luch {

/// The options that every verb with a scene shares.
struct SceneOptions {
    std::string size;  ///< "WxH", "" as the scene says
    int spp = 0;
    int threads = 0;
    std::uint64_t seed = 0;
    std::string camera;  ///< "x,y,z,yaw,pitch[,roll[,fov]]", "" as the scene says
    std::string root;
    std::string backend = "luch";
    bool strict = false;
    bool no_skip = false;
    std::vector<std::string> forced;  ///< stages

    void declare(Arguments& arguments);
};

/// A loaded scene with everything needed to run techniques on it.
class Session {
 public:
    /// Loads the scene (warnings go to standard error), builds the accelerator, starts the threads.
    Session(const std::string& scene_file, const SceneOptions& options);

    [[nodiscard]] const Scene& scene() const { return *scene_; }
    [[nodiscard]] const Shot& shot() const { return shot_; }
    [[nodiscard]] Studio studio() const { return {*scene_, *accelerator_, workers_}; }
    [[nodiscard]] const Budget& budget() const { return budget_; }
    /// Whose bytes the scene is made of; see Loaded::files.
    [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }
    [[nodiscard]] double load_ms() const { return load_ms_; }
    [[nodiscard]] double build_ms() const { return build_ms_; }

 private:
    std::unique_ptr<Scene> scene_;
    std::unique_ptr<Accelerator> accelerator_;
    Workers workers_;
    Shot shot_;
    Budget budget_;
    std::vector<std::filesystem::path> files_;
    double load_ms_ = 0, build_ms_ = 0;
};

/// A technique of the catalogue with "key=value" parameters set.
std::unique_ptr<Technique> make_technique(const std::string& name,
                                          const std::vector<std::string>& params = {});

/// A camera put where "x,y,z,yaw,pitch[,roll[,fov]]" says, degrees. Throws Error that names the
/// option when the text says something else.
Camera moved_camera(Camera camera, const std::string& text, const std::string& option);

/// What renders a scene when nobody says: the path tracer where it asks for global illumination
/// (gi), else the baseline.
std::string default_technique(const Scene& scene);

/// "640x480" → {640, 480}. Throws Error when it is anything else, or a side is not in 1..16384.
Size parsed_size(const std::string& text);

}  // namespace luch
