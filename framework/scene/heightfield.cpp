#include "framework/scene/heightfield.h"

#include <glm/geometric.hpp>

#include <cassert>
#include <numbers>

namespace luch {
namespace {

using Range = Heightfield::Range;

Range joined(const Range& a, const Range& b) {
    return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}

int halved(int cells) {
    return (cells + 1) / 2;
}

/// Every pixel is a weighted sum of its neighbours along x, and x and y change places.
Image<float> blurred_and_turned(const Image<float>& image, const std::vector<double>& weights) {
    const auto [width, height] = image.size();
    const int reach = static_cast<int>(weights.size()) - 1;
    Image<float> result({height, width});
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            double sum = 0;
            const int last = std::min(width - 1, x + reach);
            for (int i = std::max(0, x - reach); i <= last; ++i) {
                sum += weights[static_cast<std::size_t>(std::abs(i - x))] * image(i, y);
            }
            result(y, x) = static_cast<float>(sum);
        }
    }
    return result;
}

}  // namespace

Heightfield::Heightfield(Image<float> heights) : heights_(std::move(heights)) {
    assert(width() > 0 && height() > 0);
    Size size{width(), height()};
    while (size.width > 1 || size.height > 1) {
        const int below = top_level();
        const Size cells = size;
        size = {halved(size.width), halved(size.height)};
        Image<Range> level(size);
        for (int z = 0; z < size.height; ++z) {
            for (int x = 0; x < size.width; ++x) {
                const int x0 = 2 * x, x1 = std::min(x0 + 1, cells.width - 1);
                const int z0 = 2 * z, z1 = std::min(z0 + 1, cells.height - 1);
                const auto child = [&](int i, int j) {
                    return range(below, i << below, j << below);
                };
                level(x, z) = joined(joined(child(x0, z0), child(x1, z0)),
                                     joined(child(x0, z1), child(x1, z1)));
            }
        }
        levels_.push_back(std::move(level));
    }
}

Vec3d Heightfield::normal(int x, int z) const {
    x = std::max(0, std::min(x, width() - 2));
    z = std::max(0, std::min(z, height() - 2));
    const double here = at(x, z);
    return glm::normalize(Vec3d(here - at(x + 1, z), 1, here - at(x, z + 1)));
}

Heightfield::Range Heightfield::range(int level, int x, int z) const {
    if (level > 0) return levels_[static_cast<std::size_t>(level - 1)](x >> level, z >> level);
    const auto [lo, hi] = std::minmax({at(x, z), at(x + 1, z), at(x, z + 1), at(x + 1, z + 1)});
    return {lo, hi};
}

std::uint64_t Heightfield::bytes() const {
    std::uint64_t sum = heights_.pixels().size() * sizeof(float);
    for (const auto& level : levels_) sum += level.pixels().size() * sizeof(Range);
    return sum;
}

// The gaussian is a product of one along x and one along y.
Image<float> blurred(const Image<float>& heights, double sigma) {
    constexpr double widest = 128;
    const int radius = static_cast<int>(std::min(std::round(3 * sigma), widest));
    if (radius < 1) return heights;
    std::vector<double> weights(static_cast<std::size_t>(radius));
    for (int i = 0; i < radius; ++i) {
        weights[static_cast<std::size_t>(i)] =
            std::exp(-i * i / (2 * sigma * sigma)) / (std::sqrt(2 * std::numbers::pi) * sigma);
    }
    return blurred_and_turned(blurred_and_turned(heights, weights), weights);
}

}  // namespace luch
