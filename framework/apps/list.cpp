#include "framework/apps/verbs.h"
#include "framework/base/json.h"
#include "framework/technique/catalogue.h"

#include <fmt/format.h>

namespace luch {
namespace {

Json json_of(const TechniqueInfo& info) {
    Json params = Json::array();
    for (const ParamText& param : params_of(*info.create())) {
        params.push(Json::object()
                        .set("name", param.name)
                        .set("value", param.value)
                        .set("range", param.range)
                        .set("unit", param.unit)
                        .set("help", param.help));
    }
    return Json::object()
        .set("name", info.name)
        .set("title", info.title)
        .set("topic", info.topic)
        .set("homework", info.name.starts_with("homework/"))
        .set("parameters", params);
}

class List final : public Verb {
 public:
    std::string_view name() const override { return "list"; }
    std::string_view summary() const override { return "the catalogue of techniques"; }
    std::string_view examples() const override {
        return "  luch list                      names, topics, parameters\n"
               "  luch list --json list.json     the same for a machine\n";
    }
    void declare(Arguments& arguments) override {
        arguments.option("--json", json_, "FILE", "write the catalogue as JSON");
    }
    int run() override {
        Json all = Json::array();
        for (const TechniqueInfo& info : catalogue()) {
            fmt::print("{:<20} {:<42} {}\n", info.name, info.title, info.topic);
            for (const ParamText& param : params_of(*info.create())) {
                fmt::print("    -p {}={}   {}{} ({})\n", param.name, param.value, param.help,
                           param.unit.empty() ? "" : " [" + param.unit + "]", param.range);
            }
            all.push(json_of(info));
        }
        if (!json_.empty()) all.write(json_);
        return 0;
    }

 private:
    std::string json_;
};

}  // namespace

std::unique_ptr<Verb> make_list() {
    return std::make_unique<List>();
}

}  // namespace luch
