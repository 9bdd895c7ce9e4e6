#pragma once

#include <cstdint>

namespace luch::stress {

/// What this process holds in memory now, in bytes; 0 where the system does not say.
std::uint64_t resident_bytes();

/// The most that a loop may grow by once it is warm.
inline constexpr std::uint64_t most_growth = 1 << 20;

}  // namespace luch::stress
