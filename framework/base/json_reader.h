#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace luch {

/// A value within a JsonDocument, which must outlive it. What is not of the kind asked for is
/// nothing, never an exception: the reader knows what to say.
class JsonValue {
 public:
    [[nodiscard]] bool is_object() const;
    [[nodiscard]] bool is_array() const;
    [[nodiscard]] std::optional<double> number() const;
    [[nodiscard]] std::optional<bool> boolean() const;
    [[nodiscard]] std::optional<std::string_view> text() const;
    /// Elements of an array, else 0.
    [[nodiscard]] std::size_t size() const;
    /// An element of an array, i < size().
    [[nodiscard]] JsonValue at(std::size_t i) const;
    /// A member of an object.
    [[nodiscard]] std::optional<JsonValue> member(std::string_view key) const;

 private:
    friend class JsonDocument;
    explicit JsonValue(const void* value) : value_(value) {}
    const void* value_;
};

/// A JSON text, parsed whole.
class JsonDocument {
 public:
    /// Throws Error "file:line: …" where the text is no JSON or nests deeper than 256.
    JsonDocument(std::string_view text, const std::string& file);
    JsonDocument(JsonDocument&&) noexcept;
    ~JsonDocument();
    [[nodiscard]] JsonValue root() const;

 private:
    struct Parsed;
    std::unique_ptr<Parsed> parsed_;
};

}  // namespace luch
