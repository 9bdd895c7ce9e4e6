#include "framework/base/error.h"

#include <gtest/gtest.h>

namespace luch {
namespace {

TEST(Error, NamesFileAndLine) {
    EXPECT_STREQ(Error({"a.scene", 7}, "is wrong").what(), "a.scene:7: is wrong");
}

TEST(Error, LeavesOutALineThatIsNotKnown) {
    EXPECT_STREQ(Error({"a.scene"}, "is wrong").what(), "a.scene: is wrong");
}

}  // namespace
}  // namespace luch
