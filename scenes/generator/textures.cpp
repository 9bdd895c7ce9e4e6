#include "scenes/generator/textures.h"

#include "framework/math/rng.h"
#include "scenes/generator/noise.h"

#include <algorithm>
#include <cmath>

namespace luch::assets {
namespace {

/// How far t lies from the nearest whole number, 0..½.
double from_whole(double t) {
    return std::abs(t - std::floor(t + 0.5));
}

/// 0 at or below `from`, 1 at or above `to`, smooth between.
double step_up(double from, double to, double t) {
    const double s = std::clamp((t - from) / (to - from), 0.0, 1.0);
    return s * s * (3 - 2 * s);
}

}  // namespace

IndexedImage boards(Size size) {
    constexpr int count = 4;
    constexpr Byte3 stops[] = {
        {38, 22, 12}, {96, 58, 31}, {142, 92, 52}, {181, 129, 80}, {205, 160, 110}};
    return painted(size, stops, [](double x, double y) {
        const int board = static_cast<int>(y * count);
        const Key key = Key(17).branch(board);
        const Noise noise(key.bits(0));
        const double joint = key.uniform(1);
        const double tone = 0.16 * (key.uniform(2) - 0.5);
        // Year rings: a triangle wave across the board, bent by slow noise along it.
        const double bend = noise.fractal(x, y, 2, 8, 3);
        const double rings = from_whole(y * count * 2.5 + 3.5 * bend);
        const double fibres = noise.fractal(x, y, 4, 96, 2) - 0.5;
        const double gap = std::min(step_up(0.012, 0.03, from_whole(y * count)),
                                    step_up(0.0015, 0.005, from_whole(x - joint)));
        return (0.56 + tone + 0.3 * rings + 0.34 * fibres) * (0.25 + 0.75 * gap);
    });
}

IndexedImage marble(Size size) {
    constexpr Byte3 stops[] = {{120, 122, 130}, {186, 186, 190}, {222, 220, 216}, {240, 237, 230}};
    return painted(size, stops, [](double x, double y) {
        const Noise noise(5);
        const double warp = noise.fractal(x, y, 3, 3, 4) - 0.5;
        const double cloud = Noise(6).fractal(x, y, 2, 2, 5);
        // A vein runs where the warped noise crosses its mean.
        const double vein = std::abs(2 * Noise(7).fractal(x + warp, y - warp, 2, 2, 4) - 1);
        const double fine = std::abs(2 * Noise(8).fractal(x - warp, y + warp, 5, 5, 3) - 1);
        return (0.55 + 0.55 * cloud) * (0.45 + 0.55 * step_up(0, 0.09, vein)) *
               (0.8 + 0.2 * step_up(0, 0.06, fine));
    });
}

IndexedImage plaster(Size size) {
    constexpr Byte3 stops[] = {{0, 0, 0}, {255, 255, 255}};
    return painted(size, stops, [](double x, double y) {
        const double coarse = Noise(11).fractal(x, y, 6, 6, 4);
        const double trowel = std::abs(2 * Noise(12).fractal(x, y, 5, 9, 2) - 1);
        return 0.65 * coarse + 0.35 * trowel;
    });
}

IndexedImage hammered(Size size) {
    constexpr int cells = 8;
    constexpr Byte3 stops[] = {{0, 0, 0}, {255, 255, 255}};
    return painted(size, stops, [](double x, double y) {
        // The squared distance to the nearest dent: each cell of a lattice has one.
        const int column = static_cast<int>(x * cells), row = static_cast<int>(y * cells);
        double nearest = 2;
        for (int j = row - 1; j <= row + 1; ++j) {
            for (int i = column - 1; i <= column + 1; ++i) {
                const Key key = Key(13).branch((i + cells) % cells).branch((j + cells) % cells);
                const double dx = x * cells - i - key.uniform(0);
                const double dy = y * cells - j - key.uniform(1);
                nearest = std::min(nearest, dx * dx + dy * dy);
            }
        }
        return nearest;
    });
}

IndexedImage landscape(Size size) {
    // The ramp's first half is for the hills, dark to hazy, the second for the sky, glow to blue.
    constexpr Byte3 stops[] = {{24, 40, 44},    {46, 78, 72},    {104, 126, 116}, {178, 160, 138},
                               {250, 236, 190}, {244, 190, 130}, {206, 160, 150}, {112, 140, 176}};
    return painted(size, stops, [](double x, double y) {
        double shade = 0.62 + 0.55 * (0.62 - y);
        const double to_sun = (x - 0.66) * (x - 0.66) * 2.2 + (y - 0.36) * (y - 0.36);
        shade = to_sun < 0.004 ? 4.0 / 7 : shade - 0.03 * step_up(0.1, 0.004, to_sun);
        for (int hill = 0; hill < 4; ++hill) {
            const double ridge = Noise(40 + hill).fractal(x, 0.5, 3 - hill / 2, 1, 4);
            const double top = 0.42 + 0.13 * hill + (0.30 - 0.05 * hill) * (0.5 - ridge);
            if (y > top) shade = 0.40 - 0.12 * hill + 0.10 * (y - top);
        }
        return shade;
    });
}

}  // namespace luch::assets
