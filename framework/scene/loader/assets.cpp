#include "framework/scene/loader/assets.h"

#include "framework/image/io.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luch::loader {
namespace {

namespace fs = std::filesystem;

bool lies_under(const fs::path& file, const fs::path& folder) {
    const auto [in_folder, in_file] =
        std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
    // A path that ends in a slash has an empty last part.
    return in_folder == folder.end() ||
           (in_folder->empty() && std::next(in_folder) == folder.end());
}

fs::path root_for(const fs::path& folder, const LoadOptions& options) {
    if (!options.root.empty()) return fs::weakly_canonical(fs::absolute(options.root));
    const fs::path here = fs::weakly_canonical(fs::current_path());
    const fs::path scene = fs::weakly_canonical(fs::absolute(folder));
    return lies_under(scene, here) ? here : scene;
}

float decoded(float value, double gamma) {
    return value > 0 ? static_cast<float>(std::pow(value, gamma)) : 0;
}

void decode(Image<Rgb>& image, double gamma) {
    if (gamma == 1) return;
    for (Rgb& pixel : image.pixels()) {
        pixel = gamma == 2.2 ? srgb_decoded(pixel)
                             : Rgb(decoded(pixel.r, gamma), decoded(pixel.g, gamma),
                                   decoded(pixel.b, gamma));
    }
}

}  // namespace

Assets::Assets(const fs::path& scene, const LoadOptions& options)
    : folder_(scene.parent_path()),
      root_(root_for(folder_.empty() ? fs::path(".") : folder_, options)) {}

bool Assets::inside_root(const fs::path& file) const {
    std::error_code problem;
    const fs::path resolved = fs::weakly_canonical(fs::absolute(file), problem);
    return !problem && lies_under(resolved, root_);
}

fs::path Assets::path(Properties& block, const Property& property) {
    const std::string name = block.text(property);
    if (fs::path(name).is_absolute()) {
        block.diagnostics().fail(property.line,
                                 fmt::format("{} is an absolute path; name it relative to the "
                                             "scene, below the root that --root sets",
                                             shown(name)));
    }
    fs::path file = (folder_ / name).lexically_normal();
    if (!inside_root(file)) {
        block.diagnostics().fail(property.line,
                                 fmt::format("{} lies outside the root {}; move it there, or name "
                                             "a wider one with --root DIR",
                                             shown(name), root_.string()));
    }
    named_.push_back(file);
    return file;
}

Image<Rgb> Assets::picture(const fs::path& file, double gamma, const Place& place) {
    try {
        count(picture_size(file), file);
        Image<Rgb> image = read_picture(file).pixels;
        decode(image, gamma);
        return image;
    } catch (const Error& error) {
        throw Error(place, error.what());
    }
}

fs::path Assets::beside(const fs::path& file, const std::string& name) {
    const fs::path named = (file.parent_path() / name).lexically_normal();
    if (fs::path(name).is_absolute() || !inside_root(named)) {
        throw Error({file.string()},
                    fmt::format("{} lies outside the root {}; move it there, or name a wider one "
                                "with --root DIR",
                                shown(name), root_.string()));
    }
    named_.push_back(named);
    return named;
}

Image<Rgb> Assets::picture_in(std::string_view bytes, const fs::path& name) {
    count(picture_size(bytes, name), name);
    Image<Rgb> image = read_picture(bytes, name).pixels;
    decode(image, 2.2);
    return image;
}

void Assets::count(Size size, const fs::path& file) {
    constexpr std::uintmax_t most = std::uintmax_t{256} << 20;
    pixels_ += size.area();
    if (pixels_ > most) {
        throw Error({file.string()},
                    "brings the scene's pictures over 256 megapixels; make them smaller");
    }
}

}  // namespace luch::loader
