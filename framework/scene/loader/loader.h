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
};

/// Reads a scene in the course's block format (.scene, .hexray, .trinity, .qdmg: the ending never
/// changes the meaning). Throws Error "file:line: what, and what to do"; nothing is half-loaded.
Loaded load_scene(const std::filesystem::path& file, const LoadOptions& options = {});

}  // namespace luch
