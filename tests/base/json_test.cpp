#include "framework/base/json.h"

#include "framework/base/files.h"
#include "tests/testing/own_folder.h"

#include <gtest/gtest.h>

#include <limits>

namespace luch {
namespace {

TEST(Json, KeepsTheOrderOfItsMembers) {
    EXPECT_EQ(Json::object().set("b", 1).set("a", true).text(),
              "{\n  \"b\": 1,\n  \"a\": true\n}\n");
}

TEST(Json, WritesTextAsText) {
    EXPECT_EQ(Json("yes").text(), "\"yes\"\n");
}

TEST(Json, WritesNumbersThatReadBackTheSame) {
    EXPECT_EQ(Json(0.1).text(), "0.1\n");
    EXPECT_EQ(Json(std::numeric_limits<std::uint64_t>::max()).text(), "18446744073709551615\n");
    EXPECT_EQ(Json(std::numeric_limits<std::int64_t>::min()).text(), "-9223372036854775808\n");
}

TEST(Json, WritesNullForWhatIsNoNumber) {
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(Json::array().push(infinity).push(std::numeric_limits<double>::quiet_NaN()).text(),
              "[\n  null,\n  null\n]\n");
}

TEST(Json, EscapesQuotesAndReplacesBrokenUtf8) {
    EXPECT_EQ(Json("a\"b\xff").text(), "\"a\\\"b\xef\xbf\xbd\"\n");
}

TEST(Json, CopiesAreIndependent) {
    Json first = Json::array().push(1);
    const Json second = first;
    first.push(2);
    EXPECT_EQ(second.text(), "[\n  1\n]\n");
}

TEST(Json, IsWrittenToAFile) {
    const auto file = own_folder() / "out.json";
    Json::object().set("n", 1).write(file);
    EXPECT_EQ(read_text(file), "{\n  \"n\": 1\n}\n");
    std::filesystem::remove_all(file.parent_path());
}

}  // namespace
}  // namespace luch
