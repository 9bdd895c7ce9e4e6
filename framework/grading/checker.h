#pragma once

#include "framework/grading/homework.h"

#include <optional>

namespace luch::grading {

/// Who is told what the making of stored reference outputs finds.
struct Regeneration {
    bool consent = false;  ///< whether files may be written
    std::function<void(const std::string& line)> say;
    /// Of a picture that changes: as it was and as it would be, in linear light.
    std::function<void(const std::filesystem::path& file, const Image<Rgb>& old,
                       const Image<Rgb>& made)>
        show;
};

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
    /// Makes the stored reference outputs again: tells what differs, and writes only with consent.
    /// Returns how many files differ. Null where the reference steps are not here.
    int (*regenerate)(const std::filesystem::path& root,
                      const Regeneration& regeneration) = nullptr;
    /// Makes the handout's pictures, which stand in pictures/ beside it. Null likewise.
    std::vector<NamedPicture> (*handout)(const std::filesystem::path& root) = nullptr;
};

}  // namespace luch::grading
