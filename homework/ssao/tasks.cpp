// The tasks of this homework and their points, by the ids that steps.cpp, the handout and the tests
// share; and what the checker needs besides.
#include "framework/base/error.h"
#include "framework/grading/checker.h"
#include "homework/ssao/check/instructors.h"
#include "homework/ssao/check/tests.h"

namespace luch::homework::ssao {

Steps steps();

namespace {

void add(Samples& samples, std::vector<Sample> more) {
    for (Sample& sample : more) {
        samples.push_back(std::make_shared<const Sample>(std::move(sample)));
    }
}

grading::Homework make(const std::filesystem::path& root, std::optional<std::uint64_t> seed) {
    const Instructors instructed = instructors();
    Samples samples;
    add(samples, stored_samples(root));
    if (seed) {
        if (instructed.samples_from_seed == nullptr) {
            throw Error("--seed: the reference steps are not part of this tree");
        }
        add(samples, instructed.samples_from_seed(*seed));
    }
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
    const Instructors instructed = instructors();
    return {"ssao", make, instructed.regenerate, instructed.handout};
}

}  // namespace luch::homework::ssao
