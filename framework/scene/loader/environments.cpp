#include "framework/scene/loader/blocks.h"

#include <fmt/format.h>

namespace luch::loader {
namespace {

constexpr Range gammas{0.01, 100};

/// The side's picture under the first ending that is there.
std::filesystem::path side_of(Properties& block, const Property& property, Assets& assets,
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

/// Whether there is one already, which counts; a warning then.
bool has_environment(Properties& block, Loading& loading) {
    if (!loading.scene.environment) return false;
    loading.diagnostics.warn(block.block().line,
                             "there is an environment already, and the first one counts; remove "
                             "one of the two");
    return true;
}

}  // namespace

void read_cubemap(Properties& block, Loading& loading) {
    const Property& folder = block.required("folder");
    const double gamma = block.number("assumedGamma", 1, gammas);
    if (has_environment(block, loading)) return;
    constexpr std::string_view sides[] = {"negx", "negy", "negz", "posx", "posy", "posz"};
    CubemapEnvironment environment;
    for (std::size_t i = 0; i < std::size(sides); ++i) {
        environment.sides[i] =
            loading.assets.picture(side_of(block, folder, loading.assets, sides[i]), gamma,
                                   loading.diagnostics.place(folder.line));
    }
    loading.scene.environment = std::move(environment);
}

void read_constant_environment(Properties& block, Loading& loading) {
    ConstantEnvironment environment;
    environment.color = block.color("color", environment.color);
    if (!has_environment(block, loading)) loading.scene.environment = environment;
}

}  // namespace luch::loader
