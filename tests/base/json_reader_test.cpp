#include "framework/base/json_reader.h"

#include "framework/base/error.h"

#include <gtest/gtest.h>

namespace luch {
namespace {

std::string answer(const std::string& text) {
    try {
        const JsonDocument document(text, "a.json");
        return "read";
    } catch (const Error& error) {
        return error.what();
    }
}

TEST(JsonReader, GivesEachValueByItsKindAndNothingByAnother) {
    const JsonDocument document(R"({"n": -2.5, "t": "ein", "b": true, "a": [1, 2, 3], "o": {}})",
                                "a.json");
    const JsonValue root = document.root();
    ASSERT_TRUE(root.is_object());
    EXPECT_EQ(root.member("n")->number(), -2.5);
    EXPECT_EQ(root.member("t")->text(), "ein");
    EXPECT_EQ(root.member("b")->boolean(), true);
    EXPECT_EQ(root.member("a")->size(), 3u);
    EXPECT_EQ(root.member("a")->at(2).number(), 3);
    EXPECT_TRUE(root.member("o")->is_object());
    EXPECT_FALSE(root.member("a")->is_object());
    EXPECT_FALSE(root.member("x"));
    EXPECT_FALSE(root.member("a")->member("x"));
    EXPECT_FALSE(root.member("t")->number());
    EXPECT_FALSE(root.member("n")->text());
    EXPECT_FALSE(root.member("n")->boolean());
    EXPECT_EQ(root.member("t")->size(), 0u);
}

TEST(JsonReader, NamesTheLineOfAMistake) {
    EXPECT_EQ(answer("{\n \"a\": 1,\n b\n}"),
              "a.json:3: is not valid JSON from here on; correct the file or export it again");
    EXPECT_EQ(answer(""),
              "a.json:1: is not valid JSON from here on; correct the file or export it again");
    EXPECT_EQ(answer("[1e999]"), "a.json: holds a number that is too large for JSON; correct it");
}

TEST(JsonReader, NestsTo256) {
    const auto nested = [](int depth) {
        return std::string(static_cast<std::size_t>(depth), '[') +
               std::string(static_cast<std::size_t>(depth), ']');
    };
    EXPECT_EQ(answer(nested(256)), "read");
    EXPECT_EQ(answer(nested(257)), "a.json: nests its JSON deeper than 256; flatten it");
    EXPECT_EQ(answer(nested(1000000)), "a.json: nests its JSON deeper than 256; flatten it");
}

}  // namespace
}  // namespace luch
