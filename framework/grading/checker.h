#pragma once

#include "framework/grading/homework.h"

#include <optional>

namespace luch::grading {

/// What a homework gives to the program that checks it (one for each homework, so that little is
/// linked after a line of the student's was changed). Its namespace exports one function,
/// Checker checker().
struct Checker {
    std::string topic;
    /// The homework; `root` is the source tree's top. With a seed, cases are added that nobody has
    /// seen. Throws Error when files are missing, or a seed needs reference steps that are not
    /// here.
    Homework (*make)(const std::filesystem::path& root,
                     std::optional<std::uint64_t> seed) = nullptr;
    /// Makes the stored reference outputs again: says what differs, and writes only with consent.
    /// Returns how many files differ. Null where the reference steps are not here.
    int (*regenerate)(const std::filesystem::path& root, bool consent,
                      const std::function<void(const std::string&)>& say) = nullptr;
};

}  // namespace luch::grading
