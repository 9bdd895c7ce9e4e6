#include "framework/technique/plan.h"

#include "framework/base/error.h"
#include "framework/base/text.h"

#include <stdexcept>

namespace luch {

std::string_view to_string(Stage::Kind kind) {
    switch (kind) {
        case Stage::exact:
            return "exact";
        case Stage::bounded:
            return "bounded";
        case Stage::heuristic:
            return "heuristic";
    }
    return "";
}

bool Plan::needed(std::string_view stage) const {
    for (const Stage& candidate : stages) {
        if (candidate.name == stage) return candidate.needed;
    }
    throw std::logic_error("no stage \"" + std::string(stage) + "\" in this plan");
}

void Plan::need(std::string_view stage) {
    std::vector<std::string_view> names;
    for (Stage& candidate : stages) {
        if (candidate.name == stage) {
            candidate.needed = true;
            return;
        }
        names.push_back(candidate.name);
    }
    throw Error("no stage \"" + std::string(stage) + "\" in this plan: " +
                did_you_mean(stage, names));
}

void Plan::need_all() {
    for (Stage& stage : stages) stage.needed = true;
}

}  // namespace luch
