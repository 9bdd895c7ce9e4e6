#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace luch {

/// What a package of framework/cmake/packages.txt is needed for.
enum class Need {
    build,   ///< to build and run luch
    test,    ///< for ./test besides
    option,  ///< used when present
};

std::string_view to_string(Need need);

struct Package {
    std::string name;
    Need need = Need::build;
    std::string purpose;
    std::optional<std::string> version;  ///< The installed one; nothing when it is not installed.
};

/// Reads a list in the format of packages.txt. Throws Error, naming the line, on an unknown need or
/// a line without a package and its purpose.
std::vector<Package> parsed_packages(std::string_view list);

/// Fills in the versions from dpkg-query's output: lines of name, status and version between tabs.
/// What it does not name, or names with a status other than "installed", is not installed.
void set_versions(std::span<Package> packages, std::string_view dpkg_output);

/// Asks dpkg-query for the versions. False when there is no dpkg-query: then nothing is known.
bool ask_dpkg(std::span<Package> packages);

/// The names of what is not installed and needed for `need`, in the list's order.
std::vector<std::string> missing(std::span<const Package> packages, Need need);

/// The command line that installs these packages on Debian.
std::string apt_line(std::span<const std::string> names);

}  // namespace luch
