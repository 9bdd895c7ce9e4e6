#include "framework/scene/loader/random_values.h"

#include "framework/base/text.h"
#include "framework/math/rng.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

namespace luch::loader {
namespace {

struct Call {
    std::size_t begin, end;  ///< in the value
    bool whole;              ///< randint
    double low, high;
};

bool is_part_of_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

Call parsed(std::string_view value, std::size_t begin, std::size_t open, int line,
            const Diagnostics& diagnostics) {
    const bool whole = value.substr(begin).starts_with("randint");
    const std::size_t close = value.find(')', open);
    const auto arguments = split(value.substr(open + 1, close - open - 1), ',');
    const auto low = parsed_number(trimmed(arguments.front()));
    const auto high = parsed_number(trimmed(arguments.back()));
    constexpr double most = 1e9;
    if (close == std::string_view::npos || arguments.size() != 2 || !low || !high || *low > *high ||
        std::abs(*low) > most || std::abs(*high) > most ||
        (whole && std::floor(*high) < std::ceil(*low))) {
        diagnostics.fail(line,
                         fmt::format("{} is no random number; write {}(a, b) with a <= b, "
                                     "both within 1e9",
                                     shown(value.substr(begin)), whole ? "randint" : "randfloat"));
    }
    return {begin, close + 1, whole, *low, *high};
}

/// The next call at or after `from`; its begin is npos when there is none.
Call next_call(std::string_view value, std::size_t from, int line, const Diagnostics& diagnostics) {
    for (std::size_t at = from; (at = value.find("rand", at)) != std::string_view::npos; ++at) {
        const std::string_view rest = value.substr(at);
        const std::size_t length = rest.starts_with("randfloat") ? 9
                                   : rest.starts_with("randint") ? 7
                                                                 : 0;
        if (length == 0 || (at > 0 && is_part_of_word(value[at - 1]))) continue;
        const std::size_t open = value.find_first_not_of(" \t", at + length);
        if (open == std::string_view::npos || value[open] != '(') continue;
        return parsed(value, at, open, line, diagnostics);
    }
    return {std::string_view::npos, 0, false, 0, 0};
}

std::string drawn(const Call& call, int line) {
    const double random = Key(static_cast<std::uint64_t>(line)).uniform(call.begin);
    if (!call.whole) return fmt::format("{}", call.low + random * (call.high - call.low));
    const double low = std::ceil(call.low);
    return fmt::format("{}", low + std::floor(random * (std::floor(call.high) - low + 1)));
}

}  // namespace

std::string with_random_values(std::string_view value, int line, const Diagnostics& diagnostics) {
    std::string text;
    std::size_t done = 0;
    for (;;) {
        const Call call = next_call(value, done, line, diagnostics);
        if (call.begin == std::string_view::npos) return text.append(value.substr(done));
        text.append(value.substr(done, call.begin - done)).append(drawn(call, line));
        done = call.end;
    }
}

}  // namespace luch::loader
