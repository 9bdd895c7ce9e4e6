#include "framework/window/screenshot.h"

#include "framework/image/io.h"

#include <fmt/format.h>

#include <array>

namespace luch {

std::filesystem::path free_screenshot_name(const std::filesystem::path& folder) {
    for (int number = 0;; ++number) {
        const auto file = folder / fmt::format("luch-view-{:03}.png", number);
        if (!exists(file)) return file;
    }
}

void write_screenshot(const std::filesystem::path& file, const Image<Pixel>& picture) {
    std::array<float, 256> linear_of;
    for (int i = 0; i < 256; ++i) linear_of[i] = srgb_decoded(static_cast<float>(i) / 255.0f);
    Image<Rgb> linear(picture.size());
    for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
        const Pixel& pixel = picture.pixels()[i];
        linear.pixels()[i] = {linear_of[pixel.r], linear_of[pixel.g], linear_of[pixel.b]};
    }
    write_picture(file, linear.view());
}

}  // namespace luch
