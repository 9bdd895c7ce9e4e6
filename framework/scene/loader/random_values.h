#pragma once

#include "framework/scene/loader/diagnostics.h"

#include <string>
#include <string_view>

namespace luch::loader {

/// The value with each randfloat(a, b), a ≤ number < b, and randint(a, b), a ≤ whole number ≤ b,
/// replaced by a number that depends on nothing but its line and its place in the value.
std::string with_random_values(std::string_view value, int line, const Diagnostics& diagnostics);

}  // namespace luch::loader
