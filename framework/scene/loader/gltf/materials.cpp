#include "framework/scene/loader/gltf/materials.h"

namespace luch::loader::gltf {
namespace {

Rgb base_colour(const Part& shading) {
    const auto factor = shading.numbers("baseColorFactor", 4);
    if (!factor) return Rgb(1);
    return {(*factor)[0], (*factor)[1], (*factor)[2]};
}

/// Whether a sampler repeats its picture in both directions, which is glTF's default.
bool repeats(const Part& sampler) {
    constexpr std::uint64_t repeat = 10497;
    return sampler.whole("wrapS").value_or(repeat) == repeat &&
           sampler.whole("wrapT").value_or(repeat) == repeat;
}

}  // namespace

MaterialId Materials::of(const Part& primitive) {
    const auto add = [&](const Lambert& material) {
        loading_.file_materials.emplace_back(material);
        return static_cast<MaterialId>(loading_.file_materials.size() - 1);
    };
    const auto index = primitive.whole("material");
    if (!index) {
        if (!white_) white_ = add({.color = Rgb(1)});
        return *white_;
    }
    const Part material = document_.element("materials", *index, primitive);
    if (const auto known = materials_.find(*index); known != materials_.end()) return known->second;
    return materials_[*index] = add(read(material));
}

Lambert Materials::read(const Part& material) {
    if (material.text("alphaMode").value_or("OPAQUE") != "OPAQUE") {
        warn(material, "its alphaMode is passed over; it is drawn opaque");
    }
    const auto shading = material.part("pbrMetallicRoughness");
    if (!shading) return {.color = Rgb(1)};
    Lambert lambert{.color = base_colour(*shading)};
    if (const auto texture = shading->part("baseColorTexture")) {
        lambert.texture = texture_of(*texture, lambert.color);
    }
    return lambert;
}

/// Where there is a factor as well, it is multiplied into the picture: a texture replaces a colour.
TextureId Materials::texture_of(const Part& info, const Rgb& factor) {
    if (info.whole("texCoord").value_or(0) != 0) {
        warn(info, "asks for another set of texture coordinates; TEXCOORD_0 is used");
    }
    if (const auto extensions = info.part("extensions");
        extensions && extensions->has("KHR_texture_transform")) {
        warn(info, "its KHR_texture_transform is passed over; bake it into the coordinates");
    }
    const Part texture = document_.element("textures", info.required_whole("index"), info);
    if (const auto sampler = texture.whole("sampler");
        sampler && !repeats(document_.element("samplers", *sampler, texture))) {
        warn(texture, "its sampler clamps or mirrors, which is passed over; the picture repeats");
    }
    const std::uint64_t source = texture.required_whole("source");
    const auto [known, is_new] =
        textures_.try_emplace({source, factor.r, factor.g, factor.b}, no_texture);
    if (!is_new) return known->second;

    BitmapTexture bitmap{.pixels = picture_of(document_.element("images", source, texture)),
                         .scaling = 1,
                         .texel_centre = 0.5};
    if (factor != Rgb(1)) {
        for (Rgb& pixel : bitmap.pixels.pixels()) pixel *= factor;
    }
    loading_.scene.textures.emplace_back(std::move(bitmap));
    return known->second = static_cast<TextureId>(loading_.scene.textures.size() - 1);
}

Image<Rgb> Materials::picture_of(const Part& image) {
    if (const auto uri = image.text("uri")) {
        const Document::Bytes picture = document_.read_uri(*uri, image);
        return document_.assets().picture_in(picture.bytes, picture.name);
    }
    const std::string_view bytes = document_.view(image.required_whole("bufferView"), image);
    return document_.assets().picture_in(bytes, image.title());
}

void Materials::warn(const Part& part, const std::string& what) {
    loading_.diagnostics.warn(Place{part.title()}, what);
}

}  // namespace luch::loader::gltf
