#pragma once

#include "framework/base/error.h"
#include "framework/scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace luch {

struct LoadOptions {
    /// Files outside this folder are refused. Empty: the working directory when the scene lies
    /// under it, else the scene's own folder.
    std::filesystem::path root;
    /// Warnings become errors.
    bool strict = false;
};

struct Loaded {
    Scene scene;
    std::vector<std::string> warnings;  ///< each "file:line: …"
    /// The scene's own file and every file that it or its parts name, in the order of reading; some
    /// twice, and some that were looked for and are not there. Their bytes are all that the scene
    /// is made of.
    std::vector<std::filesystem::path> files;
};

/// Reads a scene in the course's block format (.scene, .hexray, .trinity, .qdmg: the ending never
/// changes the meaning). Throws Error "file:line: what, and what to do"; nothing is half-loaded.
Loaded load_scene(const std::filesystem::path& file, const LoadOptions& options = {});

}  // namespace luch
