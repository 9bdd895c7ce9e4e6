#include "framework/apps/hardware.h"

#include <unistd.h>

#include <cstdlib>
#include <thread>

namespace luch {
namespace {

/// The levels of the x86-64 psABI, by the features that set each apart. clang 14 knows no
/// __builtin_cpu_supports("x86-64-v3").
std::vector<std::string> processor_levels() {
    std::vector<std::string> levels;
#if defined(__x86_64__)
    __builtin_cpu_init();
    if (!__builtin_cpu_supports("sse4.2") || !__builtin_cpu_supports("popcnt")) return levels;
    levels.emplace_back("x86-64-v2");
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma") ||
        !__builtin_cpu_supports("bmi2")) {
        return levels;
    }
    levels.emplace_back("x86-64-v3");
    if (!__builtin_cpu_supports("avx512f") || !__builtin_cpu_supports("avx512bw") ||
        !__builtin_cpu_supports("avx512cd") || !__builtin_cpu_supports("avx512dq") ||
        !__builtin_cpu_supports("avx512vl")) {
        return levels;
    }
    levels.emplace_back("x86-64-v4");
#endif
    return levels;
}

std::uint64_t physical_memory_mb() {
    const auto pages = sysconf(_SC_PHYS_PAGES), page_bytes = sysconf(_SC_PAGE_SIZE);
    if (pages <= 0 || page_bytes <= 0) return 0;
    return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page_bytes) >> 20;
}

std::string display_name() {
    for (const char* variable : {"WAYLAND_DISPLAY", "DISPLAY"}) {
        const char* value = std::getenv(variable);
        if (value && *value) return value;
    }
    return "";
}

}  // namespace

Hardware this_hardware() {
    return {static_cast<int>(std::thread::hardware_concurrency()), physical_memory_mb(),
            processor_levels(), display_name()};
}

}  // namespace luch
