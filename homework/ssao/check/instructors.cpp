#include "homework/ssao/check/instructors.h"

#include "framework/scene/loader/loader.h"
#include "framework/technique/run.h"
#include "homework/ssao/check/make_samples.h"
#include "homework/ssao/check/others.h"

namespace luch::homework::ssao {
namespace {

std::vector<Sample> hidden_samples(std::uint64_t seed) {
    return samples_from_seed(seed, reference());
}

int make_again(const std::filesystem::path& root, const grading::Regeneration& regeneration) {
    return regenerate(root, reference(), regeneration);
}

Image<Rgb> picture(const std::filesystem::path& file, const Params& params) {
    const Scene scene = load_scene(file).scene;
    const auto accelerator = build_accelerator(scene);
    const Workers workers;
    Shot shot = shot_of(scene);
    shot.size = {176, 132};
    return run(*make(reference(), params), {scene, *accelerator, workers}, shot, {}, {0, 1})
        .frame.colour;
}

/// Larger than usual, so that small pictures show it.
constexpr double shown_radius = 1.5;

std::vector<grading::NamedPicture> pictures(const std::filesystem::path& root) {
    const auto clay = root / "scenes/clay/clay.scene";
    const Params classic{.mode = static_cast<int>(Mode::classic),
                         .radius = shown_radius,
                         .normals = static_cast<int>(Normals::picture)};
    Params raw = classic;
    raw.show = static_cast<int>(Show::visibility);
    raw.smoothing = static_cast<int>(Smoothing::off);
    Params soft = raw;
    soft.smoothing = static_cast<int>(Smoothing::edges);
    return {{"raw", picture(clay, raw)},
            {"blurred", picture(clay, soft)},
            {"lit", picture(clay, classic)},
            {"best", picture(clay, {.radius = shown_radius})}};
}

}  // namespace

grading::Instructors<Sample> instructors() {
    return {mutants(), variants(), hidden_samples, make_again, pictures};
}

}  // namespace luch::homework::ssao
