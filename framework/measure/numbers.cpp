#include "framework/measure/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luch {

std::string three_digits(double value) {
    if (!std::isfinite(value)) return "—";
    const double size = std::abs(value);
    if (size == 0) return "0";
    if (size < 0.001) return fmt::format("{:.2e}", value);
    const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 5);
    return fmt::format("{:.{}f}", value, decimals);
}

std::string milliseconds(double ms) {
    if (!std::isfinite(ms)) return "—";
    const int decimals = ms >= 100 ? 0 : ms >= 10 ? 1 : 2;
    return fmt::format("{:.{}f}", ms, decimals);
}

std::string grouped(std::uint64_t value) {
    const std::string digits = std::to_string(value);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
        text += digits[i];
    }
    return text;
}

std::string counted(std::uint64_t count, const std::string& what) {
    return grouped(count) + " " + what + (count == 1 ? "" : "s");
}

std::string percent(double part, double whole) {
    if (!(whole > 0)) return "—";
    const double percents = 100 * part / whole;
    return fmt::format("{:.{}f} %", percents, percents > 0 && percents < 1 ? 2 : 1);
}

std::string duration(double seconds) {
    const auto whole = static_cast<long>(std::max(0.0, std::round(seconds)));
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

std::string exact_number(double value) {
    return fmt::format("{}", value);
}

}  // namespace luch
