#pragma once

#include <filesystem>
#include <string>
#include <vector>

// The students' kit: this tree without what homework asks for. What is in it is said in one place,
// homework/kit.txt, a rule a line.
namespace luch::grading {

/// A file of the kit.
struct KitFile {
    std::filesystem::path from;  ///< in the source tree, relative to its root
    std::filesystem::path to;    ///< in the kit, relative to its root
};

struct Kit {
    std::vector<KitFile> files;                    ///< sorted by `to`
    std::vector<std::filesystem::path> solutions;  ///< files none of whose lines may be in it
};

/// What homework/kit.txt makes of a tree. Throws Error{file:line} for a rule that cannot be read or
/// fits no file, and when there are no rules: a kit makes no kits.
Kit kit_of(const std::filesystem::path& root);

/// Copies the files. Throws Error when the folder is there already and not empty.
void write_kit(const std::filesystem::path& root, const Kit& kit,
               const std::filesystem::path& folder);

/// Where three lines of a solution stand, one after the other, in a kit's folder, blanks and lines
/// that say nothing (braces, includes) left out: "homework/vista/steps.cpp:40: as in
/// techniques/vista/steps.cpp:17". Fewer lines would be found by chance: there are only so many
/// ways to begin a loop.
std::vector<std::string> leaks(const std::filesystem::path& root, const Kit& kit,
                               const std::filesystem::path& folder);

}  // namespace luch::grading
