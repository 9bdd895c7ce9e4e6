// The tasks of this homework and their points, by the ids that steps.cpp, the handout and the tests
// share; and what the checker needs besides.
#include "framework/grading/checker.h"
#include "homework/layered/check/make_samples.h"
#include "homework/layered/check/others.h"
#include "homework/layered/check/tests.h"

namespace luch::homework::layered {

Steps steps();

namespace {

grading::Homework make(const std::filesystem::path& root, std::optional<std::uint64_t> seed) {
    Samples samples;
    for (Sample& sample : stored_samples(root)) {
        samples.push_back(std::make_shared<const Sample>(std::move(sample)));
    }
    if (seed) {
        for (Sample& sample : samples_from_seed(*seed, reference())) {
            samples.push_back(std::make_shared<const Sample>(std::move(sample)));
        }
    }
    return {.topic = "layered",
            .readme = "homework/layered/README.md",
            .yours = steps(),
            .tasks = {cut_task(samples), coc_task(samples), gaussian_task(samples),
                      disc_task(samples), over_task(samples)},
            .mutants = mutants(),
            .variants = variants()};
}

int make_again(const std::filesystem::path& root, bool consent,
               const std::function<void(const std::string&)>& say) {
    return regenerate(root, reference(), consent, say);
}

}  // namespace

grading::Checker checker() {
    return {"layered", make, make_again};
}

}  // namespace luch::homework::layered
