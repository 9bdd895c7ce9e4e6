#include "framework/measure/report_json.h"

#include "tests/measure/samples.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace luch {
namespace {

TEST(ReportJson, IsReadBackWithItsVersionScenesSeriesAndPoints) {
    LabReport report = testing::sample_report("a \"b\"\n<c>");
    report.yardstick = {&find_metric("rmse"), 0.05};
    const auto json = nlohmann::json::parse(report_json(report));
    EXPECT_EQ(json["version"], 2);
    EXPECT_EQ(json["command"], "luch lab x.scene");
    const auto& scene = json["scenes"][0];
    EXPECT_EQ(scene["scene"], "a \"b\"\n<c>");
    EXPECT_EQ(scene["size"], (std::vector<int>{100, 50}));
    ASSERT_EQ(scene["series"].size(), 3u);
    const auto& points = scene["series"][0]["points"];
    ASSERT_EQ(points.size(), 3u);
    EXPECT_EQ(points[1]["value"], 2);
    EXPECT_EQ(points[1]["errors"]["rmse"], 0.01);
    EXPECT_EQ(points[1]["rays"]["primary"], 2000);
    EXPECT_EQ(points[1]["speedup"], 4);
    EXPECT_EQ(points[1]["cpu_ms"], 20);
    EXPECT_TRUE(points[1]["errors_to_converged"].is_null());
    EXPECT_EQ(scene["planes"][0]["pareto"].size(), 3u);
    EXPECT_EQ(scene["planes"][0]["at_equal_error"]["times"][0]["technique"], "quick");
    EXPECT_GT(scene["findings"].size(), 0u);
    EXPECT_EQ(points[2]["identical"], true);
    EXPECT_EQ(points[2]["left_out"][0]["stage"], "bump");
    EXPECT_EQ(points[2]["left_out"][0]["exact"], true);
    EXPECT_EQ(scene["series"][1]["points"][0]["ran"], false);
    EXPECT_EQ(scene["series"][1]["points"][0]["not_run"], "does not apply: no lights, none");
}

TEST(ReportJson, WritesAnInfinitePsnrAsNull) {
    const auto json = nlohmann::json::parse(errors_json(Errors{}).text());
    EXPECT_TRUE(json["psnr"].is_null());
    EXPECT_EQ(json["non_finite"], 0);
    EXPECT_FALSE(json.contains("max_at"));
}

}  // namespace
}  // namespace luch
