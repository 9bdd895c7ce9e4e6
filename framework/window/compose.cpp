#include "framework/window/compose.h"

#include "framework/window/text.h"

#include <cmath>

namespace luch {
namespace {

constexpr Pixel paper{0, 0, 0}, ink{235, 235, 235}, red{255, 110, 90}, wiper{255, 255, 255};
constexpr float paper_opacity = 0.62f;

/// Two screen pixels for one of the font's from a height of 600 on, and so in proportion.
int text_scale(Size window) {
    return std::max(1, static_cast<int>(std::lround(window.height / 400.0)));
}

/// Columns x0..x1 of the window from a picture that is stretched over the area, nearest pixel.
void paste(ImageView<Pixel> window, Tile area, const Image<Pixel>& picture, int x0, int x1) {
    if (picture.size().area() == 0) return;
    std::vector<int> columns;
    for (int x = x0; x < x1; ++x) {
        columns.push_back(
            static_cast<int>(std::int64_t{x - area.x0} * picture.width() / area.width()));
    }
    for (int y = area.y0; y < area.y1; ++y) {
        const int from =
            static_cast<int>(std::int64_t{y - area.y0} * picture.height() / area.height());
        for (int x = x0; x < x1; ++x) window(x, y) = picture(columns[x - x0], from);
    }
}

int block_width(const std::vector<std::string>& lines, int scale) {
    int width = 0;
    for (const std::string& line : lines) width = std::max(width, text_width(line, scale));
    return width + 6 * scale;
}

int block_height(std::size_t lines, int scale) {
    return lines == 0 ? 0 : (static_cast<int>(lines) * line_height_px + 6) * scale;
}

/// Lines of text on a dim rectangle.
void draw_block(ImageView<Pixel> window, int x, int y, int scale,
                const std::vector<std::string>& lines, Pixel colour) {
    const int margin = 3 * scale;
    fill(window, {x, y, x + block_width(lines, scale), y + block_height(lines.size(), scale)},
         paper, paper_opacity);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const int down = static_cast<int>(i) * line_height_px * scale;
        draw_text(window, x + margin, y + margin + 2 * scale + down, scale, lines[i], colour);
    }
}

void draw_pictures(ImageView<Pixel> window, Tile area, const Composition& composition) {
    if (composition.left == nullptr) return;
    if (composition.right == nullptr) {
        paste(window, area, *composition.left, area.x0, area.x1);
        return;
    }
    const int split = split_column(area, composition.split);
    paste(window, area, *composition.left, area.x0, split);
    paste(window, area, *composition.right, split, area.x1);
    if (split < area.x1) fill(window, {split, area.y0, split + 1, area.y1}, wiper);
}

void draw_labels(ImageView<Pixel> window, Tile area, int scale, const Composition& composition) {
    if (composition.right == nullptr) return;
    const int width = block_width({composition.right_label}, scale);
    draw_block(window, area.x0, area.y0, scale, {composition.left_label}, ink);
    draw_block(window, area.x1 - width, area.y0, scale, {composition.right_label}, ink);
}

void draw_status(ImageView<Pixel> window, int scale, const Composition& composition) {
    const int width = window.width() - 6 * scale;
    std::vector<std::string> status;
    for (const std::string& text : composition.status) {
        for (std::string& line : wrapped(text, scale, width)) status.push_back(std::move(line));
    }
    const std::vector<std::string> trouble = wrapped(composition.trouble, scale, width);
    int y = window.height() - block_height(trouble.size(), scale);
    if (!trouble.empty()) draw_block(window, 0, y, scale, trouble, red);
    y -= block_height(status.size(), scale);
    if (!status.empty()) draw_block(window, 0, y, scale, status, ink);
}

/// Two columns, the keys and what they do, a tab between.
void draw_help(ImageView<Pixel> window, int scale, const std::vector<std::string>& help) {
    if (help.empty()) return;
    std::vector<std::string> keys, texts;
    for (const std::string& line : help) {
        const std::size_t tab = std::min(line.find('\t'), line.size());
        keys.push_back(line.substr(0, tab));
        texts.push_back(line.substr(std::min(tab + 1, line.size())));
    }
    const int first = block_width(keys, scale), second = block_width(texts, scale);
    const int x = std::max(0, (window.width() - first - second) / 2);
    const int y = std::max(0, (window.height() - block_height(help.size(), scale)) / 2);
    draw_block(window, x, y, scale, keys, ink);
    draw_block(window, x + first, y, scale, texts, ink);
}

}  // namespace

Tile frame_area(Size window, Size frame) {
    if (window.area() == 0 || frame.area() == 0) return {};
    const double scale = std::min(window.width / static_cast<double>(frame.width),
                                  window.height / static_cast<double>(frame.height));
    const int width =
        std::clamp(static_cast<int>(std::lround(frame.width * scale)), 1, window.width);
    const int height =
        std::clamp(static_cast<int>(std::lround(frame.height * scale)), 1, window.height);
    const int x = (window.width - width) / 2, y = (window.height - height) / 2;
    return {x, y, x + width, y + height};
}

int split_column(Tile area, double split) {
    return area.x0 + static_cast<int>(std::lround(std::clamp(split, 0.0, 1.0) * area.width()));
}

Image<Pixel> composed(const Composition& composition) {
    Image<Pixel> picture(composition.window);
    if (picture.size().area() == 0) return picture;
    const ImageView<Pixel> window = picture.view();
    const Tile area = frame_area(composition.window, composition.frame);
    const int scale = text_scale(composition.window);
    draw_pictures(window, area, composition);
    draw_labels(window, area, scale, composition);
    draw_status(window, scale, composition);
    draw_help(window, scale, composition.help);
    return picture;
}

}  // namespace luch
