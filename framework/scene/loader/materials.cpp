#include "framework/base/text.h"
#include "framework/scene/loader/blocks.h"

#include <fmt/format.h>

namespace luch::loader {
namespace {

void add(Loading& loading, Properties& block, Material material) {
    loading.scene.materials.push_back(std::move(material));
    loading.material_lines.push_back(block.block().line);
}

/// A texture that has a colour.
TextureId coloured_texture(const std::string& name, int line, const Loading& loading) {
    const TextureId id = loading.names.find(Kind::texture, name, line, loading.diagnostics);
    if (is_bump(loading.scene.textures[id])) {
        loading.diagnostics.fail(line, fmt::format("{} is a bump, which has no colour; "
                                                   "choose a texture of another class",
                                                   shown(name)));
    }
    return id;
}

TextureId texture_of(Properties& block, const Loading& loading) {
    const Property* property = block.find("texture");
    if (!property) return no_texture;
    return coloured_texture(block.text(*property), property->line, loading);
}

/// A colour, or one number for grey.
Rgb colour_or_grey(Properties& block, const Property& property) {
    if (words_of(property.value).size() == 3) return Rgb(block.vector(property));
    return Rgb(static_cast<float>(block.number(property)));
}

/// `multiplier` is one number, grey, or a colour; it counts where the colour itself is not given.
Rgb multiplied(Properties& block, Names color, const Rgb& fallback) {
    const Property* multiplier = block.find("multiplier");
    if (const Property* property = block.find(color)) return Rgb(block.vector(*property));
    return multiplier ? colour_or_grey(block, *multiplier) : fallback;
}

Layered::Layer layer_of(const Property& line, const Loading& loading) {
    const std::vector<std::string> words = words_of(line.value);
    const auto is_wrong = [&] {
        if (words.size() != 4 && words.size() != 5) return true;
        for (int k = 1; k <= 3; ++k) {
            const auto value = parsed_number(words[k]);
            if (!value || std::abs(*value) > Range{}.most) return true;
        }
        return false;
    };
    if (is_wrong()) {
        loading.diagnostics.fail(line.line,
                                 fmt::format("layer is {}; write a shader, a colour and perhaps a "
                                             "texture, as in \"layer mirror (1, 1, 1) mask\"",
                                             shown(line.value)));
    }
    Layered::Layer layer{};
    layer.material = loading.names.find(Kind::shader, words[0], line.line, loading.diagnostics);
    for (int k = 0; k < 3; ++k) layer.blend[k] = static_cast<float>(*parsed_number(words[k + 1]));
    if (words.size() == 5) layer.texture = coloured_texture(words[4], line.line, loading);
    return layer;
}

}  // namespace

void read_lambert(Properties& block, Loading& loading) {
    Lambert lambert;
    lambert.color = block.color("color", lambert.color);
    lambert.texture = texture_of(block, loading);
    add(loading, block, lambert);
}

void read_phong(Properties& block, Loading& loading) {
    Phong phong;
    phong.color = block.color("color", phong.color);
    phong.texture = texture_of(block, loading);
    if (const auto* specular = block.find({"specular", "specularMultiplier", "strength"})) {
        phong.specular = colour_or_grey(block, *specular);
    }
    phong.exponent =
        block.number({"exponent", "specularExponent"}, phong.exponent, {0, positive.most});
    add(loading, block, phong);
}

void read_reflection(Properties& block, Loading& loading) {
    Reflection reflection;
    reflection.multiplier = multiplied(block, {"reflColor", "color"}, reflection.multiplier);
    reflection.glossiness = block.number("glossiness", reflection.glossiness, {0, 1});
    reflection.samples = block.integer("numSamples", reflection.samples, {1, 1e6});
    add(loading, block, reflection);
}

void read_refraction(Properties& block, Loading& loading) {
    Refraction refraction;
    refraction.multiplier = multiplied(block, {"refrColor", "color"}, refraction.multiplier);
    refraction.ior = block.number("ior", refraction.ior, positive);
    refraction.inside_color = block.color("insideColor", refraction.inside_color);
    refraction.absorption = block.number("absorption", refraction.absorption, {0, positive.most});
    add(loading, block, refraction);
}

void read_layered(Properties& block, Loading& loading) {
    Layered layered;
    for (const Property* line : block.lines({"layer"})) {
        layered.layers.push_back(layer_of(*line, loading));
    }
    add(loading, block, std::move(layered));
}

void read_const(Properties& block, Loading& loading) {
    Const constant;
    constant.color = block.color("color", constant.color);
    add(loading, block, constant);
}

}  // namespace luch::loader
