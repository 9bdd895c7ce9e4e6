#include "framework/measure/plot.h"

#include "framework/measure/log_axis.h"
#include "tests/measure/samples.h"

#include <gmock/gmock.h>

#include <cmath>

namespace luch {
namespace {

PlotPoint at(double x, double y) {
    return {x, y, "", "", false};
}

TEST(LogAxis, PutsEqualFactorsAtEqualDistances) {
    const LogAxis axis({1, 10, 1000}, 0, 300);
    const double decade = axis.at(10) - axis.at(1);
    EXPECT_GT(decade, 0);
    EXPECT_NEAR(axis.at(1000) - axis.at(100), decade, 1e-9);
    EXPECT_GT(axis.at(1), 0);
    EXPECT_LT(axis.at(1000), 300);
}

TEST(LogAxis, LabelsPowersOfTenAndOnAShortAxisAlsoTwosAndFives) {
    const auto labels = [](const std::vector<double>& values) {
        std::vector<std::string> all;
        for (const LogAxis::Tick& tick : LogAxis(values, 0, 1).ticks()) {
            if (!tick.label.empty()) all.push_back(tick.label);
        }
        return all;
    };
    EXPECT_THAT(labels({0.002, 3}), ::testing::ElementsAre("0.01", "0.1", "1"));
    EXPECT_THAT(labels({30}), ::testing::ElementsAre("10", "20", "50"));
    EXPECT_THAT(labels({3e-6, 3e5}), ::testing::Contains("10⁻⁵"));
    EXPECT_FALSE(labels({}).empty());
}

TEST(Plot, DrawsAPointForEachThatIsANumberAndNoneForOthers) {
    LogPlot plot;
    plot.series = {{"a", {at(1, 0.1), at(2, 0), at(3, std::nan("")), at(0, 1)}, false}};
    EXPECT_EQ(testing::occurrences(svg_of(plot), "class=\"point\""), 2u);
}

TEST(Plot, CrossesOutAPointThatIsNotToBeTrusted) {
    LogPlot plot;
    plot.series = {{"a", {at(1, 0.1), at(2, 1), at(3, 1)}, false}};
    plot.series[0].points[0].flagged = true;
    EXPECT_EQ(testing::occurrences(svg_of(plot), "class=\"flag\""), 1u);
}

TEST(Plot, EscapesNames) {
    LogPlot plot;
    plot.title = "<b>&";
    plot.series = {{"<i>", {{1, 1, "<u>", "<s>", false}}, false}};
    plot.vertical = PlotLine{2, "<q>"};
    const std::string svg = svg_of(plot);
    for (const char* tag : {"<b>", "<i>", "<u>", "<s>", "<q>"}) {
        EXPECT_EQ(testing::occurrences(svg, tag), 0u) << tag;
    }
    EXPECT_GT(testing::occurrences(svg, "&lt;b&gt;&amp;"), 0u);
}

}  // namespace
}  // namespace luch
