#pragma once

#include <filesystem>

namespace luch::formats {

/// False when an attribute in an OpenEXR file's headers claims more bytes than the file has.
/// OpenEXR believes the claim and clears up to 2 GB before it notices. True for what is no OpenEXR.
bool exr_attributes_fit(const std::filesystem::path& file);

}  // namespace luch::formats
