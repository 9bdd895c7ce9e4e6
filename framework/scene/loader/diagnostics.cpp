#include "framework/scene/loader/diagnostics.h"

namespace luch::loader {

std::string shown(std::string_view word) {
    constexpr std::size_t longest = 64;
    std::string text = "\"";
    for (const char c : word.substr(0, longest)) {
        const auto byte = static_cast<unsigned char>(c);
        text += byte < 0x20 || byte == 0x7f ? '?' : c;
    }
    if (word.size() > longest) text += "...";
    return text + "\"";
}

void Diagnostics::fail(int line, const std::string& message) const {
    throw Error(place(line), message);
}

void Diagnostics::warn(const Place& place, const std::string& message) {
    constexpr std::size_t most = 1000;
    if (strict_) throw Error(place, message);
    if (warnings_.size() < most) {
        warnings_.push_back(to_string(place) + ": " + message);
    } else if (warnings_.size() == most) {
        warnings_.push_back(file_ + ": has more warnings, which are left out");
    }
}

}  // namespace luch::loader
