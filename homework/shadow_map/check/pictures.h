#pragma once

#include "framework/grading/homework.h"

#include <filesystem>
#include <vector>

namespace luch::homework::shadow_map {

/// The handout's pictures, made by the reference steps.
std::vector<grading::NamedPicture> handout_pictures(const std::filesystem::path& root);

}  // namespace luch::homework::shadow_map
