#include "homework/layered/check/instructors.h"

#include "framework/scene/loader/loader.h"
#include "framework/technique/run.h"
#include "homework/layered/check/make_samples.h"
#include "homework/layered/check/others.h"

namespace luch::homework::layered {
namespace {

std::vector<Sample> hidden_samples(std::uint64_t seed) {
    return samples_from_seed(seed, reference());
}

int make_again(const std::filesystem::path& root, const grading::Regeneration& regeneration) {
    return regenerate(root, reference(), regeneration);
}

Image<Rgb> picture(const std::filesystem::path& file, Mode mode) {
    const Scene scene = load_scene(file).scene;
    const auto accelerator = build_accelerator(scene);
    const Workers workers;
    Shot shot = shot_of(scene);
    shot.size = {176, 132};
    return run(*make(reference(), mode), {scene, *accelerator, workers}, shot, {}, {0, 1})
        .frame.colour;
}

std::vector<grading::NamedPicture> pictures(const std::filesystem::path& root) {
    const auto fence = root / "scenes/fence/fence.scene";
    return {{"classic", picture(fence, Mode::classic)},
            {"discs", picture(fence, Mode::discs)},
            {"lens", picture(fence, Mode::lens)},
            {"posts", picture(root / "homework/layered/scenes/posts.scene", Mode::discs)}};
}

}  // namespace

grading::Instructors<Sample> instructors() {
    return {mutants(), variants(), hidden_samples, make_again, pictures};
}

}  // namespace luch::homework::layered
