#pragma once

#include <string>

namespace luch {

/// Where and with what a report was made. Holds nothing that names a person or a computer.
struct Machine {
    std::string cpu;      ///< as the processor names itself
    int cores = 0;        ///< hardware threads
    int threads = 0;      ///< that the run used
    std::string version;  ///< of luch
    std::string compiler;
    std::string date;  ///< UTC, "2026-03-01 14:05"
};

/// The facts of this machine, now.
Machine this_machine(int threads);

}  // namespace luch
