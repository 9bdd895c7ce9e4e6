#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace luch {

/// What this computer offers.
struct Hardware {
    int cores = 0;                    ///< Threads that may run at once.
    std::uint64_t memory_mb = 0;      ///< 0 when unknown.
    std::vector<std::string> levels;  ///< Of "x86-64-v2", "-v3", "-v4", those it has; else empty.
    std::string display;              ///< "wayland-0", ":0"; empty when there is none.
};

Hardware this_hardware();

}  // namespace luch
