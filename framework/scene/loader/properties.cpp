#include "framework/scene/loader/properties.h"

#include "framework/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luch::loader {
namespace {

/// Quotes part words like blanks where numbers are wanted.
std::vector<std::string> numeric_words(std::string value) {
    std::replace(value.begin(), value.end(), '"', ' ');
    return words_of(value);
}

}  // namespace

std::string Properties::title() const {
    return block_.name.empty() ? block_.class_name : block_.class_name + " " + shown(block_.name);
}

const Property* Properties::find(Names names) {
    known_.push_back(names.now());
    const Property* found = nullptr;
    for (std::size_t i = 0; i < block_.properties.size(); ++i) {
        const Property& property = block_.properties[i];
        if (!names.contain(property.name)) continue;
        read_[i] = true;
        if (!found) {
            found = &property;
        } else {
            diagnostics_.warn(property.line,
                              fmt::format("{} is given twice; the first one, in line {}, counts",
                                          property.name, found->line));
        }
    }
    return found;
}

const Property& Properties::required(Names names) {
    if (const Property* property = find(names)) return *property;
    diagnostics_.fail(block_.line, fmt::format("{} has no {}; add a line \"{} ...\" to it", title(),
                                               names.now(), names.now()));
}

std::vector<const Property*> Properties::lines(std::initializer_list<std::string_view> names) {
    known_.insert(known_.end(), names);
    std::vector<const Property*> found;
    for (std::size_t i = 0; i < block_.properties.size(); ++i) {
        if (std::find(names.begin(), names.end(), block_.properties[i].name) == names.end()) {
            continue;
        }
        read_[i] = true;
        found.push_back(&block_.properties[i]);
    }
    return found;
}

void Properties::accept(std::initializer_list<std::string_view> names) {
    lines(names);
}

std::string Properties::text(const Property& property) {
    std::string_view value = property.value;
    if (value.starts_with('"')) {
        const std::size_t end = value.find('"', 1);
        if (end == std::string_view::npos || end + 1 != value.size()) {
            diagnostics_.fail(property.line, fmt::format("the quotes of {} do not match; write "
                                                         "{} \"value\"",
                                                         property.name, property.name));
        }
        value = value.substr(1, end - 1);
    }
    if (value.empty()) {
        diagnostics_.fail(property.line, property.name + " has no value; write one after it");
    }
    return std::string(value);
}

double Properties::number(const Property& property, Range range) {
    const std::vector<std::string> words = numeric_words(property.value);
    const auto value = words.size() == 1 ? parsed_number(words[0]) : std::nullopt;
    if (!value) {
        diagnostics_.fail(property.line, fmt::format("{} is {}; give it one finite number",
                                                     property.name, shown(property.value)));
    }
    if (*value < range.least || *value > range.most) {
        diagnostics_.fail(property.line,
                          fmt::format("{} is {}; choose a number from {} to {}", property.name,
                                      *value, range.least, range.most));
    }
    return *value;
}

Vec3d Properties::vector(const Property& property, Range range) {
    const std::vector<std::string> words = numeric_words(property.value);
    if (words.size() != 3) {
        diagnostics_.fail(property.line,
                          fmt::format("{} is {}; give it three numbers, as in (1, 2, 3)",
                                      property.name, shown(property.value)));
    }
    Vec3d result{0};
    for (int k = 0; k < 3; ++k) {
        const auto value = parsed_number(words[k]);
        if (!value || *value < range.least || *value > range.most) {
            diagnostics_.fail(property.line,
                              fmt::format("{} holds {}; give it numbers from {} to {}",
                                          property.name, shown(words[k]), range.least, range.most));
        }
        result[k] = *value;
    }
    return result;
}

double Properties::number(Names names, double fallback, Range range) {
    const Property* property = find(names);
    return property ? number(*property, range) : fallback;
}

int Properties::integer(Names names, int fallback, Range range) {
    const Property* property = find(names);
    if (!property) return fallback;
    const double value = number(*property, range);
    if (value != std::floor(value)) {
        diagnostics_.fail(property->line,
                          fmt::format("{} is {}; give it a whole number", property->name, value));
    }
    return static_cast<int>(value);
}

bool Properties::flag(Names names, bool fallback) {
    const Property* property = find(names);
    if (!property) return fallback;
    const std::string value = text(*property);
    return value != "off" && value != "false" && value != "0";
}

Vec3d Properties::vector(Names names, const Vec3d& fallback) {
    const Property* property = find(names);
    return property ? vector(*property) : fallback;
}

Vec3d Properties::required_vector(Names names) {
    return vector(required(names));
}

Rgb Properties::color(Names names, const Rgb& fallback) {
    const Property* property = find(names);
    return property ? Rgb(vector(*property)) : fallback;
}

void Properties::finish() {
    for (std::size_t i = 0; i < read_.size(); ++i) {
        if (read_[i]) continue;
        const Property& property = block_.properties[i];
        const std::string_view wanted = std::string_view(property.name).substr(0, 64);
        diagnostics_.warn(property.line,
                          fmt::format("{} has no property {}; {}", block_.class_name,
                                      shown(property.name), did_you_mean(wanted, known_)));
    }
}

}  // namespace luch::loader
