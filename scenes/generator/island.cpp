#include "scenes/generator/island.h"

#include "scenes/generator/noise.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace luch::assets {
namespace {

double smooth_step(double from, double to, double t) {
    const double s = std::clamp((t - from) / (to - from), 0.0, 1.0);
    return s * s * (3 - 2 * s);
}

/// 1 at a point, falling to 0 around it.
double bump_at(double x, double y, double radius) {
    const double d = (x * x + y * y) / (radius * radius);
    return d < 1 ? (1 - d) * (1 - d) : 0;
}

/// Sharp crests where the noise crosses its mean.
double ridges(double x, double y) {
    double sum = 0, weight = 0.5;
    for (int octave = 0; octave < 5; ++octave) {
        const int cells = 3 << octave;
        const double crest = 1 - std::abs(2 * Noise(81 + octave).at(x, y, cells, cells) - 1);
        sum += weight * crest * crest;
        weight /= 2;
    }
    return sum;
}

double height_at(double x, double y) {
    const double bend = Noise(71).fractal(x, y, 3, 3, 5) - 0.5;
    const double dx = x - 0.5, dy = 1.15 * (y - 0.52);
    const double shore = std::sqrt(dx * dx + dy * dy) + 0.34 * bend;
    const double land = smooth_step(0.52, 0.10, shore);
    const double rise = smooth_step(0.38, 0.04, shore);
    double height = 0.44 * land + 0.53 * rise * rise * ridges(x, y);
    height += 0.14 * rise * (Noise(72).fractal(x, y, 12, 12, 4) - 0.5);
    height -= 0.25 * bump_at(x - 0.44, y - 0.27, 0.15);  // the bay
    for (const auto& [rx, ry, size] : {std::array{0.66, 0.10, 0.030}, std::array{0.70, 0.13, 0.020},
                                       std::array{0.22, 0.12, 0.026}}) {
        height += 0.36 * bump_at(x - rx, y - ry, size);
    }
    return height;
}

}  // namespace

IndexedImage island_heights(Size size) {
    constexpr Byte3 stops[] = {{0, 0, 0}, {255, 255, 255}};
    return painted(size, stops, height_at);
}

IndexedImage island_colours(Size size) {
    constexpr Byte3 stops[] = {{110, 140, 170}, {226, 212, 164}, {232, 214, 162}, {140, 158, 70},
                               {86, 124, 50},   {58, 96, 44},    {74, 92, 56},    {124, 112, 98},
                               {150, 140, 130}, {236, 238, 242}};
    constexpr double rock = 7.2 / 9;
    return painted(size, stops, [&](double x, double y) {
        const double step = 1.0 / size.width;
        const double here = height_at(x, y);
        const double to_right = height_at(x + step, y) - here, down = height_at(x, y + step) - here;
        const double slope = std::sqrt(to_right * to_right + down * down);
        const double patches = Noise(91).fractal(x, y, 16, 16, 4) - 0.5;
        const double above = here - island_sea_level + 0.05 * patches * smooth_step(0.2, 0.3, here);
        // Sand up to a little above the sea, then green up to the tree line, rock, snow.
        const double sand = 2.0 / 9 * smooth_step(-0.15, 0.0, above);
        const double green =
            3.0 / 9 * smooth_step(0.02, 0.07, above) + 1.2 / 9 * smooth_step(0.10, 0.30, above);
        const double bare =
            1.4 / 9 * smooth_step(0.34, 0.48, above) + 1.4 / 9 * smooth_step(0.56, 0.66, above);
        const double steep = smooth_step(0.014, 0.026, slope) * smooth_step(0.06, 0.12, above);
        const double ground = sand + green + bare + 0.3 / 9 * patches;
        return ground + steep * (rock - ground) * (ground < rock ? 0.8 : 0.4);
    });
}

}  // namespace luch::assets
