#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace luch::layering {

/// Every breach of the house's rules in a source tree, each as "file:line: what". The rules:
/// includes follow the arrows of CONTRIBUTING.md and are spelled from the root, a heavy header
/// stands only in the few files that may name it, no file is longer than 400 lines, no flag changes
/// floating-point arithmetic. Throws std::filesystem::filesystem_error when `root` holds no
/// framework/.
std::vector<std::string> breaches(const std::filesystem::path& root);

}  // namespace luch::layering
