#include "framework/apps/progress.h"

#include "framework/measure/numbers.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace luch {

Progress::Progress() : terminal_(isatty(STDERR_FILENO) == 1) {}

void Progress::step(double part, const std::string& what) {
    const std::string done = fmt::format("{:3.0f} %", 100 * part);
    if (!terminal_) {
        fmt::print(stderr, "{}  {}\n", done, what);
        return;
    }
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    // A guess from less than this is more often wrong than useful.
    constexpr double enough = 0.03;
    const std::string left =
        part < enough ? "" : ", about " + duration(passed.count() * (1 - part) / part) + " left";
    fmt::print(stderr, "\r\033[K{}  {}{}", done, what, left);
    std::fflush(stderr);
}

void Progress::clear() const {
    if (terminal_) fmt::print(stderr, "\r\033[K");
}

}  // namespace luch
