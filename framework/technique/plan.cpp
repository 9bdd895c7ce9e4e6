#include "framework/technique/plan.h"

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

void Plan::need_all() {
    for (Stage& stage : stages) stage.needed = true;
}

}  // namespace luch
