#include "homework/shadow_map/check/instructors.h"

#include "homework/shadow_map/check/make_samples.h"
#include "homework/shadow_map/check/others.h"
#include "homework/shadow_map/check/pictures.h"

namespace luch::homework::shadow_map {
namespace {

std::vector<Sample> hidden_samples(std::uint64_t seed) {
    return samples_from_seed(seed, reference());
}

int make_again(const std::filesystem::path& root, const grading::Regeneration& regeneration) {
    return regenerate(root, reference(), regeneration);
}

}  // namespace

grading::Instructors<Sample> instructors() {
    return {mutants(), variants(), hidden_samples, make_again, handout_pictures};
}

}  // namespace luch::homework::shadow_map
