#include "framework/measure/machine.h"

#include "framework/base/text.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <fstream>
#include <thread>

namespace luch {
namespace {

std::string cpu_name() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (line.rfind("model name", 0) != 0) continue;
        return std::string(trimmed(std::string_view(line).substr(line.find(':') + 1)));
    }
    return "unknown processor";
}

std::string compiler_name() {
#if defined(__clang__)
    return "clang " __clang_version__;
#elif defined(__GNUC__)
    return "g++ " __VERSION__;
#else
    return "unknown compiler";
#endif
}

}  // namespace

Machine this_machine(int threads) {
    Machine machine;
    machine.cpu = cpu_name();
    machine.cores = static_cast<int>(std::thread::hardware_concurrency());
    machine.threads = threads;
    machine.version = LUCH_VERSION;
    machine.compiler = compiler_name();
    machine.date = fmt::format("{:%Y-%m-%d %H:%M}", fmt::gmtime(std::time(nullptr)));
    return machine;
}

}  // namespace luch
