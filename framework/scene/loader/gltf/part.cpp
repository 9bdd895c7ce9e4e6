#include "framework/scene/loader/gltf/part.h"

#include "framework/base/error.h"

#include <fmt/format.h>

#include <cmath>

namespace luch::loader::gltf {

std::string Part::title() const {
    return name_.empty() ? file_ : file_ + ": " + name_;
}

void Part::fail(const std::string& what) const {
    throw Error({title()}, what);
}

std::string Part::name_of(std::string_view key) const {
    return name_.empty() ? std::string(key) : fmt::format("{}.{}", name_, key);
}

std::optional<Part> Part::part(std::string_view key) const {
    const auto value = value_.member(key);
    if (!value) return std::nullopt;
    if (!value->is_object()) fail(fmt::format("{} is no object; correct the file", key));
    return Part(*value, file_, name_of(key));
}

Part Part::required(std::string_view key) const {
    auto found = part(key);
    if (!found) fail(fmt::format("has no {}; export the model again", key));
    return *std::move(found);
}

std::optional<JsonValue> Part::array(std::string_view key) const {
    const auto value = value_.member(key);
    if (value && !value->is_array()) fail(fmt::format("{} is no array; correct the file", key));
    return value;
}

std::size_t Part::size(std::string_view key) const {
    const auto value = array(key);
    return value ? value->size() : 0;
}

Part Part::element(std::string_view key, std::size_t i) const {
    const JsonValue value = array(key)->at(i);
    Part element(value, file_, fmt::format("{}[{}]", name_of(key), i));
    if (!value.is_object()) element.fail("is no object; correct the file");
    return element;
}

std::uint64_t Part::whole(const JsonValue& value, std::string_view key) const {
    const auto number = value.number();
    if (!number || !(*number >= 0 && *number <= double(most_count)) ||
        *number != std::floor(*number)) {
        fail(fmt::format("{} is no whole number from 0 to {}; correct the file", key, most_count));
    }
    return static_cast<std::uint64_t>(*number);
}

std::optional<std::uint64_t> Part::whole(std::string_view key) const {
    const auto value = value_.member(key);
    if (!value) return std::nullopt;
    return whole(*value, key);
}

std::uint64_t Part::required_whole(std::string_view key) const {
    const auto found = whole(key);
    if (!found) fail(fmt::format("has no {}; export the model again", key));
    return *found;
}

std::vector<std::uint64_t> Part::wholes(std::string_view key) const {
    std::vector<std::uint64_t> result;
    const auto value = array(key);
    for (std::size_t i = 0; value && i < value->size(); ++i) {
        result.push_back(whole(value->at(i), key));
    }
    return result;
}

std::optional<std::vector<double>> Part::numbers(std::string_view key, std::size_t count) const {
    constexpr double most = 1e30;
    const auto value = array(key);
    if (!value) return std::nullopt;
    std::vector<double> result;
    for (std::size_t i = 0; i < value->size(); ++i) {
        const auto number = value->at(i).number();
        if (number && std::abs(*number) <= most) result.push_back(*number);
    }
    if (result.size() != count || value->size() != count) {
        fail(fmt::format("{} is not {} numbers from -1e30 to 1e30; correct the file", key, count));
    }
    return result;
}

std::optional<std::string_view> Part::text(std::string_view key) const {
    const auto value = value_.member(key);
    if (!value) return std::nullopt;
    if (!value->text()) fail(fmt::format("{} is no text; correct the file", key));
    return value->text();
}

std::vector<std::string_view> Part::texts(std::string_view key) const {
    std::vector<std::string_view> result;
    const auto value = array(key);
    for (std::size_t i = 0; value && i < value->size(); ++i) {
        const auto text = value->at(i).text();
        if (!text) fail(fmt::format("{} holds something that is no text; correct the file", key));
        result.push_back(*text);
    }
    return result;
}

bool Part::flag(std::string_view key) const {
    const auto value = value_.member(key);
    if (!value) return false;
    if (!value->boolean()) fail(fmt::format("{} is neither true nor false; correct the file", key));
    return *value->boolean();
}

}  // namespace luch::loader::gltf
