#pragma once

#include "framework/base/error.h"
#include "framework/grading/checker.h"

#include <memory>
#include <utility>

namespace luch::grading {

/// What of a homework's checker needs the reference steps. `Sample`: what its tasks are tried on.
/// Empty in the students' kit.
template <class Sample>
struct Instructors {
    std::vector<Other> mutants{}, variants{};
    /// Samples that nobody has seen.
    std::vector<Sample> (*samples_from_seed)(std::uint64_t seed) = nullptr;
    /// See Checker.
    decltype(Checker::regenerate) regenerate = nullptr;
    decltype(Checker::handout) handout = nullptr;
};

/// Samples that tests share.
template <class Sample>
using SharedSamples = std::vector<std::shared_ptr<const Sample>>;

/// Those that everybody knows and, with a seed, hidden ones. Throws Error when a seed needs
/// reference steps that are not here.
template <class Sample>
SharedSamples<Sample> all_samples(std::vector<Sample> known, std::optional<std::uint64_t> seed,
                                  const Instructors<Sample>& instructors) {
    SharedSamples<Sample> all;
    const auto add = [&](std::vector<Sample> more) {
        for (Sample& sample : more)
            all.push_back(std::make_shared<const Sample>(std::move(sample)));
    };
    add(std::move(known));
    if (!seed) return all;
    if (instructors.samples_from_seed == nullptr) {
        throw Error("--seed: the reference steps are not part of this tree");
    }
    add(instructors.samples_from_seed(*seed));
    return all;
}

}  // namespace luch::grading
