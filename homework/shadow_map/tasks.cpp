// The tasks of this homework and their points, by the ids that steps.cpp, the handout and the tests
// share; and what the checker needs besides.
#include "framework/base/error.h"
#include "framework/grading/checker.h"
#include "homework/shadow_map/check/instructors.h"
#include "homework/shadow_map/check/tests.h"

namespace luch::homework::shadow_map {

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
    const Instructors instructed = instructors();
    return {"shadow_map", make, instructed.regenerate, instructed.handout};
}

}  // namespace luch::homework::shadow_map
