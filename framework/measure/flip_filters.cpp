#include "framework/measure/flip_filters.h"

#include "framework/measure/flip_colour.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace luch::flip {
namespace {

// Contrast sensitivity as Gaussians a·√(π/b)·exp(−π²x²/b), x in degrees: Andersson et al. 2020,
// table 1. Blue-yellow needs two.
struct Gaussian {
    double a, b;
};
constexpr Gaussian of_achromatic{1, 0.0047}, of_red_green{1, 0.0053};
constexpr Gaussian of_blue_yellow{34.1, 0.04}, of_blue_yellow_narrow{13.5, 0.025};
constexpr double feature_width_deg = 0.082;  // from the trough to the peak of an edge's response

Kernels::Weights scaled(const std::vector<double>& weights, double factor) {
    Kernels::Weights result;
    for (const double weight : weights) result.push_back(static_cast<float>(weight * factor));
    return result;
}

double sum_of(const std::vector<double>& weights) {
    return std::accumulate(weights.begin(), weights.end(), 0.0);
}

/// √(a·√(π/b))·exp(−π²x²/b): squared, that is taken along x and y, the Gaussian of the table.
std::vector<double> half_of(const Gaussian& g, int radius, double pixels_per_degree) {
    constexpr double pi = std::numbers::pi;
    std::vector<double> weights;
    for (int i = -radius; i <= radius; ++i) {
        const double x = i / pixels_per_degree;
        weights.push_back(std::sqrt(g.a * std::sqrt(pi / g.b)) * std::exp(-pi * pi * x * x / g.b));
    }
    return weights;
}

Kernels::Weights normalised(const std::vector<double>& weights) {
    return scaled(weights, 1 / sum_of(weights));
}

/// The positive weights sum to 1 and the negative ones to −1, so that an edge between black and
/// white gives 1.
Kernels::Weights balanced(const std::vector<double>& weights) {
    double above = 0, below = 0;
    for (const double weight : weights) (weight > 0 ? above : below) += std::abs(weight);
    Kernels::Weights result;
    for (const double w : weights)
        result.push_back(static_cast<float>(w / (w > 0 ? above : below)));
    return result;
}

/// The row of an image with `margin` more pixels at either end, a plane for each component.
std::array<std::vector<float>, 3> opponent_row(ImageView<const Rgb> linear, int y, int margin) {
    const int width = linear.width();
    std::array<std::vector<float>, 3> planes;
    for (auto& plane : planes) plane.resize(static_cast<std::size_t>(width + 2 * margin));
    for (int x = 0; x < width; ++x) {
        const Vec3 colour = opponent(linear(x, y));
        for (int c = 0; c < 3; ++c) planes[c][static_cast<std::size_t>(x + margin)] = colour[c];
    }
    for (auto& plane : planes) {
        std::fill_n(plane.begin(), margin, plane[static_cast<std::size_t>(margin)]);
        std::fill_n(plane.end() - margin, margin, *(plane.end() - margin - 1));
    }
    return planes;
}

/// Adds Σ weights[k] · row_of(k)[x] to sum[x]. Four rows at a time: the sum is read and written a
/// quarter as often.
template <class RowOf>
void add_weighted(std::vector<float>& sum, const Kernels::Weights& weights, RowOf row_of) {
    std::size_t k = 0;
    for (; k + 4 <= weights.size(); k += 4) {
        const float a = weights[k], b = weights[k + 1], c = weights[k + 2], d = weights[k + 3];
        const float *p = row_of(k), *q = row_of(k + 1), *r = row_of(k + 2), *s = row_of(k + 3);
        for (std::size_t x = 0; x < sum.size(); ++x) {
            sum[x] = sum[x] + a * p[x] + b * q[x] + c * r[x] + d * s[x];
        }
    }
    for (; k < weights.size(); ++k) {
        const float* from = row_of(k);
        for (std::size_t x = 0; x < sum.size(); ++x) sum[x] += weights[k] * from[x];
    }
}

/// `padded` has a margin of `margin` pixels at either end.
std::vector<float> filtered(const std::vector<float>& padded, int margin,
                            const Kernels::Weights& weights) {
    const float* begin = padded.data() + margin - weights.size() / 2;
    std::vector<float> sums(padded.size() - 2 * static_cast<std::size_t>(margin));
    add_weighted(sums, weights, [&](std::size_t k) { return begin + k; });
    return sums;
}

}  // namespace

