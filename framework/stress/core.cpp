#include "framework/stress/core.h"

#include "framework/base/error.h"
#include "framework/base/files.h"
#include "framework/scene/loader/loader.h"
#include "framework/stress/rays/rows.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

namespace luch::stress {
namespace {

StressResult result_of_row(const Row& row, Isa isa, bool full) {
    const Tally tally = row.run({full ? 1 : row.smoke, isa});
    if (tally.failures == 0) {
        return {StressVerdict::pass, fmt::format("{} {}, 0 failures", tally.rays, row.unit)};
    }
    return {StressVerdict::fail,
            fmt::format("{} of {} {} fail: {}", tally.failures, tally.rays, row.unit, tally.first)};
}

/// The loader's answer to a node's line, without the folder's name.
std::string answer(const std::string& line) {
    namespace fs = std::filesystem;
    const fs::path folder =
        fs::temp_directory_path() / fmt::format("luch-stress-{}", static_cast<long>(getpid()));
    const fs::path file = folder / "case.scene";
    write_text(
        file,
        "Camera camera {\n\tpos 0 0 -5\n}\nSphere ball {\n}\nNode ball {\n\tgeometry ball\n\t" +
            line + "\n}\n");
    std::string text = "loaded";
    try {
        load_scene(file);
    } catch (const Error& error) {
        text = error.what();
    }
    fs::remove_all(folder);
    const std::size_t at = text.find("case.scene");
    return at == std::string::npos ? text : text.substr(at);
}

}  // namespace

std::vector<StressCase> row_cases(bool full) {
    std::vector<StressCase> cases;
    for (const Row& row : rows()) {
        for (const Isa isa : usable_isas()) {
            if (!row.every_isa && isa != usable_isas().back()) continue;
            cases.push_back({row.number, fmt::format("{}, {}", row.name, to_string(isa)),
                             std::string(row.expected),
                             [&row, isa, full] { return result_of_row(row, isa, full); }});
        }
    }
    return cases;
}

std::vector<StressCase> loader_cases() {
    std::vector<StressCase> cases;
    const auto add = [&](const std::string& line, bool refused) {
        cases.push_back(
            {11, "a file's node with " + line, refused ? "an error with file and line" : "loaded",
             [line, refused] {
                 const std::string got = answer(line);
                 const bool right = refused ? got.starts_with("case.scene:8:") : got == "loaded";
                 return StressResult{right ? StressVerdict::pass : StressVerdict::fail, got};
             }});
    };
    for (const char* line : {"scale (1, 0, 1)", "scale (0, 0, 0)", "scale (1e-300, 1, 1)",
                             "scale (1, 1, 1e300)", "scale (nan, 1, 1)", "scale (1e999, 1, 1)"}) {
        add(line, true);
    }
    for (const char* line : {"scale (-1, 1, 1)", "scale (1e-8, 1e-8, 1e-8)",
                             "scale (1e8, 1e8, 1e8)", "rotate (1e6, 0, 0)"}) {
        add(line, false);
    }
    return cases;
}

}  // namespace luch::stress
