#include "techniques/vista/vista.h"

#include "tests/grading/checked_homework.h"

namespace luch::homework::vista {
techniques::vista::Steps steps();
grading::Checker checker();
}  // namespace luch::homework::vista

namespace luch::testing {

CheckedHomework checked_homework() {
    using techniques::vista::Steps;
    return {.topic = "vista",
            .checker = homework::vista::checker(),
            .points = {2, 5, 4, 2, 4, 6, 5},
            .mutants = 37,
            .variants = 17,
            .alone = each_alone(homework::vista::steps(), techniques::vista::reference(),
                                &Steps::lod, &Steps::tessellate, &Steps::clip, &Steps::sort,
                                &Steps::project, &Steps::rasterise, &Steps::look_up)};
}

}  // namespace luch::testing