Kernels::Kernels(double pixels_per_degree) {
    constexpr double pi = std::numbers::pi;
    // Three standard deviations of the widest Gaussian.
    contrast_radius = static_cast<int>(
        std::ceil(3 * std::sqrt(of_blue_yellow.b / (2 * pi * pi)) * pixels_per_degree));
    const auto half = [&](const Gaussian& g) {
        return half_of(g, contrast_radius, pixels_per_degree);
    };
    achromatic = normalised(half(of_achromatic));
    red_green = normalised(half(of_red_green));
    const std::vector<double> wide = half(of_blue_yellow), narrow = half(of_blue_yellow_narrow);
    // Their sum over the plane is the sum of squares of the sums along a line.
    const double scale = 1 / std::hypot(sum_of(wide), sum_of(narrow));
    blue_yellow = scaled(wide, scale);
    blue_yellow_narrow = scaled(narrow, scale);

    const double deviation = 0.5 * feature_width_deg * pixels_per_degree;
    feature_radius = static_cast<int>(std::ceil(3 * deviation));
    std::vector<double> gaussian, first, second;
    for (int i = -feature_radius; i <= feature_radius; ++i) {
        const double x = i / deviation;
        gaussian.push_back(std::exp(-x * x / 2));
        first.push_back(-x * gaussian.back());
        second.push_back((x * x - 1) * gaussian.back());
    }
    smooth = normalised(gaussian);
    edge = balanced(first);
    point = balanced(second);
}

Band::Band(const Kernels& kernels, ImageView<const Rgb> linear, int y0, int y1)
    : kernels_(&kernels), first_(y0 - kernels.radius()), width_(linear.width()) {
    for (int y = first_; y < y1 + kernels.radius(); ++y) {
        if (y > 0 && y >= linear.height()) {
            rows_.push_back(rows_.back());
        } else if (y <= 0 && !rows_.empty()) {
            rows_.push_back(rows_.back());
        } else {
            rows_.push_back(filtered_along(linear, std::max(y, 0)));
        }
    }
}

std::array<Band::Row, Band::planes> Band::filtered_along(ImageView<const Rgb> linear, int y) const {
    const Kernels& k = *kernels_;
    const int margin = k.radius();
    auto [luminance, cx, cz] = opponent_row(linear, y, margin);
    std::array<Row, planes> row;
    row[achromatic] = filtered(luminance, margin, k.achromatic);
    row[red_green] = filtered(cx, margin, k.red_green);
    row[blue_yellow] = filtered(cz, margin, k.blue_yellow);
    row[blue_yellow_narrow] = filtered(cz, margin, k.blue_yellow_narrow);
    // Edges and points are those of the luminance in 0..1.
    for (float& value : luminance) value = (value + 16) / 116;
    row[smooth] = filtered(luminance, margin, k.smooth);
    row[edge] = filtered(luminance, margin, k.edge);
    row[point] = filtered(luminance, margin, k.point);
    return row;
}

void Band::add_across(Row& sum, Plane plane, const Kernels::Weights& weights, int y) const {
    const int top = y - static_cast<int>(weights.size() / 2) - first_;
    add_weighted(sum, weights, [&](std::size_t k) {
        return rows_[static_cast<std::size_t>(top) + k][plane].data();
    });
}

/// The length of the gradient: a derivative along x and smooth across, and the reverse.
Band::Row Band::magnitude(Plane derivative, const Kernels::Weights& across, int y) const {
    Row along_x(static_cast<std::size_t>(width_)), along_y(along_x.size());
    add_across(along_x, derivative, kernels_->smooth, y);
    add_across(along_y, smooth, across, y);
    for (std::size_t x = 0; x < along_x.size(); ++x) {
        along_x[x] = std::sqrt(along_x[x] * along_x[x] + along_y[x] * along_y[x]);
    }
    return along_x;
}

FilteredRow Band::row(int y) const {
    const Kernels& k = *kernels_;
    const auto width = static_cast<std::size_t>(width_);
    Row luminance(width), cx(width), cz(width);
    add_across(luminance, achromatic, k.achromatic, y);
    add_across(cx, red_green, k.red_green, y);
    add_across(cz, blue_yellow, k.blue_yellow, y);
    add_across(cz, blue_yellow_narrow, k.blue_yellow_narrow, y);
    FilteredRow result{std::vector<Rgb>(width), magnitude(edge, k.edge, y),
                       magnitude(point, k.point, y)};
    for (std::size_t x = 0; x < width; ++x) {
        const Rgb linear = linear_of({luminance[x], cx[x], cz[x]});
        result.colour[x] = glm::clamp(linear, Rgb(0), Rgb(1));
    }
    return result;
}

}  // namespace luch::flip
