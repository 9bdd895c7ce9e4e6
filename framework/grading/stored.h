#pragma once

#include "framework/grading/checker.h"
#include "framework/image/image.h"

#include <filesystem>
#include <string>
#include <variant>

// Reference outputs in files, and how they are made again.
namespace luch::grading {

/// Bits that a file keeps: one-channel EXR, floats or ids.
using Plane32 = std::variant<Image<float>, Image<std::uint32_t>>;

struct StoredPlane {
    std::string name;  ///< of its file: "around.exr"
    Plane32 plane;
};

/// Compares a plane with its file, tells what differs and, with consent, writes it. A plane as
/// large as the frame is a picture: it is shown as it was and as it would be before anything is
/// written. Returns whether it differs.
bool regenerate_plane(const std::filesystem::path& folder, const StoredPlane& made, Size frame,
                      const Regeneration& regeneration);

}  // namespace luch::grading
