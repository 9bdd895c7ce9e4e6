#pragma once

#include <chrono>
#include <string>

namespace luch {

/// Says on standard error how far long work is. On a terminal it is one line that is written over,
/// with the time left; elsewhere one plain line a step.
class Progress {
 public:
    Progress();
    /// `part` of all the work is done, 0..1; `what` begins.
    void step(double part, const std::string& what);
    [[nodiscard]] bool on_terminal() const { return terminal_; }
    /// Takes the line away, before something else is printed.
    void clear() const;

 private:
    bool terminal_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace luch
