#include "scenes/generator/noise.h"

#include "framework/math/rng.h"

#include <cmath>

namespace luch::assets {
namespace {

double smooth(double t) {
    return t * t * t * (t * (t * 6 - 15) + 10);
}

double mixed(double a, double b, double t) {
    return a + (b - a) * t;
}

}  // namespace

double Noise::at(double x, double y, int columns, int rows) const {
    const double u = x * columns, v = y * rows;
    const double column = std::floor(u), row = std::floor(v);
    const double s = smooth(u - column), t = smooth(v - row);
    const Key key = Key(seed_).branch(columns).branch(rows);
    const auto value = [&](int i, int j) {
        const int wrapped_i = ((static_cast<int>(column) + i) % columns + columns) % columns;
        const int wrapped_j = ((static_cast<int>(row) + j) % rows + rows) % rows;
        return key.branch(wrapped_i).uniform(wrapped_j);
    };
    return mixed(mixed(value(0, 0), value(1, 0), s), mixed(value(0, 1), value(1, 1), s), t);
}

double Noise::fractal(double x, double y, int columns, int rows, int octaves) const {
    double sum = 0, weight = 1, total = 0;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += weight * at(x, y, columns << octave, rows << octave);
        total += weight;
        weight /= 2;
    }
    return sum / total;
}

}  // namespace luch::assets
