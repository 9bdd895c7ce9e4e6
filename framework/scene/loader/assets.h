#pragma once

#include "framework/image/image.h"
#include "framework/math/colour.h"
#include "framework/scene/loader/loader.h"
#include "framework/scene/loader/properties.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace luch::loader {

/// The files that a scene names: where they may lie, and how much they may hold.
class Assets {
 public:
    Assets(const std::filesystem::path& scene, const LoadOptions& options);

    /// The path that a property names, relative to the scene file. Throws Error when it is absolute
    /// or leads out of the root, also over a link.
    std::filesystem::path path(Properties& block, const Property& property);

    /// A picture's numbers, decoded with the gamma that the scene assumes for it: 1 leaves them as
    /// they are, 2.2 means the sRGB curve, anything else is a power. All pictures of a scene
    /// together hold at most 256 megapixels.
    Image<Rgb> picture(const std::filesystem::path& file, double gamma, const Place& place);

    /// The path that a file of the scene names, relative to itself, under the same rule. Throws
    /// Error{file}.
    std::filesystem::path beside(const std::filesystem::path& file, const std::string& name);

    /// Every path that path() and beside() have given out, in that order.
    [[nodiscard]] const std::vector<std::filesystem::path>& named() const { return named_; }

    /// A PNG or JPEG file in memory, decoded to linear light; counted like any other picture.
    /// Throws Error{name}.
    Image<Rgb> picture_in(std::string_view bytes, const std::filesystem::path& name);

 private:
    [[nodiscard]] bool inside_root(const std::filesystem::path& file) const;
    void count(Size size, const std::filesystem::path& file);

    std::filesystem::path folder_;  ///< the scene's, as the user spelt it
    std::filesystem::path root_;    ///< canonical
    std::uintmax_t pixels_ = 0;
    std::vector<std::filesystem::path> named_;
};

}  // namespace luch::loader
