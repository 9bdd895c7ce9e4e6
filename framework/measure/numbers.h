#pragma once

#include <cstdint>
#include <string>

namespace luch {

// How reports write numbers. "—" stands for one that is not finite.

/// Three significant digits, without an exponent from 0.001 upwards: "0.0123", "12.3", "1234".
std::string three_digits(double value);

/// Milliseconds, with no more digits than a clock is good for: "0.05", "12.3", "1234".
std::string milliseconds(double ms);

/// "1,234,567".
std::string grouped(std::uint64_t value);

/// "1 light", "2 lights".
std::string counted(std::uint64_t count, const std::string& what);

/// Part of a whole in percent: "42.1 %", below 1 % "0.04 %"; "—" of nothing.
std::string percent(double part, double whole);

/// "12 s", "3 min 20 s", "2 h 05 min".
std::string duration(double seconds);

/// The shortest text that reads back as the same number: "4", "0.25".
std::string exact_number(double value);

}  // namespace luch
