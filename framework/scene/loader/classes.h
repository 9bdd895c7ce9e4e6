#pragma once

#include "framework/scene/loader/blocks.h"

namespace luch::loader {

/// A class of block that this program reads.
struct BlockClass {
    std::string_view name;
    Kind kind;
    void (*read)(Properties& block, Loading& loading);
};

/// The class behind a name, old names included. Throws Error when there is none, or when the format
/// has it but this version does not read it.
const BlockClass& class_of(const Block& block, const Diagnostics& diagnostics);

}  // namespace luch::loader
