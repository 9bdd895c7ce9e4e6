#pragma once

#include "framework/base/error.h"

#include <string>
#include <string_view>
#include <vector>

namespace luch::loader {

/// A word of the file within quotes, fit for a message: shortened, and without control characters.
std::string shown(std::string_view word);

/// Where a scene file's mistakes go.
class Diagnostics {
 public:
    Diagnostics(std::string file, bool strict) : file_(std::move(file)), strict_(strict) {}

    [[nodiscard]] Place place(int line) const { return {file_, line}; }
    [[noreturn]] void fail(int line, const std::string& message) const;
    /// Keeps "file:line: message"; under --strict it is an error. After 1,000 it says so and stops.
    void warn(const Place& place, const std::string& message);
    void warn(int line, const std::string& message) { warn(place(line), message); }

    [[nodiscard]] std::vector<std::string>& warnings() { return warnings_; }

 private:
    std::string file_;
    bool strict_;
    std::vector<std::string> warnings_;
};

}  // namespace luch::loader
