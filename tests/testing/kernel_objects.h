#pragma once

#include "tests/testing/shell.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace luch::testing {

/// Looks with nm whether the object files of luch_kernels(), in `prefix` + level + `suffix`, export
/// `entry` + level and nothing else: an inline function compiled there might be the copy that the
/// linker keeps, and older machines would crash.
inline void expect_one_entry_each(const std::string& prefix, const std::string& suffix,
                                  const std::string& entry) {
    for (const std::string level : {"plain", "v2", "v3", "v4"}) {
        const std::string object = prefix + level + suffix;
        if (!std::filesystem::exists(object)) {
            ASSERT_NE(level, "plain") << object;
            continue;
        }
        const auto [status, text] = shell("nm --defined-only -g -C " + object);
        ASSERT_EQ(status, 0) << text;
        EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
        EXPECT_NE(text.find(" T " + entry + level), text.npos) << text;
    }
}

}  // namespace luch::testing
