#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace luch {

/// The `count` names nearest to `wanted` by edit distance (case ignored), nearest first.
std::vector<std::string> nearest_names(std::string_view wanted,
                                       std::span<const std::string_view> names, int count = 3);

/// "did you mean a, b or c?", for the tail of an error about an unknown name.
std::string did_you_mean(std::string_view wanted, std::span<const std::string_view> names);

/// "a, b or c".
std::string listed(std::span<const std::string> words, std::string_view conjunction = "or");

/// ASCII lower case.
std::string lower(std::string_view text);

/// Without the blanks at both ends.
std::string_view trimmed(std::string_view text);

/// The pieces between separators; "a,,b" gives an empty piece in the middle.
std::vector<std::string> split(std::string_view text, char separator);

/// A finite number and nothing else ("278." included), independent of the locale; else nothing.
std::optional<double> parsed_number(std::string_view text);

}  // namespace luch
