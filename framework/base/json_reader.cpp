#include "framework/base/json_reader.h"

#include "framework/base/error.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace luch {
namespace {

using nlohmann::json;

const json& of(const void* value) {
    return *static_cast<const json*>(value);
}

int line_of(std::string_view text, std::size_t byte) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
    return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
}

json parsed(std::string_view text, const std::string& file) {
    constexpr int deepest = 256;
    const auto check_depth = [&](int depth, json::parse_event_t event, json&) {
        const bool opens =
            event == json::parse_event_t::object_start || event == json::parse_event_t::array_start;
        if (opens && depth >= deepest)
            throw Error({file}, "nests its JSON deeper than 256; flatten it");
        return true;
    };
    try {
        return json::parse(text.begin(), text.end(), check_depth);
    } catch (const json::parse_error& error) {
        throw Error({file, line_of(text, error.byte)},
                    "is not valid JSON from here on; correct the file or export it again");
    } catch (const json::exception&) {
        throw Error({file}, "holds a number that is too large for JSON; correct it");
    }
}

}  // namespace

struct JsonDocument::Parsed {
    json value;
};

JsonDocument::JsonDocument(std::string_view text, const std::string& file)
    : parsed_(std::make_unique<Parsed>(Parsed{parsed(text, file)})) {}
JsonDocument::JsonDocument(JsonDocument&&) noexcept = default;
JsonDocument::~JsonDocument() = default;

JsonValue JsonDocument::root() const {
    return JsonValue(&parsed_->value);
}

bool JsonValue::is_object() const {
    return of(value_).is_object();
}
bool JsonValue::is_array() const {
    return of(value_).is_array();
}

std::optional<double> JsonValue::number() const {
    if (!of(value_).is_number()) return std::nullopt;
    return of(value_).get<double>();
}

std::optional<bool> JsonValue::boolean() const {
    if (!of(value_).is_boolean()) return std::nullopt;
    return of(value_).get<bool>();
}

std::optional<std::string_view> JsonValue::text() const {
    if (!of(value_).is_string()) return std::nullopt;
    return std::string_view(of(value_).get_ref<const json::string_t&>());
}

std::size_t JsonValue::size() const {
    return is_array() ? of(value_).size() : 0;
}

JsonValue JsonValue::at(std::size_t i) const {
    return JsonValue(&of(value_)[i]);
}

std::optional<JsonValue> JsonValue::member(std::string_view key) const {
    if (!is_object()) return std::nullopt;
    const auto found = of(value_).find(std::string(key));
    if (found == of(value_).end()) return std::nullopt;
    return JsonValue(&*found);
}

}  // namespace luch
