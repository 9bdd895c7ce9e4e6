#include "framework/window/text.h"

#include <stb/stb_easy_font.h>

#include <cmath>
#include <cstring>

namespace luch {
namespace {

/// What the font's printing writes: a corner of a quad.
struct Corner {
    float x, y, z;
    std::uint8_t colour[4];
};
/// No glyph of the font needs more quads than this.
constexpr std::size_t bytes_per_character = 40 * 4 * sizeof(Corner);

std::string printable(std::string_view line) {
    std::string text(line);
    for (char& c : text) {
        if (c < ' ' || c > '~') c = '?';
    }
    return text;
}

std::uint8_t mixed(std::uint8_t below, std::uint8_t above, float opacity) {
    return static_cast<std::uint8_t>(std::lround(below + (above - below) * opacity));
}

/// The longest beginning of the text that fits, at least one character; cut at a blank if possible.
std::size_t fitting(std::string_view text, int scale, int width_px) {
    std::size_t count = text.size();
    while (count > 1 && text_width(text.substr(0, count), scale) > width_px) {
        const std::size_t blank = text.substr(0, count).find_last_of(' ');
        count = blank == std::string_view::npos || blank == 0 ? count - 1 : blank;
    }
    return count;
}

}  // namespace

int text_width(std::string_view line, int scale) {
    return stb_easy_font_width(printable(line).data()) * scale;
}

void draw_text(ImageView<Pixel> picture, int x, int y, int scale, std::string_view line,
               Pixel colour) {
    std::string text = printable(line);
    std::vector<char> buffer(text.size() * bytes_per_character);
    const int quads = stb_easy_font_print(0, 0, text.data(), nullptr, buffer.data(),
                                          static_cast<int>(buffer.size()));
    for (int quad = 0; quad < quads; ++quad) {
        Corner first, opposite;
        const std::size_t at = static_cast<std::size_t>(quad) * 4 * sizeof(Corner);
        std::memcpy(&first, buffer.data() + at, sizeof(Corner));
        std::memcpy(&opposite, buffer.data() + at + 2 * sizeof(Corner), sizeof(Corner));
        fill(picture,
             {x + static_cast<int>(first.x) * scale, y + static_cast<int>(first.y) * scale,
              x + static_cast<int>(opposite.x) * scale, y + static_cast<int>(opposite.y) * scale},
             colour);
    }
}

std::vector<std::string> wrapped(std::string_view text, int scale, int width_px) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t count = fitting(text, scale, width_px);
        lines.emplace_back(text.substr(0, count));
        text.remove_prefix(count);
        if (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    }
    return lines;
}

void fill(ImageView<Pixel> picture, Tile area, Pixel colour, float opacity) {
    const int x0 = std::max(area.x0, 0), x1 = std::min(area.x1, picture.width());
    const int y0 = std::max(area.y0, 0), y1 = std::min(area.y1, picture.height());
    for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) {
            Pixel& pixel = picture(x, y);
            pixel = {mixed(pixel.r, colour.r, opacity), mixed(pixel.g, colour.g, opacity),
                     mixed(pixel.b, colour.b, opacity)};
        }
    }
}

}  // namespace luch
