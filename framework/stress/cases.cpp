#include "framework/stress/cases.h"

#include "framework/stress/core.h"
#include "framework/stress/subject.h"

#include <algorithm>
#include <exception>

namespace luch::stress {
namespace {

/// In the table's order; within a row as they were added.
std::vector<StressCase> sorted(std::vector<StressCase> cases) {
    std::stable_sort(cases.begin(), cases.end(),
                     [](const StressCase& a, const StressCase& b) { return a.row < b.row; });
    return cases;
}

}  // namespace

std::vector<StressCase> core_cases(bool full) {
    std::vector<StressCase> cases = row_cases(full);
    for (StressCase& each : loader_cases()) cases.push_back(std::move(each));
    cases.push_back(viewer_case(full));
    return sorted(std::move(cases));
}

std::vector<StressCase> technique_cases(const TechniqueInfo& info, const TechniqueInfo& baseline,
                                        bool full) {
    CaseList list{{&info, &baseline, full}, {}};
    for (const auto add :
         {add_closed_things, add_small_and_far, add_transforms, add_frames_and_lights, add_cameras,
          add_ids, add_materials, add_numbers, add_loop, add_threads}) {
        add(list);
    }
    if (info.stress_cases != nullptr) {
        for (StressCase& own : info.stress_cases(info, full)) list.cases.push_back(std::move(own));
    }
    return sorted(std::move(list.cases));
}

StressResult result_of(const StressCase& stress_case) {
    try {
        return stress_case.run();
    } catch (const std::exception& thrown) {
        return {StressVerdict::fail, std::string("threw: ") + thrown.what()};
    }
}

std::string_view to_string(StressVerdict verdict) {
    switch (verdict) {
        case StressVerdict::pass:
            return "pass";
        case StressVerdict::fail:
            return "FAIL";
        case StressVerdict::not_written:
            return "NOT WRITTEN";
        case StressVerdict::does_not_apply:
            break;
    }
    return "does not apply";
}

}  // namespace luch::stress
