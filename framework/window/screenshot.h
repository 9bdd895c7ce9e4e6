#pragma once

#include "framework/image/image.h"
#include "framework/window/pixel.h"

#include <filesystem>

namespace luch {

/// The first of luch-view-000.png, luch-view-001.png… that is not in the folder yet.
std::filesystem::path free_screenshot_name(const std::filesystem::path& folder);

/// Writes the picture as it is shown; the ending decides the format. Throws Error as
/// write_picture().
void write_screenshot(const std::filesystem::path& file, const Image<Pixel>& picture);

}  // namespace luch
