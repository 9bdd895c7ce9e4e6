#include "tests/layering/rules.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <optional>
#include <string_view>

namespace luch::layering {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_file = 400;

/// A layer may include itself and every layer of a lower rank; those of one rank are siblings.
const std::map<std::string, int, std::less<>> ranks = {
    {"base", 0},    {"math", 1},    {"parallel", 2}, {"image", 3},     {"scene", 4},
    {"accel", 5},   {"raster", 6},  {"trace", 7},    {"technique", 8}, {"baseline", 9},
    {"measure", 9}, {"grading", 9}, {"window", 10},  {"stress", 11},   {"apps", 12},
};

/// Headers that are slow to compile or tied to one processor, and where each may be named. The
/// first that fits a name decides.
struct Heavy {
    std::string_view header;  ///< How the name begins.
    std::vector<std::string_view> places;
};
const std::vector<Heavy> heavy_headers = {
    {"OpenImageIO/", {"framework/image/oiio.cpp"}},
    {"stb/stb_easy_font.h", {"framework/window/"}},
    {"stb", {"framework/image/stb.cpp"}},
    {"CLI/", {"framework/apps/arguments.cpp"}},
    {"nlohmann/",
     {"framework/base/json.cpp", "framework/base/json_reader.cpp",
      "tests/measure/report_json_test.cpp"}},
    {"SDL", {"framework/window/"}},
    {"imgui", {"framework/window/"}},
    {"tiny_obj_loader", {"framework/scene/loader/"}},
    {"tbb/", {"framework/parallel/workers.cpp"}},
    {"oneapi/tbb", {"framework/parallel/workers.cpp"}},
    {"embree", {"framework/accel/"}},
    {"xsimd", {"framework/math/simd.h"}},
    {"immintrin", {"framework/math/simd.h", "framework/accel/", "framework/raster/"}},
};

struct Source {
    std::string path;  ///< From the root, with forward slashes.
    std::vector<std::string> lines;
};

struct Include {
    bool quoted = false;
    std::string_view name;
};

/// "techniques/vista/vista.h" → {"techniques", "vista"}; {"framework", ""} for a file at the top.
struct Home {
    std::string_view top, folder;
    bool operator==(const Home&) const = default;
};

Home home(std::string_view path) {
    const auto first = path.find('/');
    if (first == path.npos) return {"", ""};
    const auto second = path.find('/', first + 1);
    if (second == path.npos) return {path.substr(0, first), ""};
    return {path.substr(0, first), path.substr(first + 1, second - first - 1)};
}

std::optional<Include> include_of(std::string_view line) {
    const auto hash = line.find_first_not_of(" \t");
    if (hash == line.npos || line[hash] != '#') return {};
    const auto word = line.find_first_not_of(" \t", hash + 1);
    if (word == line.npos || !line.substr(word).starts_with("include")) return {};
    const auto open = line.find_first_of("<\"", word);
    if (open == line.npos) return {};
    const bool quoted = line[open] == '"';
    const auto close = line.find(quoted ? '"' : '>', open + 1);
    if (close == line.npos) return {};
    return Include{quoted, line.substr(open + 1, close - open - 1)};
}

constexpr std::array<std::string_view, 5> tops = {"framework", "techniques", "homework", "scenes",
                                                  "tests"};

bool is_top(std::string_view name) {
    return std::ranges::find(tops, name) != tops.end();
}

/// Why a file of `from` may not include one of `to`; empty when it may.
std::string layer_breach(const Home& from, const Home& to) {
    const auto own = ranks.find(from.folder), other = ranks.find(to.folder);
    if (to.top != "framework") return "the framework knows no " + std::string(to.top);
    if (own == ranks.end()) return "no such layer: " + std::string(from.folder);
    if (other == ranks.end()) return "no such layer: " + std::string(to.folder);
    if (from.folder == to.folder || other->second < own->second) return "";
    return own->first + " may not include " + other->first;
}

/// The same for a module: a technique and the scenes' generator know themselves and the framework
/// below the window, a homework the technique of its name too, and only their tests know tests/.
std::string module_breach(const Home& from, const Home& to, bool is_test) {
    if (to == from) return "";
    if (to.top == "framework" && to.folder != "window" && to.folder != "apps") return "";
    if (to.top == "techniques" && from.top == "homework" && to.folder == from.folder) return "";
    if (to.top == "tests" && is_test) return "";
    return std::string(from.top) + "/" + std::string(from.folder) + " may not include " +
           std::string(to.top) + "/" + std::string(to.folder);
}

std::string arrow_breach(const std::string& path, std::string_view included) {
    const Home from = home(path), to = home(included);
    if (from.top == "tests") return "";
    if (from.top == "framework") return layer_breach(from, to);
    return module_breach(from, to, path.ends_with("_test.cpp"));
}

std::string heavy_breach(const std::string& path, std::string_view included) {
    const auto heavy = std::ranges::find_if(
        heavy_headers, [&](const Heavy& each) { return included.starts_with(each.header); });
    if (heavy == heavy_headers.end()) return "";
    const auto names_it = [&](std::string_view place) { return path.starts_with(place); };
    if (std::ranges::none_of(heavy->places, names_it)) {
        return std::string(included) + " may be named only in " +
               std::string(heavy->places.front());
    }
    if (path.ends_with(".h") && path != "framework/math/simd.h") {
        return "a heavy header belongs into a .cpp: " + std::string(included);
    }
    return "";
}

std::string include_breach(const std::string& path, const Include& include) {
    const bool ours = is_top(home(include.name).top);
    if (include.quoted && (!ours || include.name.find("../") != include.name.npos)) {
        return "spell the include from the root: " + std::string(include.name);
    }
    if (!include.quoted && ours) return "our own headers are quoted: " + std::string(include.name);
    return ours ? arrow_breach(path, include.name) : heavy_breach(path, include.name);
}

bool is_cpp(const fs::path& path) {
    return path.extension() == ".h" || path.extension() == ".cpp";
}

bool is_build_file(const fs::path& path) {
    return path.extension() == ".cmake" || path.filename() == "CMakeLists.txt" ||
           path.filename() == "CMakePresets.json";
}

Source read(const fs::path& root, const fs::path& file) {
    Source source{fs::relative(file, root).generic_string(), {}};
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) source.lines.push_back(line);
    return source;
}

