#include "techniques/ldr/ldr.h"

#include "tests/grading/checked_homework.h"

namespace luch::homework::ldr {
techniques::ldr::Steps steps();
grading::Checker checker();
}  // namespace luch::homework::ldr

namespace luch::testing {

CheckedHomework checked_homework() {
    using techniques::ldr::Steps;
    return {.topic = "ldr",
            .checker = homework::ldr::checker(),
            .points = {4, 4, 4, 4, 4, 3, 5},
            .mutants = 34,
            .variants = 16,
            .alone = each_alone(homework::ldr::steps(), techniques::ldr::reference(),
                                &Steps::encode, &Steps::add, &Steps::modulate, &Steps::mix,
                                &Steps::lerp, &Steps::accumulate, &Steps::resolve)};
}

}  // namespace luch::testing
