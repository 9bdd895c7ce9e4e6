#include "framework/measure/ssim.h"

#include "framework/measure/paired.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace luch {
namespace {

constexpr int radius = 5;
constexpr int window = 2 * radius + 1;
constexpr double deviation = 1.5;
constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;

/// A row of the moments of two signals: means, mean squares, mean product.
enum { mean_r, mean_v, square_r, square_v, product, moments };
using Row = std::array<std::vector<double>, moments>;

std::array<double, window> gaussian() {
    std::array<double, window> weights{};
    double sum = 0;
    for (int i = 0; i < window; ++i) {
        const double x = (i - radius) / deviation;
        sum += weights[static_cast<std::size_t>(i)] = std::exp(-x * x / 2);
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

/// The position inside 0..n−1 that a mirror at either border shows: … 1 0 | 0 1 … n−1 | n−1 …
int mirrored(int i, int n) {
    const int period = ((i % (2 * n)) + 2 * n) % (2 * n);
    return period < n ? period : 2 * n - 1 - period;
}

/// The moments at one row of one channel, before any filter, with `radius` more at either end.
Row plain_row(const FinitePair& pair, int channel, int y) {
    const int width = pair.image.width();
    Row row;
    for (auto& signal : row) signal.reserve(static_cast<std::size_t>(width + 2 * radius));
    for (int x = -radius; x < width + radius; ++x) {
        const int at = mirrored(x, width);
        const auto r = static_cast<double>(pair.reference(at, y)[channel]);
        const auto v = static_cast<double>(pair.image(at, y)[channel]);
        row[mean_r].push_back(r);
        row[mean_v].push_back(v);
        row[square_r].push_back(r * r);
        row[square_v].push_back(v * v);
        row[product].push_back(r * v);
    }
    return row;
}

/// Adds weight · from, shifted to the left.
void add(Row& sums, double weight, const Row& from, std::size_t shift) {
    for (std::size_t k = 0; k < sums.size(); ++k) {
        const double* values = from[k].data() + shift;
        for (std::size_t x = 0; x < sums[k].size(); ++x) sums[k][x] += weight * values[x];
    }
}

Row zeros(int width) {
    Row row;
    row.fill(std::vector<double>(static_cast<std::size_t>(width)));
    return row;
}

double similarity(const Row& m, std::size_t x) {
    const double r = m[mean_r][x], v = m[mean_v][x];
    const double spread = m[square_r][x] - r * r + m[square_v][x] - v * v;
    const double together = m[product][x] - r * v;
    return (2 * r * v + c1) * (2 * together + c2) / ((r * r + v * v + c1) * (spread + c2));
}

/// Adds a third of a channel's similarity to the rows y0 ≤ y < y1 of the map.
void add_channel(const FinitePair& pair, int channel, int y0, int y1, Image<float>& map) {
    static const std::array<double, window> weights = gaussian();
    const int width = map.width(), height = map.height();
    std::vector<Row> rows;
    for (int y = y0 - radius; y < y1 + radius; ++y) {
        const Row plain = plain_row(pair, channel, mirrored(y, height));
        rows.push_back(zeros(width));
        for (std::size_t i = 0; i < window; ++i) add(rows.back(), weights[i], plain, i);
    }
    for (int y = y0; y < y1; ++y) {
        Row sums = zeros(width);
        for (std::size_t i = 0; i < window; ++i) {
            add(sums, weights[i], rows[static_cast<std::size_t>(y - y0) + i], 0);
        }
        for (int x = 0; x < width; ++x) {
            map(x, y) += static_cast<float>(similarity(sums, static_cast<std::size_t>(x)) / 3);
        }
    }
}

/// The pixels of a side of length n that count, first and last + 1.
std::array<int, 2> counted(int n) {
    return n < window ? std::array{0, n} : std::array{radius, n - radius};
}

}  // namespace

SsimResult ssim(ImageView<const Rgb> reference, ImageView<const Rgb> image,
                const Workers& workers) {
    const FinitePair pair = finite_pair(reference, image);
    SsimResult result;
    result.map = Image<float>(image.size());
    constexpr int band = 64;
    workers.for_each((image.height() + band - 1) / band, [&](int i, int) {
        const int y0 = i * band, y1 = std::min(y0 + band, image.height());
        for (int channel = 0; channel < 3; ++channel)
            add_channel(pair, channel, y0, y1, result.map);
    });
    mean_of_kept(pair, result.map);
    const auto columns = counted(image.width()), rows = counted(image.height());
    double sum = 0;
    std::size_t count = 0;
    for (int y = rows[0]; y < rows[1]; ++y) {
        for (int x = columns[0]; x < columns[1]; ++x) {
            if (pair.kept(x, y) == 0) continue;
            sum += static_cast<double>(result.map(x, y));
            ++count;
        }
    }
    result.mean =
        count == 0 ? std::numeric_limits<double>::quiet_NaN() : sum / static_cast<double>(count);
    return result;
}

}  // namespace luch