std::vector<Source> sources(const fs::path& root) {
    std::vector<Source> all;
    for (const char* name : {"CMakeLists.txt", "CMakePresets.json"}) {
        all.push_back(read(root, root / name));
    }
    for (const std::string_view top : tops) {
        if (!fs::exists(root / top) && top != "framework") continue;
        for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
            if (is_cpp(entry.path()) || is_build_file(entry.path())) {
                all.push_back(read(root, entry.path()));
            }
        }
    }
    return all;
}

std::string line_breach(const Source& source, const std::string& line) {
    if (is_cpp(source.path)) {
        const auto include = include_of(line);
        return include ? include_breach(source.path, *include) : "";
    }
    for (const char* flag : {"-ffast-math", "-Ofast", "march=native"}) {
        if (line.find(flag) != line.npos) return std::string("ruled out: ") + flag;
    }
    return "";
}

}  // namespace

std::vector<std::string> breaches(const fs::path& root) {
    std::vector<std::string> found;
    for (const Source& source : sources(root)) {
        for (std::size_t i = 0; i < source.lines.size(); ++i) {
            const std::string breach = line_breach(source, source.lines[i]);
            if (breach.empty()) continue;
            found.push_back(source.path + ":" + std::to_string(i + 1) + ": " + breach);
        }
        if (source.lines.size() > longest_file) {
            found.push_back(source.path + ": " + std::to_string(source.lines.size()) +
                            " lines; two files of " + std::to_string(longest_file) + " at most");
        }
    }
    std::ranges::sort(found);
    return found;
}

}  // namespace luch::layering
