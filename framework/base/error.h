#pragma once

#include <stdexcept>
#include <string>

namespace luch {

/// Where in a file something was said. Line 0 means the file as a whole.
struct Place {
    std::string file;
    int line = 0;
};

/// "file:line", or "file" when no line is known.
std::string to_string(const Place& place);

/// A mistake of the user's: bad input, bad usage. what() is "file:line: what, and what to do".
/// The program ends with exit status 2.
class Error : public std::runtime_error {
 public:
    explicit Error(const std::string& message) : std::runtime_error(message) {}
    Error(const Place& place, const std::string& message)
        : std::runtime_error(to_string(place) + ": " + message) {}
};

}  // namespace luch
