#include "homework/vista/check/instructors.h"

#include "homework/vista/check/make_samples.h"
#include "homework/vista/check/others.h"
#include "homework/vista/check/pictures.h"

namespace luch::homework::vista {
namespace {

std::vector<Sample> hidden_samples(std::uint64_t seed) {
    return samples_from_seed(seed, reference());
}

int make_again(const std::filesystem::path& root, const grading::Regeneration& regeneration) {
    return regenerate(root, reference(), regeneration);
}

std::vector<grading::NamedPicture> pictures(const std::filesystem::path& root) {
    return handout_pictures(root, reference());
}

}  // namespace

grading::Instructors<Sample> instructors() {
    return {mutants(), variants(), hidden_samples, make_again, pictures};
}

}  // namespace luch::homework::vista
