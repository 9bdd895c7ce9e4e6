#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace luch {

/// A JSON value under construction. A thin face over nlohmann's library, whose header is slow to
/// compile and is therefore named in json.cpp only. Members keep the order in which they were set;
/// a number that is not finite is written as null.
class Json {
 public:
    static Json object();
    static Json array();
    Json();  ///< null
    Json(bool value);
    Json(int value);
    Json(std::int64_t value);
    Json(std::uint64_t value);
    Json(double value);
    Json(std::string_view value);
    Json(const char* value) : Json(std::string_view(value)) {}
    Json(const std::string& value) : Json(std::string_view(value)) {}
    Json(const Json& other);
    Json(Json&& other) noexcept;
    Json& operator=(Json other) noexcept;
    ~Json();

    /// Adds a member to an object; returns the object, so that calls chain.
    Json& set(std::string_view key, Json value);
    /// Adds an element to an array; returns the array.
    Json& push(Json value);
    /// The text, indented by two spaces, with a final newline.
    std::string text() const;
    /// Writes text() to a file, creating its folder. Throws Error naming the file.
    void write(const std::filesystem::path& file) const;

 private:
    struct Value;
    explicit Json(std::unique_ptr<Value> value);
    std::unique_ptr<Value> value_;
};

}  // namespace luch
