#include "framework/apps/plan_cost.h"
#include "framework/apps/session.h"
#include "framework/apps/verbs.h"
#include "framework/base/error.h"
#include "framework/base/json.h"
#include "framework/technique/catalogue.h"

#include <fmt/format.h>

namespace luch {
namespace {

std::string kind_of(const Stage& stage) {
    if (stage.needed) return "";
    if (stage.kind != Stage::bounded) return fmt::format(" ({})", to_string(stage.kind));
    return fmt::format(" (bounded ≤ {:g})", stage.bound);
}

void print(const std::string& name, const Plan& plan) {
    fmt::print(
        "{}{}\n", name,
        plan.applies ? (plan.why.empty() ? "" : ": " + plan.why) : ": does not apply: " + plan.why);
    if (!plan.applies) return;
    for (const Stage& stage : plan.stages) {
        fmt::print("  {:<9} {:<22} {}{}\n", stage.needed ? "needed" : "left out", stage.name,
                   stage.why, kind_of(stage));
    }
}

std::string work_of(const Stage& stage) {
    return stage.worked_on.empty() ? "" : fmt::format("{} {}", stage.work, stage.worked_on);
}

/// What each stage did in a frame, and in one with all stages forced on.
void print(const PlanCost& cost) {
    fmt::print("  {:<22} {:>20} {:>20}\n", "a frame", "planned", "forced on");
    for (std::size_t i = 0; i < cost.planned.plan.stages.size(); ++i) {
        const Stage &planned = cost.planned.plan.stages[i], &forced = cost.forced.plan.stages[i];
        if (forced.needed == planned.needed) continue;
        fmt::print("  {:<22} {:>20} {:>20}\n", planned.name, work_of(planned), work_of(forced));
    }
    fmt::print("  {:<22} {:>17.1f} ms {:>17.1f} ms   {:.3f} times as long, median of {} pairs\n",
               "processor time", median(cost.planned_ms), median(cost.forced_ms), cost.ratio(),
               cost.planned_ms.size());
    fmt::print("  the pictures are {}\n", cost.identical() ? "bit-identical" : "NOT the same");
}

Json json_of(const std::string& name, const Plan& plan) {
    Json stages = Json::array();
    for (const Stage& stage : plan.stages) {
        stages.push(Json::object()
                        .set("name", stage.name)
                        .set("needed", stage.needed)
                        .set("kind", to_string(stage.kind))
                        .set("bound", static_cast<double>(stage.bound))
                        .set("why", stage.why)
                        .set("work", stage.work)
                        .set("worked_on", stage.worked_on));
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
               "  luch plan scenes/room/room.scene -t vista     one of them\n"
               "  luch plan scenes/spheres/spheres.scene -t baseline --time 9\n"
               "                                                what leaving out is worth\n";
    }
    void declare(Arguments& arguments) override {
        arguments.positional("SCENE", scene_, "a scene file");
        arguments.option("-t,--technique", technique_, "NAME", "only this technique [all]");
        arguments.option("-p,--param", params_, "KEY=VALUE", "a parameter of the technique");
        arguments.option("--time", frames_, "N",
                         "make N frames as planned and N with all that is left out forced on, "
                         "in turn: times, counts, and whether the pictures are the same");
        arguments.option("--json", json_, "FILE", "write the plans as JSON");
        options_.declare(arguments);
    }
    int run() override {
        if (frames_ < 0 || frames_ > 1000) throw Error("--time: give 1 to 1000");
        const Session session(scene_, options_);
        Json all = Json::array();
        for (const TechniqueInfo& info : catalogue()) {
            const std::string name(info.name);
            if (!technique_.empty() && name != technique_) continue;
            all.push(shown(session, name));
        }
        if (!technique_.empty()) find_technique(technique_);
        if (!json_.empty()) all.write(json_);
        return same_ ? 0 : 1;
    }

 private:
    Json shown(const Session& session, const std::string& name) {
        const auto technique = make_technique(name, params_);
        Plan plan = technique->plan(session.scene(), session.shot());
        if (!session.budget().skip) plan.need_all();
        for (const std::string& stage : session.budget().forced) plan.need(stage);
        print(name, plan);
        if (frames_ == 0 || !plan.applies) return json_of(name, plan);
        const auto forced = build_accelerator(session.scene(), parsed_isa(""),
                                              parsed_backend(options_.backend), false);
        const PlanCost cost =
            cost_of_plan(*technique, session.studio(), *forced, session.shot(), frames_);
        print(cost);
        same_ = same_ && cost.identical();
        return json_of(name, cost.planned.plan)
            .set("forced", json_of(name, cost.forced.plan))
            .set("planned_cpu_ms", median(cost.planned_ms))
            .set("forced_cpu_ms", median(cost.forced_ms))
            .set("forced_over_planned", cost.ratio())
            .set("identical", cost.identical());
    }

    std::string scene_, technique_, json_;
    std::vector<std::string> params_;
    int frames_ = 0;
    bool same_ = true;
    SceneOptions options_;
};

}  // namespace

std::unique_ptr<Verb> make_plan() {
    return std::make_unique<PlanVerb>();
}

}  // namespace luch
