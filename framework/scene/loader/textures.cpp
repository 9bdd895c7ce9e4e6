#include "framework/scene/loader/blocks.h"

#include <fmt/format.h>

namespace luch::loader {
namespace {

constexpr Range gammas{0.01, 100};

double scaling_of(Properties& block, Names names, double fallback) {
    const Property* property = block.find(names);
    if (!property) return fallback;
    const double scaling = block.number(*property);
    if (std::abs(scaling) < positive.least) {
        block.diagnostics().fail(property->line,
                                 fmt::format("{} is 0; choose another number", property->name));
    }
    return scaling;
}

}  // namespace

void read_checker(Properties& block, Loading& loading) {
    CheckerTexture checker;
    checker.color1 = block.color("color1", checker.color1);
    checker.color2 = block.color("color2", checker.color2);
    checker.scaling = scaling_of(block, {"scaling", "size"}, checker.scaling);
    loading.scene.textures.emplace_back(checker);
}

void read_bitmap(Properties& block, Loading& loading) {
    const Property& file = block.required("file");
    const double gamma = block.number("assumedGamma", 1, gammas);
    BitmapTexture bitmap;
    bitmap.scaling = scaling_of(block, "scaling", bitmap.scaling);
    bitmap.pixels = loading.assets.picture(loading.assets.path(block, file), gamma,
                                           loading.diagnostics.place(file.line));
    loading.scene.textures.emplace_back(std::move(bitmap));
}

void read_bump(Properties& block, Loading& loading) {
    const Property& file = block.required("file");
    BumpTexture bump;
    bump.strength = block.number("strength", bump.strength);
    bump.scaling = scaling_of(block, "scaling", bump.scaling);
    const Image<Rgb> heights = loading.assets.picture(loading.assets.path(block, file), 1,
                                                      loading.diagnostics.place(file.line));
    bump.slopes = slopes_of(heights.view());
    loading.scene.textures.emplace_back(std::move(bump));
}

void read_bumps(Properties& block, Loading& loading) {
    Bumps bumps;
    bumps.strength = block.number("strength", bumps.strength);
    loading.scene.textures.emplace_back(bumps);
}

void read_fresnel(Properties& block, Loading& loading) {
    Fresnel fresnel;
    fresnel.ior = block.number("ior", fresnel.ior, positive);
    loading.scene.textures.emplace_back(fresnel);
}

}  // namespace luch::loader
