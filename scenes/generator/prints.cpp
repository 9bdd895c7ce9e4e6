#include "scenes/generator/prints.h"

#include "framework/math/rng.h"
#include "scenes/generator/noise.h"

#include <algorithm>
#include <cmath>

namespace luch::assets {
namespace {

double fraction(double t) {
    return t - std::floor(t);
}

bool within(double t, double from, double to) {
    return t >= from && t < to;
}

/// A line of words: letters are strokes of chance width and height, words end at chance places.
/// `along` in letters, `up` 0..1 from the line's foot.
bool letter(Key key, double along, double up) {
    const double which = std::floor(along), inside = along - which;
    const Key own = key.branch(static_cast<std::uint64_t>(which));
    if (own.uniform(0) < 0.17) return false;  // between words
    const double top = own.uniform(1) < 0.25 ? 0.95 : 0.62;
    const double foot = own.uniform(2) < 0.12 ? -0.02 : 0.1;
    if (!within(up, foot, top)) return false;
    const bool stem = within(inside, 0.12, 0.34) || (own.uniform(3) < 0.6 && inside > 0.62);
    const bool bar = own.uniform(4) < 0.7 && (within(up, 0.48, 0.62) || within(up, 0.1, 0.22));
    return inside < 0.84 && (stem || bar);
}

bool text(double x, double y, double left, double right, double top, double bottom, int lines,
          Key key) {
    if (!within(x, left, right) || !within(y, top, bottom)) return false;
    const double row = (y - top) / (bottom - top) * lines, line = std::floor(row);
    // The last line of a paragraph is short.
    if (line == lines - 1 && x > left + 0.55 * (right - left)) return false;
    const double up = (1 - (row - line)) * 1.75 - 0.5;
    return letter(key.branch(static_cast<std::uint64_t>(line)), (x - left) / 0.0205, up);
}

/// In the page's own coordinates, (0, 0) at the top left, as wide as 1.
bool frame(double x, double y, double height) {
    const double in = std::min(std::min(x, 1 - x), std::min(y, height - y));
    return within(in, 0.060, 0.066) || within(in, 0.074, 0.077);
}

bool star_page(double x, double y, double height) {
    if (frame(x, y, height)) return true;
    const double dx = x - 0.5, dy = y - 0.52, r = std::hypot(dx, dy);
    constexpr int rays = 36;
    if (within(r, 0.012, 0.32)) return fraction(std::atan2(dy, dx) / (2 * M_PI) * rays) < 0.5;
    if (within(r, 0.335, 0.342) || within(r, 0.352, 0.355)) return true;
    return text(x, y, 0.16, 0.84, 1.0, 1.24, 5, Key(3));
}

bool text_page(double x, double y, double height) {
    if (frame(x, y, height)) return true;
    // An initial: an O with leaves of a star in it.
    if (within(x, 0.13, 0.3) && within(y, 0.14, 0.31)) {
        const double r = std::hypot(x - 0.215, y - 0.225);
        return r > 0.072 || r < 0.045 * std::abs(std::cos(2 * std::atan2(y - 0.225, x - 0.215)));
    }
    if (text(x, y, 0.33, 0.87, 0.14, 0.318, 4, Key(1))) return true;
    if (text(x, y, 0.13, 0.87, 0.34, 0.88, 12, Key(2))) return true;
    // Out of focus, a point is a disc: the farther away, the larger.
    for (int i = 0; i < 7; ++i) {
        const double size = 0.004 + 0.012 * std::abs(i - 3);
        const double r = std::hypot(x - (0.19 + 0.1033 * i), y - 1.02);
        if (i == 3 ? r < size : within(r, size - 0.004, size)) return true;
    }
    const bool rule = within(y, 0.944, 0.948) || within(y, 1.092, 1.096);
    return (rule && within(x, 0.14, 0.86)) || text(x, y, 0.2, 0.8, 1.13, 1.25, 3, Key(4));
}

}  // namespace

IndexedImage printed_pages(Size size) {
    constexpr Byte3 stops[] = {{44, 30, 24}, {104, 84, 66}, {196, 178, 146}, {240, 229, 203}};
    constexpr double height = 1.4;
    constexpr int finer = 3;
    return painted(size, stops, [&](double x, double y) {
        double ink = 0;
        for (int i = 0; i < finer * finer; ++i) {
            const double px = x + ((i % finer + 0.5) / finer - 0.5) / size.width;
            const double py = (y + ((i / finer + 0.5) / finer - 0.5) / size.height) * height;
            const bool black =
                px < 0.5 ? star_page(2 * px, py, height) : text_page(2 * px - 1, py, height);
            ink += black ? 1.0 / (finer * finer) : 0;
        }
        const double paper = 0.93 + 0.09 * (Noise(21).fractal(x, y, 6, 4, 4) - 0.5);
        const double gutter = std::min(1.0, 0.72 + 9 * std::abs(x - 0.5));
        return paper * gutter * (1 - 0.93 * ink);
    });
}

IndexedImage coffer(Size size) {
    constexpr Byte3 stops[] = {{70, 58, 48}, {156, 136, 112}, {206, 188, 160}, {234, 220, 196}};
    return painted(size, stops, [](double x, double y) {
        const double dx = x - 0.5, dy = y - 0.5;
        const double out = std::max(std::abs(dx), std::abs(dy));
        const double grain = 0.1 * (Noise(31).fractal(x, y, 6, 6, 3) - 0.5);
        double shade = 0.84;
        for (const double step : {0.40, 0.31, 0.22}) {
            if (out >= step) break;
            shade -= 0.13;
            // The step's riser: lit where it looks down, dark where it looks up.
            if (out > step - 0.05 && std::abs(dy) >= std::abs(dx)) shade += dy > 0 ? 0.3 : -0.24;
        }
        if (std::hypot(dx, dy) < 0.08) shade = 0.95;
        return shade + grain;
    });
}

IndexedImage panel(Size size) {
    constexpr Byte3 stops[] = {
        {74, 20, 14}, {140, 46, 30}, {170, 74, 44}, {206, 160, 92}, {240, 222, 178}};
    return painted(size, stops, [](double x, double y) {
        const double in = std::min(std::min(x, 1 - x), std::min(y, 1 - y) * 1.27);
        const double cloud = 0.12 * (Noise(33).fractal(x, y, 4, 4, 4) - 0.5);
        if (in < 0.10) return 0.86 + cloud;
        if (in < 0.13) return 0.62 + cloud;
        if (in < 0.15) return 0.10 + cloud;
        if (within(in, 0.19, 0.203)) return 0.72;
        const double r = std::hypot((x - 0.5), (y - 0.45) * 1.27);
        if (within(r, 0.17, 0.185)) return 0.74;
        const double petals = 0.06 + 0.07 * std::abs(std::cos(4 * std::atan2(y - 0.45, x - 0.5)));
        if (r < petals) return 0.66 + cloud;
        return 0.30 + cloud;
    });
}

IndexedImage spirals(Size size) {
    constexpr Byte3 stops[] = {
        {38, 40, 48}, {92, 52, 44}, {168, 116, 84}, {214, 200, 174}, {238, 230, 214}};
    return painted(size, stops, [](double x, double y) {
        const double cloud = 0.12 * (Noise(35).fractal(x, y, 12, 6, 4) - 0.5);
        const double r = std::max(y, 1e-3);
        if (r < 0.10) return within(fraction(x * 12), 0.15, 0.85) && r > 0.04 ? 0.5 + cloud : 0.05;
        if (r < 0.12 || within(r, 0.70, 0.715)) return 0.95 + cloud;
        const double turn = std::log(r / 0.12) * 24 / (2 * M_PI);
        if (r >= 0.715) return (fraction(x * 48) < 0.5) != (r > 0.86) ? 0.85 + cloud : 0.3 + cloud;
        const double a = fraction(x * 24 + turn), b = fraction(x * 24 - turn);
        if (std::min(std::min(a, 1 - a), std::min(b, 1 - b)) < 0.05) return 0.95 + cloud;
        return (a < 0.5) == (b < 0.5) ? 0.78 + cloud : 0.25 + cloud;
    });
}

}  // namespace luch::assets
