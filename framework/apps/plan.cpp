#include "framework/apps/session.h"
#include "framework/apps/verbs.h"
#include "framework/base/json.h"
#include "framework/technique/catalogue.h"

#include <fmt/format.h>

namespace luch {
namespace {

void print(const std::string& name, const Plan& plan) {
    fmt::print(
        "{}{}\n", name,
        plan.applies ? (plan.why.empty() ? "" : ": " + plan.why) : ": does not apply: " + plan.why);
    if (!plan.applies) return;
    for (const Stage& stage : plan.stages) {
        const std::string bound =
            stage.kind == Stage::bounded ? fmt::format(" ≤ {:g}", stage.bound) : "";
        const std::string how =
            stage.needed ? "" : fmt::format(" ({}{})", to_string(stage.kind), bound);
        fmt::print("  {:<9} {:<22} {}{}\n", stage.needed ? "needed" : "left out", stage.name,
                   stage.why, how);
    }
}

Json json_of(const std::string& name, const Plan& plan) {
    Json stages = Json::array();
    for (const Stage& stage : plan.stages) {
        stages.push(Json::object()
                        .set("name", stage.name)
                        .set("needed", stage.needed)
                        .set("kind", to_string(stage.kind))
                        .set("bound", static_cast<double>(stage.bound))
                        .set("why", stage.why));
    }
    return Json::object()
        .set("technique", name)
        .set("applies", plan.applies)
        .set("why", plan.why)
        .set("stages", stages);
}

class PlanVerb final : public Verb {
 public:
    std::string_view name() const override { return "plan"; }
    std::string_view summary() const override {
        return "what a scene needs, what is left out, and why";
    }
    std::string_view examples() const override {
        return "  luch plan scenes/room/room.scene              every technique\n"
               "  luch plan scenes/room/room.scene -t vista     one of them\n";
    }
    void declare(Arguments& arguments) override {
        arguments.positional("SCENE", scene_, "a scene file");
        arguments.option("-t,--technique", technique_, "NAME", "only this technique [all]");
        arguments.option("-p,--param", params_, "KEY=VALUE", "a parameter of the technique");
        arguments.option("--json", json_, "FILE", "write the plans as JSON");
        options_.declare(arguments);
    }
    int run() override {
        const Session session(scene_, options_);
        Json all = Json::array();
        for (const TechniqueInfo& info : catalogue()) {
            const std::string name(info.name);
            if (!technique_.empty() && name != technique_) continue;
            Plan plan = make_technique(name, params_)->plan(session.scene(), session.shot());
            if (!session.budget().skip) plan.need_all();
            print(name, plan);
            all.push(json_of(name, plan));
        }
        if (!technique_.empty()) find_technique(technique_);
        if (!json_.empty()) all.write(json_);
        return 0;
    }

 private:
    std::string scene_, technique_, json_;
    std::vector<std::string> params_;
    SceneOptions options_;
};

}  // namespace

std::unique_ptr<Verb> make_plan() {
    return std::make_unique<PlanVerb>();
}

}  // namespace luch
