#include "framework/base/json.h"
#include "framework/grading/report.h"

namespace luch::grading {
namespace {

Json json_of(const std::vector<std::string>& words) {
    Json array = Json::array();
    for (const std::string& word : words) array.push(word);
    return array;
}

Json cases_json(const TestResult& test) {
    Json cases = Json::array();
    for (std::size_t i = 0; i < test.cases.size(); ++i) {
        cases.push(Json::object()
                       .set("name", test.case_names[i])
                       .set("status", to_string(test.cases[i].status))
                       .set("message", test.cases[i].finding.what));
    }
    return cases;
}

Json test_json(const Report& report, const Report::Task& task, std::size_t index) {
    const TestResult& test = task.tests[index];
    Json json = Json::object()
                    .set("id", test.id)
                    .set("points", test.points)
                    .set("max_points", test.max_points)
                    .set("status", to_string(test.status()))
                    .set("seconds", test.seconds)
                    .set("cases", cases_json(test));
    const std::size_t which = test.first_failure();
    if (which == test.cases.size()) return json;
    const CaseResult& shown = test.cases[which];
    return json.set("message", shown.finding.what)
        .set("first", shown.finding.first)
        .set("images", json_of(shown.pictures))
        .set("replay", replay_command(report, task, index));
}

Json task_json(const Report& report, const Report::Task& task) {
    Json tests = Json::array();
    for (std::size_t i = 0; i < task.tests.size(); ++i) tests.push(test_json(report, task, i));
    return Json::object()
        .set("id", task.id)
        .set("title", task.title)
        .set("points", task.points())
        .set("max_points", task.max_points)
        .set("status", to_string(task.status()))
        .set("likely", task.likely)
        .set("handout", report.readme + anchor_of(task.id))
        .set("tests", tests);
}

}  // namespace

void write_report_json(const Report& report, const std::filesystem::path& file) {
    Json tasks = Json::array();
    for (const Report::Task& task : report.tasks) tasks.push(task_json(report, task));
    Json json = Json::object()
                    .set("schema", "luch/report/1")
                    .set("homework", report.topic)
                    .set("complete", report.complete)
                    .set("score", report.points())
                    .set("max_score", report.max_points());
    if (report.seed) json.set("seed", *report.seed);
    json.set("tasks", tasks).write(file);
}

}  // namespace luch::grading
