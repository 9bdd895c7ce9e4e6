#include "framework/measure/log_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luch {
namespace {

constexpr double air = 0.12;  // of a decade

std::string superscript(int power) {
    constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = power < 0 ? "⁻" : "";
    for (const char c : std::to_string(std::abs(power))) text += digits[c - '0'];
    return text;
}

/// mantissa · 10^power as a reader likes it: 0.02, 500, 10⁻⁶, 2·10⁶.
std::string label_of(int mantissa, int power) {
    if (power >= -3 && power <= 4) {
        return fmt::format("{:.{}f}", mantissa * std::pow(10.0, power), std::max(0, -power));
    }
    return (mantissa == 1 ? "" : fmt::format("{}·", mantissa)) + "10" + superscript(power);
}

}  // namespace

LogAxis::LogAxis(const std::vector<double>& values, double from, double to) : from_(from), to_(to) {
    std::vector<double> powers;
    for (const double value : values) {
        if (value > 0 && std::isfinite(value)) powers.push_back(std::log10(value));
    }
    if (powers.empty()) return;
    const auto [least, most] = std::minmax_element(powers.begin(), powers.end());
    const double missing = std::max(0.0, 1 - (*most - *least) - 2 * air) / 2;
    least_ = *least - air - missing;
    most_ = *most + air + missing;
}

double LogAxis::at(double value) const {
    return from_ + (std::log10(value) - least_) / (most_ - least_) * (to_ - from_);
}

std::vector<LogAxis::Tick> LogAxis::ticks() const {
    const bool narrow = most_ - least_ < 2;
    std::vector<Tick> ticks;
    for (int power = static_cast<int>(std::floor(least_)); power <= most_; ++power) {
        for (int mantissa = 1; mantissa <= 9; ++mantissa) {
            const double value = mantissa * std::pow(10.0, power);
            if (std::log10(value) < least_ || std::log10(value) > most_) continue;
            const bool labelled = mantissa == 1 || (narrow && (mantissa == 2 || mantissa == 5));
            ticks.push_back({value, labelled ? label_of(mantissa, power) : "", mantissa == 1});
        }
    }
    return ticks;
}

}  // namespace luch
