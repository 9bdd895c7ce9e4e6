#include "framework/base/error.h"
#include "framework/base/files.h"
#include "scenes/generator/assets.h"
#include "scenes/generator/big_mesh.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <map>
#include <string_view>

namespace {

using luch::Error;

constexpr std::string_view usage =
    R"(usage: luch_assets FOLDER     writes the generated files of scenes/ below FOLDER
       luch_assets mesh --kind terrain|sphere|tangle --triangles N -o FILE.obj|FILE.glb

examples:
  luch_assets scenes
  luch_assets mesh --kind tangle --triangles 1000000 -o tangle.glb   # for benchmarks
)";

void write_all(const std::filesystem::path& folder) {
    for (const auto& [path, bytes] : luch::assets::all_assets()) {
        luch::write_text(folder / path, bytes);
        fmt::print("{:8} {}\n", bytes.size(), path);
    }
}

std::uint64_t count_of(std::string_view text) {
    std::uint64_t count = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, problem] = std::from_chars(text.data(), end, count);
    if (problem != std::errc{} || stop != end) {
        throw Error(fmt::format("--triangles is \"{}\"; give it a whole number", text));
    }
    return count;
}

void write_mesh(int argc, char** argv) {
    std::map<std::string_view, std::string_view> options{
        {"--kind", ""}, {"--triangles", ""}, {"-o", ""}};
    for (int i = 2; i < argc; i += 2) {
        const auto option = options.find(argv[i]);
        if (option == options.end() || i + 1 == argc) throw Error(std::string(usage));
        option->second = argv[i + 1];
    }
    const std::filesystem::path file(options["-o"]);
    const auto mesh = luch::assets::big_mesh(options["--kind"], count_of(options["--triangles"]));
    luch::assets::write_big_mesh(mesh, file);
    fmt::print("{} triangles {}\n", mesh.triangles, file.string());
}

}  // namespace

/// Writes the scenes' generated files, or a mesh of any size.
int main(int argc, char** argv) {
    const std::string_view first = argc > 1 ? argv[1] : "";
    const bool asks = first == "-h" || first == "--help";
    if (asks || (first != "mesh" && argc != 2)) {
        fmt::print(asks ? stdout : stderr, "{}", usage);
        return asks ? 0 : 2;
    }
    try {
        if (first == "mesh") {
            write_mesh(argc, argv);
        } else {
            write_all(first);
        }
    } catch (const Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 2;
    }
}
