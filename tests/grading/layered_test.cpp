#include "techniques/layered/layered.h"

#include "tests/grading/checked_homework.h"

namespace luch::homework::layered {
techniques::layered::Steps steps();
grading::Checker checker();
}  // namespace luch::homework::layered

namespace luch::testing {

CheckedHomework checked_homework() {
    using techniques::layered::Steps;
    return {.topic = "layered",
            .checker = homework::layered::checker(),
            .points = {3, 4, 5, 6, 4},
            .mutants = 32,
            .variants = 13,
            .alone =
                each_alone(homework::layered::steps(), techniques::layered::reference(),
                           &Steps::cut, &Steps::coc, &Steps::gaussian, &Steps::disc, &Steps::over)};
}

}  // namespace luch::testing
