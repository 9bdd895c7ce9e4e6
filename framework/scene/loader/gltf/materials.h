#pragma once

#include "framework/scene/loader/blocks.h"
#include "framework/scene/loader/gltf/document.h"

#include <map>
#include <tuple>

namespace luch::loader::gltf {

/// The materials of one file, as Lambert: the base colour, or its texture times that colour.
class Materials {
 public:
    Materials(Document& document, Loading& loading) : document_(document), loading_(loading) {}

    /// The material of a primitive, as an index into Loading::file_materials; white where it has
    /// none. Pictures are added to the scene's textures.
    MaterialId of(const Part& primitive);

 private:
    Lambert read(const Part& material);
    TextureId texture_of(const Part& info, const Rgb& factor);
    void warn(const Part& part, const std::string& what);
    Image<Rgb> picture_of(const Part& image);

    Document& document_;
    Loading& loading_;
    std::map<std::uint64_t, MaterialId> materials_;
    std::map<std::tuple<std::uint64_t, float, float, float>, TextureId> textures_;
    std::optional<MaterialId> white_;
};

}  // namespace luch::loader::gltf
