#include "techniques/ldr/plan.h"

#include "framework/baseline/stages.h"
#include "framework/scene/census.h"
#include "framework/technique/samples.h"

#include <algorithm>

namespace luch::techniques::ldr {
namespace {

/// What a single plane in a word may be off by: half a level of linear light, and with that one of
/// the screen, which near white is 2.28/255 wide (the sRGB curve's slope there is 2.4/1.055).
constexpr float one_plane = (0.5f + 2.28f) / 255;

bool several_samples(const Scene& scene, const Shot& shot) {
    return sample_count(shot) > 1 || (may_antialias(shot) && scene.settings.anti_aliasing);
}

Stage accumulator_stage(const Scene& scene, const Shot& shot) {
    const bool several = several_samples(scene, shot);
    return {std::string(accumulator), several, Stage::exact,
            several ? "several samples make a pixel"
                    : "one sample makes a pixel: the mean of one word is that word"};
}

/// Sums of lights, and products with albedos, lose what lies above white and what is less than half
/// a level.
Stage wide_light_stage(const Census& has, bool toned) {
    const bool sums = has.lit > 0 || has.layered > 0;
    if (sums || toned) {
        return {std::string(wide_light), true, Stage::bounded,
                toned ? "the curve needs to know what lies above white"
                      : "lights are summed, or layers blended"};
    }
    return {std::string(wide_light), false, Stage::bounded,
            "nothing is summed: one plane, one word", one_plane};
}

/// A scene that cannot show anything brighter than white, by its settings alone.
bool within_white(const Scene& scene, const Census& has, float exposure) {
    const auto within = [&](const Rgb& colour) { return max_norm(colour * exposure) <= 1; };
    if (has.lights() > 0 || has.glowing > 0 || has.layered > 0) return false;
    if (has.textured > 0 || has.mirrors > 0 || has.clear > 0 || scene.environment) return false;
    const auto dim = [&](const Material& material) {
        if (const auto* paint = std::get_if<Const>(&material)) return within(paint->color);
        if (const auto* matt = std::get_if<Lambert>(&material)) return within(matt->color);
        if (const auto* shiny = std::get_if<Phong>(&material)) return within(shiny->color);
        return true;
    };
    return within(scene.settings.background) && within(scene.settings.ambient_light) &&
           std::ranges::all_of(scene.materials, dim);
}

Stage tone_stage(const Scene& scene, const Census& has, float exposure) {
    const bool within = within_white(scene, has, exposure);
    return {std::string(tone_mapping), !within, Stage::exact,
            within ? "nothing can be brighter than white, and then the curve changes nothing"
                   : "something may be brighter than white"};
}

Stage texture_stage(const Scene& scene) {
    const bool bitmaps = std::ranges::any_of(scene.textures, [](const Texture& texture) {
        return std::holds_alternative<BitmapTexture>(texture);
    });
    return {
        std::string(word_textures), bitmaps, Stage::exact,
        bitmaps ? "bitmaps of 8 bits a channel, at a third of the bytes" : "there is no bitmap"};
}

}  // namespace

Plan plan_of(const Scene& scene, const Shot& shot, const Params& params) {
    Plan plan{.applies = true, .why = "", .stages = classic_stages(scene, shot)};
    const Census has = census_of(scene);
    const bool toned = Tone(params.tone) == Tone::reinhard;
    if (params.wide) {
        plan.stages.push_back(accumulator_stage(scene, shot));
        plan.stages.push_back(wide_light_stage(has, toned));
        if (toned) {
            const auto exposure = static_cast<float>(std::exp2(params.exposure_ev));
            plan.stages.push_back(tone_stage(scene, has, exposure));
        }
    }
    if (params.textures) plan.stages.push_back(texture_stage(scene));
    return plan;
}

bool runs(const Plan& plan, std::string_view stage) {
    const auto found = std::ranges::find(plan.stages, stage, &Stage::name);
    return found != plan.stages.end() && found->needed;
}

}  // namespace luch::techniques::ldr
