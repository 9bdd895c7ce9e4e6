// The tasks of this homework and their points, by the ids that steps.cpp, the handout and the tests
// share; and what the checker needs besides.
#include "homework/ldr/check/instructors.h"
#include "homework/ldr/check/tests.h"

namespace luch::homework::ldr {

Steps steps();

namespace {

grading::Homework make(const std::filesystem::path& root, std::optional<std::uint64_t> seed) {
    const grading::Instructors<Sample> instructed = instructors();
    const Samples samples = grading::all_samples(stored_samples(root), seed, instructed);
    return {.topic = "ldr",
            .readme = "homework/ldr/README.md",
            .yours = steps(),
            .tasks = {encode_task(samples), add_task(samples), modulate_task(samples),
                      mix_task(samples), lerp_task(samples), accumulate_task(samples),
                      resolve_task(samples)},
            .mutants = instructed.mutants,
            .variants = instructed.variants};
}

}  // namespace

grading::Checker checker() {
    const grading::Instructors<Sample> instructed = instructors();
    return {"ldr", make, instructed.regenerate, instructed.handout};
}

}  // namespace luch::homework::ldr
