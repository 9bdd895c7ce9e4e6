#include "framework/grading/kit.h"

#include "framework/base/error.h"
#include "framework/base/files.h"
#include "framework/base/text.h"

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>

namespace luch::grading {
namespace {

namespace fs = std::filesystem;

constexpr const char* rules_file = "homework/kit.txt";

enum class Fate { keep, drop, solution, put };

struct Rule {
    Fate fate;
    std::string pattern, target;  ///< target: of put
    Place place;
    bool used = false;
};

std::optional<Fate> fate_of(const std::string& word) {
    if (word == "keep") return Fate::keep;
    if (word == "drop") return Fate::drop;
    if (word == "solution") return Fate::solution;
    if (word == "put") return Fate::put;
    return std::nullopt;
}

std::vector<Rule> read_rules(const fs::path& root) {
    const fs::path file = root / rules_file;
    if (!fs::exists(file)) {
        throw Error({file.string()},
                    "is not there: this tree is a students' kit itself, and a kit makes no kits");
    }
    std::vector<Rule> rules;
    std::istringstream lines(read_text(file));
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        const Place place{rules_file, ++number};
        if (trimmed(line).empty() || trimmed(line).front() == '#') continue;
        std::istringstream words(line);
        std::string fate, pattern, target;
        words >> fate >> pattern;
        const std::optional<Fate> known = fate_of(fate);
        if (!known) throw Error(place, "\"" + fate + "\": write keep, drop, solution or put");
        if (known == Fate::put) words >> target;
        if (pattern.empty() || (known == Fate::put && target.empty())) {
            throw Error(place, fate + " of what? Name files, as in: keep framework");
        }
        rules.push_back({*known, pattern, target, place});
    }
    return rules;
}

/// Whether a path, or a folder that it is in, fits a pattern; * stands for any part of one name.
bool fits(std::string_view path, std::string_view pattern) {
    if (pattern.empty()) return path.empty() || path.front() == '/';
    if (pattern.front() == '*') {
        for (std::size_t taken = 0; taken <= path.size(); ++taken) {
            if (fits(path.substr(taken), pattern.substr(1))) return true;
            if (taken < path.size() && path[taken] == '/') return false;
        }
        return false;
    }
    return !path.empty() && path.front() == pattern.front() &&
           fits(path.substr(1), pattern.substr(1));
}

/// All files below what some rule begins with, so that builds and the like are not walked through.
std::vector<fs::path> files_below(const fs::path& root, const std::vector<Rule>& rules) {
    std::vector<fs::path> files;
    const auto add = [&](const fs::directory_entry& entry) {
        if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), root));
    };
    for (const auto& entry : fs::directory_iterator(root)) {
        const std::string name = entry.path().filename().string();
        const bool named = std::ranges::any_of(
            rules, [&](const Rule& rule) { return fits(name, split(rule.pattern, '/').front()); });
        if (!named) continue;
        add(entry);
        if (!entry.is_directory()) continue;
        for (const auto& below : fs::recursive_directory_iterator(entry.path())) add(below);
    }
    return files;
}

/// The last rule that fits decides.
Rule* rule_for(const fs::path& file, std::vector<Rule>& rules) {
    Rule* last = nullptr;
    for (Rule& rule : rules) {
        if (!fits(file.generic_string(), rule.pattern)) continue;
        rule.used = true;
        last = &rule;
    }
    return last;
}

/// A line as it is compared: without blanks; "" when it says nothing.
std::string bare(const std::string& line) {
    constexpr std::size_t least = 8;
    std::string text;
    std::ranges::copy_if(line, std::back_inserter(text), [](unsigned char c) { return c > ' '; });
    for (const char* common : {"#include", "namespace", "usingnamespace", "}//namespace"}) {
        if (text.starts_with(common)) return "";
    }
    return text.size() < least ? "" : text;
}

/// Three lines in a row, and the first one's number.
using Runs = std::vector<std::pair<std::string, int>>;

Runs runs_of(const fs::path& file) {
    constexpr std::size_t length = 3;
    std::vector<std::pair<std::string, int>> lines;
    std::istringstream text(read_text(file));
    int number = 0;
    for (std::string line; std::getline(text, line);) {
        ++number;
        if (std::string left = bare(line); !left.empty()) lines.emplace_back(left, number);
    }
    Runs runs;
    for (std::size_t i = 0; i + length <= lines.size(); ++i) {
        std::string run;
        for (std::size_t k = 0; k < length; ++k) run += lines[i + k].first + "\n";
        runs.emplace_back(std::move(run), lines[i].second);
    }
    return runs;
}

}  // namespace

Kit kit_of(const fs::path& root) {
    std::vector<Rule> rules = read_rules(root);
    Kit kit;
    std::map<fs::path, std::pair<fs::path, bool>> files;  // to → from, and whether it was put there
    for (const fs::path& file : files_below(root, rules)) {
        const Rule* rule = rule_for(file, rules);
        if (rule == nullptr || rule->fate == Fate::drop) continue;
        if (rule->fate == Fate::solution) {
            kit.solutions.push_back(file);
        } else if (rule->fate == Fate::put) {
            const fs::path to = fs::path(rule->target) / fs::relative(file, rule->pattern);
            files[to.lexically_normal()] = {file, true};
        } else if (!files[file].second) {
            files[file] = {file, false};
        }
    }
    for (const Rule& rule : rules) {
        if (!rule.used) throw Error(rule.place, "no file fits " + rule.pattern);
    }
    for (const auto& [to, from] : files) kit.files.push_back({from.first, to});
    std::ranges::sort(kit.solutions);
    return kit;
}

void write_kit(const fs::path& root, const Kit& kit, const fs::path& folder) {
    if (fs::exists(folder) && !fs::is_empty(folder)) {
        throw Error({folder.string()}, "is not empty; name a new folder for the kit");
    }
    for (const KitFile& file : kit.files) {
        const fs::path to = folder / file.to;
        std::error_code problem;
        fs::create_directories(to.parent_path(), problem);
        if (!problem) fs::copy_file(root / file.from, to, problem);
        if (problem) throw Error({to.string()}, "cannot be written: " + problem.message());
    }
}

std::vector<std::string> leaks(const fs::path& root, const Kit& kit, const fs::path& folder) {
    std::map<std::string, std::string> secret;
    for (const fs::path& solution : kit.solutions) {
        for (auto& [run, line] : runs_of(root / solution)) {
            secret.emplace(std::move(run), solution.generic_string() + ":" + std::to_string(line));
        }
    }
    std::vector<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        const std::string name = fs::relative(entry.path(), folder).generic_string();
        for (const auto& [run, line] : runs_of(entry.path())) {
            const auto known = secret.find(run);
            if (known == secret.end()) continue;
            found.push_back(name + ":" + std::to_string(line) + ": as in " + known->second);
        }
    }
    std::ranges::sort(found);
    return found;
}

}  // namespace luch::grading
