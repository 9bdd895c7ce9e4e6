#include "framework/apps/packages.h"

#include "framework/base/error.h"
#include "framework/base/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <map>
#include <utility>

namespace luch {
namespace {

constexpr std::array needs = {Need::build, Need::test, Need::option};

/// Cuts the first word off the front of `text`.
std::string_view next_word(std::string_view& text) {
    text = trimmed(text);
    const auto end = std::min(text.find_first_of(" \t"), text.size());
    const auto word = text.substr(0, end);
    text = trimmed(text.substr(end));
    return word;
}

Need parsed_need(std::string_view word, const Place& place) {
    for (const Need need : needs) {
        if (to_string(need) == word) return need;
    }
    throw Error(place, fmt::format("unknown need '{}'; use build, test or option", word));
}

/// What a shell command prints, and its exit status.
std::pair<std::string, int> output_of(const std::string& command) {
    std::FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return {"", 127};
    std::string text;
    std::array<char, 4096> buffer;
    while (const auto n = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
        text.append(buffer.data(), n);
    }
    return {text, WEXITSTATUS(pclose(pipe))};
}

}  // namespace

std::string_view to_string(Need need) {
    switch (need) {
        case Need::build:
            return "build";
        case Need::test:
            return "test";
        case Need::option:
            return "option";
    }
    return "";
}

std::vector<Package> parsed_packages(std::string_view list) {
    std::vector<Package> packages;
    Place place{"packages.txt", 0};
    for (const std::string& line : split(list, '\n')) {
        ++place.line;
        std::string_view rest = trimmed(line);
        if (rest.empty() || rest.front() == '#') continue;
        const Need need = parsed_need(next_word(rest), place);
        const std::string name(next_word(rest));
        if (rest.empty()) throw Error(place, "write a need, a package and what it is for");
        packages.push_back({name, need, std::string(rest), {}});
    }
    return packages;
}

void set_versions(std::span<Package> packages, std::string_view dpkg_output) {
    std::map<std::string, std::string, std::less<>> versions;
    for (const std::string& line : split(dpkg_output, '\n')) {
        const auto fields = split(line, '\t');
        if (fields.size() == 3 && fields[1] == "installed") versions[fields[0]] = fields[2];
    }
    for (Package& package : packages) {
        const auto found = versions.find(package.name);
        if (found != versions.end()) package.version = found->second;
    }
}

bool ask_dpkg(std::span<Package> packages) {
    std::string command = R"(dpkg-query -W -f='${Package}\t${db:Status-Status}\t${Version}\n')";
    for (const Package& package : packages) command += " " + package.name;
    const auto [output, status] = output_of(command + " 2>/dev/null");
    constexpr int no_such_command = 127;
    if (status == no_such_command) return false;
    set_versions(packages, output);
    return true;
}

std::vector<std::string> missing(std::span<const Package> packages, Need need) {
    std::vector<std::string> names;
    for (const Package& package : packages) {
        if (package.need == need && !package.version) names.push_back(package.name);
    }
    return names;
}

std::string apt_line(std::span<const std::string> names) {
    return fmt::format("sudo apt-get install -y --no-install-recommends {}", fmt::join(names, " "));
}

}  // namespace luch
