// The lecture's steps, in its order. Potmesil and Chakravarty, "A Lens and Aperture Camera Model
// for Synthetic Image Generation", SIGGRAPH 1981; Porter and Duff, "Compositing Digital Images",
// SIGGRAPH 1984.
#include "techniques/layered/layered.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace luch::techniques::layered {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

bool is_sound(const Rgba& pixel) {
    return all_finite(pixel) && std::isfinite(pixel.a);
}

/// Circles of confusion grow with |1/z − 1/z_f|: equal steps of 1/z are equal steps of blur.
void cut(std::span<const float> depths, int k, std::span<float> cuts) {
    double nearest = 0, farthest = infinite;  // as 1/z
    for (const float z : depths) {
        if (!(z > 0)) continue;
        nearest = std::max(nearest, 1.0 / z);
        farthest = std::min(farthest, 1.0 / z);
    }
    for (int i = 1; i < k; ++i) {
        const double inverse = nearest + (farthest - nearest) * i / k;
        cuts[static_cast<std::size_t>(i - 1)] =
            farthest <= nearest ? static_cast<float>(1 / inverse) : infinite;
    }
}

/// |z − z_f|/(z·z_f) is |1/z_f − 1/z|, which has no ∞/∞ at z = ∞.
void coc(ImageView<const float> z, const Lens& lens, Tile tile, ImageView<float> px) {
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            const double diameter = 2 * std::abs(signed_radius_px(z(x, y), lens));
            px(x, y) = std::min(static_cast<float>(diameter), lens.largest_px);
        }
    }
}

void gaussian(ImageView<const Rgba> in, float sigma, Axis axis, Tile tile, ImageView<Rgba> out) {
    const int length = axis == Axis::x ? in.width() : in.height();
    const double reach = sigma > 0 ? std::ceil(3.0 * sigma) : 0;
    const int radius = static_cast<int>(std::min(reach, double(length)));
    std::vector<double> weights(static_cast<std::size_t>(radius) + 1, 1);
    for (int i = 1; i <= radius; ++i) {
        const double off = i / double(sigma);
        weights[static_cast<std::size_t>(i)] = std::exp(-0.5 * off * off);
    }
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            out(x, y) = in(x, y);
            if (radius == 0 || !is_sound(in(x, y))) continue;
            const int at = axis == Axis::x ? x : y;
            glm::dvec4 sum(0);
            double whole = 0;
            for (int i = std::max(at - radius, 0); i <= std::min(at + radius, length - 1); ++i) {
                const Rgba& there = axis == Axis::x ? in(i, y) : in(x, i);
                if (!is_sound(there)) continue;
                const double weight = weights[static_cast<std::size_t>(std::abs(i - at))];
                sum += weight * glm::dvec4(there);
                whole += weight;
            }
            out(x, y) = Rgba(sum / whole);
        }
    }
}

/// How many pixels' centres lie within a distance of a pixel's own; of discs larger than the
/// picture their area will do.
double centres_within(double radius, Size picture) {
    if (radius > picture.width + picture.height) return std::numbers::pi * radius * radius;
    double count = 0;
    const int reach = static_cast<int>(radius);
    for (int y = -reach; y <= reach; ++y) {
        count += 2 * std::floor(std::sqrt(radius * radius - double(y) * y)) + 1;
    }
    return count;
}

/// What a pixel hands to each pixel of its disc: nothing beyond the radius.
struct Spot {
    float radius_squared, share;
};

/// Pixels hand out what they have; it is reckoned by the one that receives, so that tiles do not
/// get into each other's way. Discs are looked for as far as the largest one in the picture goes.
void disc(ImageView<const Rgba> in, ImageView<const float> coc, Tile tile, ImageView<Rgba> out) {
    float largest = 0;
    for (const float* px = coc.data(); px != coc.data() + coc.size().area(); ++px) {
        largest = std::max(largest, *px);
    }
    const int reach = static_cast<int>(std::min(largest / 2, float(in.width() + in.height())));
    const int x0 = std::max(tile.x0 - reach, 0), x1 = std::min(tile.x1 + reach, in.width());
    const int y0 = std::max(tile.y0 - reach, 0), y1 = std::min(tile.y1 + reach, in.height());
    Image<Spot> spots({x1 - x0, y1 - y0});
    for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) {
            const float radius = std::max(coc(x, y) / 2, 0.5f);
            const bool sound = is_sound(in(x, y));
            spots(x - x0, y - y0) = {
                radius * radius,
                sound ? static_cast<float>(1 / centres_within(radius, in.size())) : 0};
        }
    }
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            out(x, y) = in(x, y);
            if (reach == 0 || !is_sound(in(x, y))) continue;
            glm::dvec4 sum(0);
            double whole = 0;
            for (int j = std::max(y - reach, y0); j <= std::min(y + reach, y1 - 1); ++j) {
                for (int i = std::max(x - reach, x0); i <= std::min(x + reach, x1 - 1); ++i) {
                    const Spot& spot = spots(i - x0, j - y0);
                    const auto off = static_cast<float>((i - x) * (i - x) + (j - y) * (j - y));
                    if (off > spot.radius_squared || spot.share == 0) continue;
                    sum += double(spot.share) * glm::dvec4(in(i, j));
                    whole += spot.share;
                }
            }
            out(x, y) = Rgba(sum / whole);
        }
    }
}

void over(ImageView<const Rgba> front, Tile tile, ImageView<Rgba> back) {
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            const float through = 1 - front(x, y).a;
            // Nothing comes through what covers all, were it infinite.
            back(x, y) = through > 0 ? front(x, y) + through * back(x, y) : front(x, y);
        }
    }
}

}  // namespace

Steps reference() {
    return {cut, coc, gaussian, disc, over};
}

}  // namespace luch::techniques::layered
