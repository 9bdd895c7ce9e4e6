// The tasks of this homework and their points, by the ids that steps.cpp, the handout and the tests
// share; and what the checker needs besides.
#include "framework/base/error.h"
#include "framework/grading/checker.h"
#include "homework/ldr/check/instructors.h"
#include "homework/ldr/check/tests.h"

namespace luch::homework::ldr {

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
    return {"ldr", make, instructors().regenerate};
}

}  // namespace luch::homework::ldr
