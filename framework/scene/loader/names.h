#pragma once

#include "framework/scene/loader/properties.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>

namespace luch::loader {

/// Names live per kind: a texture and a shader may share one. Blocks of kind `other` have names
/// that nothing refers to.
enum class Kind { geometry, texture, shader, node, other };

/// Which names a scene defines, and as which index of their kind.
class NameTable {
 public:
    /// Gives the block the next index of its kind. A name that the kind has already keeps its first
    /// meaning, with a warning.
    void add(Kind kind, const Block& block, Diagnostics& diagnostics);

    /// The index behind a name. Throws Error at `line` that lists the nearest names of that kind.
    std::uint32_t find(Kind kind, const std::string& name, int line,
                       const Diagnostics& diagnostics) const;
    std::uint32_t find(Kind kind, Properties& block, const Property& property) const;

 private:
    struct Entry {
        std::uint32_t index;
        int line;
    };
    struct OfKind {
        std::map<std::string, Entry, std::less<>> entries;
        std::uint32_t count = 0;
    };
    std::array<OfKind, 5> kinds_;
};

}  // namespace luch::loader
