#include "framework/measure/report.h"

#include "tests/measure/samples.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace luch {
namespace {

using ::testing::HasSubstr;
using testing::occurrences;
using testing::sample_report;

/// The cells of a CSV text, by RFC 4180.
std::vector<std::vector<std::string>> cells_of(const std::string& text) {
    std::vector<std::vector<std::string>> rows{{""}};
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
            rows.back().back() += c;
            ++i;
        } else if (c == '"') {
            quoted = !quoted;
        } else if (c == ',' && !quoted) {
            rows.back().emplace_back();
        } else if (c == '\n' && !quoted) {
            rows.push_back({""});
        } else {
            rows.back().back() += c;
        }
    }
    rows.pop_back();
    return rows;
}

TEST(Series, KnowsItsBestAndItsWorstSetting) {
    const LabReport report = sample_report("x");
    const SceneReport& scene = report.scenes[0];
    EXPECT_EQ(scene.series[0].best()->value, 4);
    EXPECT_EQ(scene.series[0].worst()->value, 1);
    EXPECT_EQ(scene.series[0].setting(*scene.series[0].best()), "lod=4");
    EXPECT_EQ(scene.series[1].best(), nullptr);
    EXPECT_EQ(scene.speedup(*scene.series[0].worst()), 8);
}

TEST(Series, PrefersTheFasterOfEqualErrors) {
    LabReport report = sample_report("x");
    LabSeries& series = report.scenes[0].series[0];
    series.points[1].errors.rmse = 0;
    EXPECT_EQ(series.best()->value, 2);
}

TEST(ReportText, SaysWhyARowIsEmptyAndWhatEachSeriesIsMeasuredAgainst) {
    const std::string text = report_text(sample_report("x").scenes[0]);
    EXPECT_THAT(text, HasSubstr("does not apply: no lights, none"));
    EXPECT_THAT(text, HasSubstr("quick by lod against baseline, 1 sample a pixel"));
    EXPECT_THAT(text, HasSubstr("baseline by spp against baseline, 64 samples a pixel, seed 1"));
    EXPECT_THAT(text, ::testing::Not(HasSubstr("glossy")));
}

TEST(ReportText, FlagsPixelsThatAreNotFiniteAndHoles) {
    LabReport report = sample_report("x");
    LabPoint& point = report.scenes[0].series[0].points[0];
    point.errors.non_finite = {3, 7, 9};
    point.unwritten = {"quick.t2"};
    const std::string text = report_text(report.scenes[0]);
    EXPECT_THAT(text, HasSubstr("NOT FINITE: quick lod=1: 3 pixels, the first at (7, 9)"));
    EXPECT_THAT(text, HasSubstr("quick: still to be written, the reference stood in: quick.t2"));
}

TEST(ReportCsv, HasARowForEachPointAndAsManyCellsInEach) {
    const auto rows = cells_of(report_csv(sample_report("a, \"b\"")));
    ASSERT_EQ(rows.size(), 1u + 6u);
    for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
    EXPECT_EQ(rows[1][0], "a, \"b\"");
    const auto column = [&](const std::string& name) {
        const auto at = std::find(rows[0].begin(), rows[0].end(), name);
        EXPECT_NE(at, rows[0].end()) << name;
        return static_cast<std::size_t>(at - rows[0].begin());
    };
    EXPECT_EQ(rows[2][column("rmse")], "0.01");
    EXPECT_EQ(rows[2][column("frame_ms")], "10");
    EXPECT_EQ(rows[2][column("speedup")], "4");
    EXPECT_EQ(rows[3][column("identical")], "1");
    EXPECT_EQ(rows[4][column("not_run")], "does not apply: no lights, none");
}

TEST(ReportCsv, LeavesNumbersThatAreNoneEmpty) {
    LabReport report = sample_report("x");
    report.scenes[0].series[0].points[0].errors.rmse = std::nan("");
    const auto rows = cells_of(report_csv(report));
    const auto at = std::find(rows[0].begin(), rows[0].end(), "rmse") - rows[0].begin();
    EXPECT_EQ(rows[1][static_cast<std::size_t>(at)], "");
    EXPECT_EQ(rows[1].size(), rows[0].size());
}

