#pragma once

#include "framework/math/colour.h"
#include "framework/scene/loader/parser.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace luch::loader {

/// A property's name and, where older dialects have others, those too.
struct Names {
    Names(const char* name) : all{name} {}  // NOLINT: reads as a name
    Names(std::initializer_list<const char*> names) : all(names.begin(), names.end()) {}

    [[nodiscard]] std::string_view now() const { return all.front(); }
    [[nodiscard]] bool contain(std::string_view name) const {
        return std::find(all.begin(), all.end(), name) != all.end();
    }
    std::vector<std::string_view> all;
};

/// From least to most, both included. The default is what lengths, powers and colours may be: their
/// squares and float copies stay finite.
struct Range {
    double least = -1e30;
    double most = 1e30;
};
inline constexpr Range positive{1e-30, 1e30};

/// The properties of one block, by type. What a reader asks for is known; what nobody asked for is
/// warned about by finish(). Every getter throws Error "file:line: …" on a value of the wrong kind.
class Properties {
 public:
    Properties(const Block& block, Diagnostics& diagnostics)
        : block_(block), diagnostics_(diagnostics), read_(block.properties.size(), false) {}

    [[nodiscard]] const Block& block() const { return block_; }
    [[nodiscard]] Diagnostics& diagnostics() { return diagnostics_; }
    /// `Node "floor"`, or `Node` when it has no name.
    [[nodiscard]] std::string title() const;

    double number(Names names, double fallback, Range range = {});
    int integer(Names names, int fallback, Range range);
    bool flag(Names names, bool fallback);
    Rgb color(Names names, const Rgb& fallback);
    Vec3d vector(Names names, const Vec3d& fallback);
    /// Throws when the property is absent.
    Vec3d required_vector(Names names);

    /// The first line of that name, or null; a second one is warned about.
    const Property* find(Names names);
    const Property& required(Names names);
    /// All lines of these names, in the file's order; may stand any number of times.
    std::vector<const Property*> lines(std::initializer_list<std::string_view> names);
    /// Properties that mean nothing to this program.
    void accept(std::initializer_list<std::string_view> names);

    /// The value as one text, without its quotes.
    std::string text(const Property& property);
    double number(const Property& property, Range range = {});
    Vec3d vector(const Property& property, Range range = {});

    /// Warns about the lines that nobody asked for, with the nearest names that are valid.
    void finish();

 private:
    const Block& block_;
    Diagnostics& diagnostics_;
    std::vector<bool> read_;
    std::vector<std::string_view> known_;
};

}  // namespace luch::loader
