#include "framework/base/error.h"
#include "framework/base/files.h"
#include "scenes/generator/assets.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

/// luch_assets FOLDER: writes the generated files of scenes/ below FOLDER.
int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: luch_assets FOLDER   (FOLDER is usually scenes)\n");
        return 2;
    }
    try {
        for (const auto& [path, bytes] : luch::assets::all_assets()) {
            luch::write_text(std::filesystem::path(argv[1]) / path, bytes);
            fmt::print("{:8} {}\n", bytes.size(), path);
        }
    } catch (const luch::Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 2;
    }
}