TEST(ReportSvg, RingsThePointsThatNoOtherBeats) {
    // The baseline is slower than quick's exact setting and no faster at more samples.
    EXPECT_EQ(occurrences(report_svg(sample_report("x").scenes[0]), "class=\"ring\""), 5u);
}

TEST(ReportSvg, HasAsManyPointsAsRowsThatRanAndTheBaselineAsALine) {
    const std::string svg = report_svg(sample_report("x").scenes[0]);
    EXPECT_EQ(occurrences(svg, "class=\"point\""), 5u);
    EXPECT_EQ(occurrences(svg, "class=\"baseline\""), 1u);
    EXPECT_THAT(svg, HasSubstr("0: exact"));
}

TEST(ReportHtml, IsWholeAndAsksTheNetworkForNothing) {
    const std::string html = report_html(sample_report("x"));
    for (const char* tag : {"html", "head", "body", "main", "table", "svg", "section", "style"}) {
        const std::string open = std::string("<") + tag, close = std::string("</") + tag + ">";
        EXPECT_GT(occurrences(html, close), 0u) << tag;
        EXPECT_EQ(occurrences(html, open + ">") + occurrences(html, open + " "),
                  occurrences(html, close))
            << tag;
    }
    for (const char* outside : {"src=\"http", "href=\"http", "@import", "<script src", "<link"}) {
        EXPECT_EQ(occurrences(html, outside), 0u) << outside;
    }
}

TEST(ReportHtml, ShowsWhatIsWrittenInTheReport) {
    const std::string html = report_html(sample_report("x"));
    EXPECT_THAT(html, HasSubstr("luch lab x.scene"));
    EXPECT_THAT(html, HasSubstr("does not apply: no lights, none"));
    EXPECT_THAT(html, HasSubstr("no bump maps"));
    EXPECT_THAT(html, HasSubstr("quick at lod=4: exact, bit for bit"));
}

/// The text of the page's data, without what stands around it.
std::string data_of(const std::string& html) {
    const std::string begin = "id=\"lab-data\">";
    const std::size_t at = html.find(begin) + begin.size();
    return html.substr(at, html.find("</script>", at) - at);
}

TEST(ReportHtml, HoldsThePlotsDataThatNoNameCanBreakOutOf) {
    LabReport report = sample_report("x");
    report.scenes[0].series[0].technique = "</script><b>";
    const std::string data = data_of(report_html(report));
    EXPECT_THAT(data, HasSubstr("\\u003c/script>\\u003cb>"));
    EXPECT_THAT(data, HasSubstr("\"scenes\""));
    EXPECT_EQ(occurrences(data, "\"ms\":"), 6u);  // with the baseline's own frame
}

TEST(ReportHtml, HoldsItsScriptsAndWithoutThemAStaticPlot) {
    const std::string html = report_html(sample_report("x"));
    EXPECT_THAT(html, HasSubstr("var uPlot=function"));
    EXPECT_THAT(html, HasSubstr(".u-legend"));
    EXPECT_THAT(html, HasSubstr("getElementById(\"lab-data\")"));
    EXPECT_THAT(html, HasSubstr("<figure class=\"plot\"><svg"));
}

TEST(ReportHtml, SaysWhatThePointsSayTogetherWithWarningsFirst) {
    LabReport report = sample_report("x");
    report.scenes[0].series[2].passes = {{1, 2, 4}, {0.3, 0.29, 0.28}};
    const std::string html = report_html(report);
    const std::size_t warning = html.find("<li class=\"warning\">WARNING: baseline: slope");
    ASSERT_NE(warning, std::string::npos);
    EXPECT_LT(warning, html.find("<li>", html.find("class=\"findings\"")));
}

TEST(ReportHtml, EscapesAScenesName) {
    LabReport report = sample_report("<b>&");
    report.command = "luch lab '<b>&.scene'";
    report.scenes.push_back(report.scenes[0]);
    const std::string html = report_html(report);
    EXPECT_EQ(occurrences(html, "<b>&"), 0u);
    EXPECT_GT(occurrences(html, "&lt;b&gt;&amp;"), 3u);
}

}  // namespace
}  // namespace luch
