// The tasks of this homework and their points, by the ids that steps.cpp, the handout and the tests
// share; and what the checker needs besides.
#include "framework/base/error.h"
#include "framework/grading/checker.h"
#include "homework/vista/check/make_samples.h"
#include "homework/vista/check/others.h"
#include "homework/vista/check/tests.h"

namespace luch::homework::vista {

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
    return {.topic = "vista",
            .readme = "homework/vista/README.md",
            .yours = steps(),
            .tasks = {lod_task(stored_lod(root)), tessellate_task(samples), clip_task(samples),
                      sort_task(samples), project_task(samples), rasterise_task(samples),
                      look_up_task(samples)},
            .mutants = mutants(),
            .variants = variants()};
}

int make_again(const std::filesystem::path& root, bool consent,
               const std::function<void(const std::string&)>& say) {
    return regenerate(root, reference(), consent, say);
}

}  // namespace

grading::Checker checker() {
    return {"vista", make, make_again};
}

}  // namespace luch::homework::vista
