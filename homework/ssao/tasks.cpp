// The tasks of this homework and their points, by the ids that steps.cpp, the handout and the tests
// share; and what the checker needs besides.
#include "homework/ssao/check/instructors.h"
#include "homework/ssao/check/tests.h"

namespace luch::homework::ssao {

Steps steps();

namespace {

grading::Homework make(const std::filesystem::path& root, std::optional<std::uint64_t> seed) {
    const grading::Instructors<Sample> instructed = instructors();
    const Samples samples = grading::all_samples(stored_samples(root), seed, instructed);
    return {.topic = "ssao",
            .readme = "homework/ssao/README.md",
            .yours = steps(),
            .tasks = {positions_task(samples), normals_task(samples), kernel_task(samples),
                      occlusion_task(samples), blur_task(samples), upsample_task(samples),
                      apply_task(samples)},
            .mutants = instructed.mutants,
            .variants = instructed.variants};
}

}  // namespace

grading::Checker checker() {
    const grading::Instructors<Sample> instructed = instructors();
    return {"ssao", make, instructed.regenerate, instructed.handout};
}

}  // namespace luch::homework::ssao
