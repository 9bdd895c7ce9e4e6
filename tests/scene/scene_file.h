#pragma once

#include "framework/base/files.h"
#include "framework/scene/loader/loader.h"
#include "tests/testing/own_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace luch {

/// A folder of its own for each test, and scenes in it.
class SceneFile : public testing::Test {
 protected:
    void SetUp() override { folder_ = own_folder(); }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    /// The text, with a camera after it, as t.scene.
    Loaded loaded(const std::string& text, bool strict = false) const {
        write_text(folder_ / "t.scene", text + "\nCamera camera {\npos 0 0 0\n}\n");
        return load_scene(folder_ / "t.scene", {.root = {}, .strict = strict});
    }
    /// The error's text or, where there is none, the warnings; without the folder's name.
    std::string answer(const std::string& text) const {
        try {
            std::string warnings;
            for (const std::string& warning : loaded(text).warnings) {
                warnings += without_folder(warning) + "\n";
            }
            return warnings;
        } catch (const Error& error) {
            return without_folder(error.what());
        }
    }
    std::string without_folder(std::string text) const {
        const std::string name = folder_.string() + "/";
        for (std::size_t at; (at = text.find(name)) != std::string::npos;) {
            text.erase(at, name.size());
        }
        return text;
    }

    std::filesystem::path folder_;
};

}  // namespace luch
