// The tasks of this homework and their points, by the ids that steps.cpp, the handout and the tests
// share; and what the checker needs besides.
#include "homework/shadow_map/check/instructors.h"
#include "homework/shadow_map/check/tests.h"

namespace luch::homework::shadow_map {

Steps steps();

namespace {

grading::Homework make(const std::filesystem::path& root, std::optional<std::uint64_t> seed) {
    const grading::Instructors<Sample> instructed = instructors();
    const Samples samples = grading::all_samples(stored_samples(root), seed, instructed);
    return {
        .topic = "shadow_map",
        .readme = "homework/shadow_map/README.md",
        .yours = steps(),
        .tasks = {texel_task(samples), direction_task(samples), face_task(samples),
                  bias_task(samples), lit_task(samples), pcf_task(samples), light_task(samples)},
        .mutants = instructed.mutants,
        .variants = instructed.variants};
}

}  // namespace

grading::Checker checker() {
    const grading::Instructors<Sample> instructed = instructors();
    return {"shadow_map", make, instructed.regenerate, instructed.handout};
}

}  // namespace luch::homework::shadow_map
