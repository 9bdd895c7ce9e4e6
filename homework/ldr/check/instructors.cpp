#include "homework/ldr/check/instructors.h"

#include "framework/scene/loader/loader.h"
#include "framework/technique/run.h"
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

/// A scene of the tree's own, by the reference steps with one parameter set after the other.
Image<Rgb> picture(const std::filesystem::path& root, const std::string& scene_name,
                   std::initializer_list<std::string_view> params) {
    const Scene scene = load_scene(root / "scenes" / scene_name / (scene_name + ".scene")).scene;
    const auto accelerator = build_accelerator(scene);
    const Workers workers;
    Shot shot = shot_of(scene);
    shot.size = {200, 150};
    shot.spp = 1;
    const auto technique = make(techniques::ldr::reference());
    for (const std::string_view each : params) set_param(*technique, each);
    return run(*technique, {scene, *accelerator, workers}, shot, {}, {0, 1}).frame.colour;
}

std::vector<grading::NamedPicture> pictures(const std::filesystem::path& root) {
    return {{"many_lights_wide_off", picture(root, "many_lights", {"wide=off"})},
            {"many_lights_wide_on", picture(root, "many_lights", {"wide=on"})},
            {"levels_16_dither_off", picture(root, "spheres", {"levels=16", "dither=off"})},
            {"levels_16_dither_on", picture(root, "spheres", {"levels=16", "dither=on"})}};
}

}  // namespace

grading::Instructors<Sample> instructors() {
    return {mutants(), variants(), unseen, make_again, pictures};
}

}  // namespace luch::homework::ldr
