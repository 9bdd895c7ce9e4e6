#include "homework/ldr/check/instructors.h"

#include "homework/ldr/check/make_samples.h"
#include "homework/ldr/check/others.h"

namespace luch::homework::ldr {
namespace {

std::vector<Sample> unseen(std::uint64_t seed) {
    return samples_from_seed(seed, techniques::ldr::reference());
}

int make_again(const std::filesystem::path& root, const grading::Regeneration& regeneration) {
    return regenerate(root, techniques::ldr::reference(), regeneration);
}

}  // namespace

Instructors instructors() {
    return {mutants(), variants(), unseen, make_again};
}

}  // namespace luch::homework::ldr
