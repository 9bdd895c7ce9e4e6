#include "tests/testing/shell.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace luch {
namespace {

TEST(RasterKernels, ExportTheirEntryAndNothingThatALinkerMightShare) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "sanitizers add symbols of their own";
#endif
    for (const char* level : {"plain", "v2", "v3", "v4"}) {
        const std::string object =
            std::string(LUCH_KERNEL_OBJECTS) + "/luch_raster_" + level + ".dir/kernel.cpp.o";
        if (!std::filesystem::exists(object)) {
            ASSERT_STRNE(level, "plain") << object;
            continue;
        }
        const auto [status, text] = shell("nm --defined-only -g -C " + object);
        ASSERT_EQ(status, 0) << text;
        EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
        EXPECT_NE(text.find(std::string(" T luch::raster::kernels_") + level), text.npos) << text;
    }
}

}  // namespace
}  // namespace luch
