#pragma once

#include <span>
#include <string_view>

namespace luch {

/// A library and the version that CMake found; "" when it was left out.
struct Library {
    std::string_view name, version;
};

// Written by CMake into build/…/built_with.cpp.

/// "GNU 12.2.0, Release".
std::string_view compiler();
std::span<const Library> libraries();
/// The text of framework/cmake/packages.txt.
std::string_view package_list();

}  // namespace luch
