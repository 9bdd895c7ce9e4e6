#pragma once

#include <functional>
#include <string>

namespace luch::grading {

/// How a child process ended, and what it said.
struct ChildEnd {
    enum class How { finished, crashed, timed_out };
    How how = How::finished;
    std::string text;  ///< what the work returned; of a crash: the signal or the exit status
};

/// Runs `work` in a child process (a fork: call it before any thread is started) and waits for what
/// it returns, which comes back through a pipe. A crash, an exit or an endless loop ends the child
/// only. An exception that leaves `work` counts as a crash. The child's standard output goes where
/// the parent's standard error goes, so that it cannot be taken for a report.
ChildEnd run_in_child(const std::function<std::string()>& work, double limit_s);

}  // namespace luch::grading
