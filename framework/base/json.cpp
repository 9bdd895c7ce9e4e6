#include "framework/base/json.h"

#include "framework/base/files.h"

#include <nlohmann/json.hpp>

namespace luch {

struct Json::Value {
    nlohmann::ordered_json json;
};

Json::Json(std::unique_ptr<Value> value) : value_(std::move(value)) {}
Json Json::object() {
    return Json(std::make_unique<Value>(Value{nlohmann::ordered_json::object()}));
}
Json Json::array() {
    return Json(std::make_unique<Value>(Value{nlohmann::ordered_json::array()}));
}
Json::Json() : value_(std::make_unique<Value>()) {}
Json::Json(bool value) : value_(std::make_unique<Value>(Value{value})) {}
Json::Json(int value) : value_(std::make_unique<Value>(Value{value})) {}
Json::Json(std::int64_t value) : value_(std::make_unique<Value>(Value{value})) {}
Json::Json(std::uint64_t value) : value_(std::make_unique<Value>(Value{value})) {}
Json::Json(double value) : value_(std::make_unique<Value>(Value{value})) {}
Json::Json(std::string_view value) : value_(std::make_unique<Value>(Value{value})) {}
Json::Json(const Json& other) : value_(std::make_unique<Value>(*other.value_)) {}
Json::Json(Json&& other) noexcept = default;
Json& Json::operator=(Json other) noexcept {
    value_ = std::move(other.value_);
    return *this;
}
Json::~Json() = default;

Json& Json::set(std::string_view key, Json value) {
    value_->json[std::string(key)] = std::move(value.value_->json);
    return *this;
}

Json& Json::push(Json value) {
    value_->json.push_back(std::move(value.value_->json));
    return *this;
}

std::string Json::text() const {
    // Invalid UTF-8 (a file name, say) is replaced rather than thrown over.
    return value_->json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

void Json::write(const std::filesystem::path& file) const {
    write_text(file, text());
}

}  // namespace luch
