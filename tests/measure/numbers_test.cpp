#include "framework/measure/numbers.h"

#include "framework/measure/markup.h"
#include "framework/measure/table.h"

#include <gtest/gtest.h>

#include <cmath>

namespace luch {
namespace {

TEST(Numbers, HaveThreeDigitsAndNoNeedlessExponent) {
    EXPECT_EQ(three_digits(0.012345), "0.0123");
    EXPECT_EQ(three_digits(12.345), "12.3");
    EXPECT_EQ(three_digits(1234.5), "1234");
    EXPECT_EQ(three_digits(0.000012345), "1.23e-05");
    EXPECT_EQ(three_digits(0), "0");
    EXPECT_EQ(three_digits(std::nan("")), "—");
}

TEST(Numbers, OfMillisecondsHaveNoMoreDigitsThanAClockIsGoodFor) {
    EXPECT_EQ(milliseconds(0.0087), "0.01");
    EXPECT_EQ(milliseconds(12.345), "12.3");
    EXPECT_EQ(milliseconds(1234.5), "1234");
}

TEST(Numbers, CountOneThingAndManyThings) {
    EXPECT_EQ(counted(1, "light"), "1 light");
    EXPECT_EQ(counted(0, "light"), "0 lights");
    EXPECT_EQ(counted(2000, "node"), "2,000 nodes");
}

TEST(Numbers, AreGroupedByThousands) {
    EXPECT_EQ(grouped(999), "999");
    EXPECT_EQ(grouped(1000), "1,000");
    EXPECT_EQ(grouped(1234567), "1,234,567");
}

TEST(Numbers, TellDurationsAndParts) {
    EXPECT_EQ(duration(12.4), "12 s");
    EXPECT_EQ(duration(200), "3 min 20 s");
    EXPECT_EQ(duration(7500), "2 h 05 min");
    EXPECT_EQ(percent(1, 8), "12.5 %");
    EXPECT_EQ(percent(4, 10000), "0.04 %");
    EXPECT_EQ(percent(1, 0), "—");
    EXPECT_EQ(exact_number(4), "4");
    EXPECT_EQ(exact_number(0.1), "0.1");
}

TEST(Table, AlignsByCharactersAndLetsAShortRowRunOn) {
    TextTable table({"name", "× faster"});
    table.add({"a", "1.50"});
    table.add({"longer", "∞"});
    TextTable wide({"name", "a", "b"});
    wide.add({"x", "does not apply"});
    EXPECT_EQ(table.text(), "name    × faster\na           1.50\nlonger         ∞\n");
    EXPECT_EQ(wide.text(), "name  a  b\nx     does not apply\n");
}

TEST(Markup, EscapesWhatMarkupMeans) {
    EXPECT_EQ(escaped("<b>&\"'"), "&lt;b&gt;&amp;&quot;&#39;");
}

TEST(Markup, EncodesBase64AsTheStandardsExamples) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

}  // namespace
}  // namespace luch
