#pragma once

#include "framework/image/image.h"
#include "homework/ldr/check/samples.h"

#include <variant>

// How a sample lies in files: one-channel EXR, floats or 32 bits, one plane below the other.
namespace luch::homework::ldr {

using Plane32 = std::variant<Image<float>, Image<std::uint32_t>>;

struct StoredPlane {
    std::string name;  ///< "words.exr"
    Plane32 plane;
};

std::vector<StoredPlane> planes_of(const Sample& sample);

/// The planes of a folder. Throws Error.
Sample read_sample(const std::filesystem::path& folder, const std::string& name);

}  // namespace luch::homework::ldr
