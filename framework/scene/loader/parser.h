#pragma once

#include "framework/scene/loader/diagnostics.h"

#include <string>
#include <string_view>
#include <vector>

namespace luch::loader {

/// A line `name value…` within a block; the value is as written, random numbers already drawn.
struct Property {
    std::string name;
    std::string value;
    int line = 0;
};

/// `Class name { … }`; the name may be empty.
struct Block {
    std::string class_name;
    std::string name;
    int line = 0;
    std::vector<Property> properties;
};

/// The blocks of a scene file, in their order: the grammar only, no meaning. Throws Error.
std::vector<Block> parse_blocks(std::string_view text, Diagnostics& diagnostics);

/// The words of a value: parted by blanks, commas and parentheses; a quoted word may contain them.
/// Quotes are removed.
std::vector<std::string> words_of(std::string_view value);

}  // namespace luch::loader
