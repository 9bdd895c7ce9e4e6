#pragma once

#include "framework/base/json_reader.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace luch::loader::gltf {

/// Whole numbers up to here are exact in a double, and sums of a few of them in 64 bits.
inline constexpr std::uint64_t most_count = std::uint64_t{1} << 53;

/// An object of a glTF file's JSON, with what it is called in messages. Every getter throws Error
/// "file: accessors[3]: what, and what to do" on a value of the wrong kind.
class Part {
 public:
    Part(JsonValue value, std::string file, std::string name)
        : value_(value), file_(std::move(file)), name_(std::move(name)) {}

    [[noreturn]] void fail(const std::string& what) const;
    /// "file: accessors[3]", for a warning.
    [[nodiscard]] std::string title() const;

    [[nodiscard]] bool has(std::string_view key) const { return value_.member(key).has_value(); }
    [[nodiscard]] std::optional<Part> part(std::string_view key) const;
    [[nodiscard]] Part required(std::string_view key) const;
    /// How many elements an array has; 0 when it is absent.
    [[nodiscard]] std::size_t size(std::string_view key) const;
    /// An element of an array of objects, i < size(key).
    [[nodiscard]] Part element(std::string_view key, std::size_t i) const;

    /// A whole number, 0 to most_count.
    [[nodiscard]] std::optional<std::uint64_t> whole(std::string_view key) const;
    [[nodiscard]] std::uint64_t required_whole(std::string_view key) const;
    /// The whole numbers of an array; none when it is absent.
    [[nodiscard]] std::vector<std::uint64_t> wholes(std::string_view key) const;
    /// Exactly `count` finite numbers of a size up to 1e30, or nothing when they are absent.
    [[nodiscard]] std::optional<std::vector<double>> numbers(std::string_view key,
                                                             std::size_t count) const;
    [[nodiscard]] std::optional<std::string_view> text(std::string_view key) const;
    /// The texts of an array; none when it is absent.
    [[nodiscard]] std::vector<std::string_view> texts(std::string_view key) const;
    [[nodiscard]] bool flag(std::string_view key) const;

 private:
    [[nodiscard]] std::string name_of(std::string_view key) const;
    [[nodiscard]] std::optional<JsonValue> array(std::string_view key) const;
    [[nodiscard]] std::uint64_t whole(const JsonValue& value, std::string_view key) const;

    JsonValue value_;
    std::string file_, name_;
};

}  // namespace luch::loader::gltf
