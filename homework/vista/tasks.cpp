// The tasks of this homework and their points, by the ids that steps.cpp, the handout and the tests
// share; and what the checker needs besides.
#include "homework/vista/check/instructors.h"
#include "homework/vista/check/tests.h"

namespace luch::homework::vista {

Steps steps();

namespace {

grading::Homework make(const std::filesystem::path& root, std::optional<std::uint64_t> seed) {
    const grading::Instructors<Sample> instructed = instructors();
    const Samples samples = grading::all_samples(stored_samples(root), seed, instructed);
    return {.topic = "vista",
            .readme = "homework/vista/README.md",
            .yours = steps(),
            .tasks = {lod_task(stored_lod(root)), tessellate_task(samples), clip_task(samples),
                      sort_task(samples), project_task(samples), rasterise_task(samples),
                      look_up_task(samples)},
            .mutants = instructed.mutants,
            .variants = instructed.variants};
}

}  // namespace

grading::Checker checker() {
    const grading::Instructors<Sample> instructed = instructors();
    return {"vista", make, instructed.regenerate, instructed.handout};
}

}  // namespace luch::homework::vista
