#pragma once

#include "framework/grading/homework.h"
#include "homework/vista/check/samples.h"

#include <filesystem>

namespace luch::homework::vista {

/// The handout's pictures, t1 to t7, made by these steps from the homework's own scenes.
std::vector<grading::NamedPicture> handout_pictures(const std::filesystem::path& root,
                                                    const Steps& steps);

}  // namespace luch::homework::vista
