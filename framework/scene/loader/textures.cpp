#include "framework/scene/loader/blocks.h"

#include <fmt/format.h>

namespace luch::loader {
namespace {

constexpr Range gammas{0.01, 100};

double scaling_of(Properties& block, double fallback) {
    const Property* property = block.find("scaling");
    if (!property) return fallback;
    const double scaling = block.number(*property);
    if (std::abs(scaling) < positive.least) {
        block.diagnostics().fail(property->line, "scaling is 0; choose another number");
    }
    return scaling;
}

/// The side's picture under the first ending that is there.
std::filesystem::path side_of(Properties& block, const Property& property, const Assets& assets,
                              std::string_view side) {
    for (const char* ending : {".bmp", ".png", ".exr", ".hdr"}) {
        Property named = property;
        named.value = fmt::format("\"{}/{}{}\"", block.text(property), side, ending);
        std::filesystem::path file = assets.path(block, named);
        if (std::filesystem::exists(file)) return file;
    }
    block.diagnostics().fail(property.line,
                             fmt::format("the folder {} has no {} side; put {}.bmp, .png, .exr or "
                                         ".hdr there",
                                         shown(block.text(property)), side, side));
}

}  // namespace

void read_checker(Properties& block, Loading& loading) {
    CheckerTexture checker;
    checker.color1 = block.color("color1", checker.color1);
    checker.color2 = block.color("color2", checker.color2);
    checker.scaling = scaling_of(block, checker.scaling);
    loading.scene.textures.emplace_back(checker);
}

void read_bitmap(Properties& block, Loading& loading) {
    const Property& file = block.required("file");
    const double gamma = block.number("assumedGamma", 1, gammas);
    BitmapTexture bitmap;
    bitmap.scaling = scaling_of(block, bitmap.scaling);
    bitmap.pixels = loading.assets.picture(loading.assets.path(block, file), gamma,
                                           loading.diagnostics.place(file.line));
    loading.scene.textures.emplace_back(std::move(bitmap));
}

void read_bump(Properties& block, Loading& loading) {
    const Property& file = block.required("file");
    BumpTexture bump;
    bump.strength = block.number("strength", bump.strength);
    bump.scaling = scaling_of(block, bump.scaling);
    const Image<Rgb> heights = loading.assets.picture(loading.assets.path(block, file), 1,
                                                      loading.diagnostics.place(file.line));
    bump.slopes = slopes_of(heights.view());
    loading.scene.textures.emplace_back(std::move(bump));
}

void read_cubemap(Properties& block, Loading& loading) {
    const Property& folder = block.required("folder");
    const double gamma = block.number("assumedGamma", 1, gammas);
    if (loading.scene.environment) {
        loading.diagnostics.warn(block.block().line,
                                 "there is a CubemapEnvironment already, and the first one counts; "
                                 "remove one of the two");
        return;
    }
    constexpr std::string_view sides[] = {"negx", "negy", "negz", "posx", "posy", "posz"};
    CubemapEnvironment environment;
    for (std::size_t i = 0; i < std::size(sides); ++i) {
        environment.sides[i] =
            loading.assets.picture(side_of(block, folder, loading.assets, sides[i]), gamma,
                                   loading.diagnostics.place(folder.line));
    }
    loading.scene.environment = std::move(environment);
}

}  // namespace luch::loader
