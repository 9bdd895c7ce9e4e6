#pragma once

#include <stdexcept>
#include <string>

namespace luch {

/// A hole in a homework was reached. Only call_step() and written() catch it.
class NotWritten : public std::logic_error {
 public:
    NotWritten(std::string task, const char* file, int line)
        : std::logic_error(std::string(file) + ":" + std::to_string(line) + ": " + task +
                           " is still to be written"),
          task_(std::move(task)) {}
    [[nodiscard]] const std::string& task() const { return task_; }

 private:
    std::string task_;
};

}  // namespace luch

/// Marks a hole: LUCH_TODO("vista.t3"); the id is that of the handout, the tests and the points.
#define LUCH_TODO(task) throw ::luch::NotWritten(task, __FILE__, __LINE__)
