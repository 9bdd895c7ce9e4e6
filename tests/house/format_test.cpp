#include "framework/base/files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

namespace luch {
namespace {

/// scenes/FORMAT.md has every class that the loader reads, old names included.
TEST(Format, IsWrittenDownForEveryClassThatIsRead) {
    const std::filesystem::path root = LUCH_SOURCE_DIR;
    const std::string classes = read_text(root / "framework/scene/loader/classes.cpp");
    const std::string format = read_text(root / "scenes/FORMAT.md");
    const std::regex entry(R"re(\{"(\w+)", Kind::)re");
    const std::sregex_iterator first(classes.begin(), classes.end(), entry), none;
    EXPECT_GE(std::distance(first, none), 40);
    for (auto name = first; name != none; ++name) {
        const std::regex word("\\b" + name->str(1) + "\\b");
        EXPECT_TRUE(std::regex_search(format, word)) << name->str(1);
    }
}

}  // namespace
}  // namespace luch
