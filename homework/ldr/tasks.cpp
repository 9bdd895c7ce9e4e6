// The tasks of this homework and their points, by the ids that steps.cpp, the handout and the tests
// share; and what the checker needs besides.
#include "framework/grading/checker.h"
#include "homework/ldr/check/make_samples.h"
#include "homework/ldr/check/others.h"
#include "homework/ldr/check/tests.h"

namespace luch::homework::ldr {

Steps steps();

namespace {

grading::Homework make(const std::filesystem::path& root, std::optional<std::uint64_t> seed) {
    Samples samples;
    for (Sample& sample : stored_samples(root)) {
        samples.push_back(std::make_shared<const Sample>(std::move(sample)));
    }
    if (seed) {
        for (Sample& sample : samples_from_seed(*seed, techniques::ldr::reference())) {
            samples.push_back(std::make_shared<const Sample>(std::move(sample)));
        }
    }
    return {.topic = "ldr",
            .readme = "homework/ldr/README.md",
            .yours = steps(),
            .tasks = {encode_task(samples), add_task(samples), modulate_task(samples),
                      mix_task(samples), lerp_task(samples), accumulate_task(samples),
                      resolve_task(samples)},
            .mutants = mutants(),
            .variants = variants()};
}

int make_again(const std::filesystem::path& root, bool consent,
               const std::function<void(const std::string&)>& say) {
    return regenerate(root, techniques::ldr::reference(), consent, say);
}

}  // namespace

grading::Checker checker() {
    return {"ldr", make, make_again};
}

}  // namespace luch::homework::ldr
