// The tasks of this homework and their points, by the ids that steps.cpp, the handout and the tests
// share; and what the checker needs besides.
#include "homework/layered/check/instructors.h"
#include "homework/layered/check/tests.h"

namespace luch::homework::layered {

Steps steps();

namespace {

grading::Homework make(const std::filesystem::path& root, std::optional<std::uint64_t> seed) {
    const grading::Instructors<Sample> instructed = instructors();
    const Samples samples = grading::all_samples(stored_samples(root), seed, instructed);
    return {.topic = "layered",
            .readme = "homework/layered/README.md",
            .yours = steps(),
            .tasks = {cut_task(samples), coc_task(samples), gaussian_task(samples),
                      disc_task(samples), over_task(samples)},
            .mutants = instructed.mutants,
            .variants = instructed.variants};
}

}  // namespace

grading::Checker checker() {
    const grading::Instructors<Sample> instructed = instructors();
    return {"layered", make, instructed.regenerate, instructed.handout};
}

}  // namespace luch::homework::layered
