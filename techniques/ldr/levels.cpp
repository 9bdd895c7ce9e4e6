// Words of any number of bits a channel, worked out in double: for the sweep.
#include "framework/technique/context.h"
#include "techniques/ldr/canvas.h"

#include <algorithm>

namespace luch::techniques::ldr {
namespace {

double srgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double linear_of(double srgb) {
    return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

Vec3d lerped(const Vec3d& a, const Vec3d& b, const Vec3d& t) {
    return a * (1.0 - t) + b * t;
}

}  // namespace

Vec3d LevelCanvas::rounded(const Vec3d& colour) const {
    return glm::floor(colour * most_ + 0.5) / most_;
}

Vec3d LevelCanvas::saturated(const Vec3d& colour) const {
    return look_.gathers ? colour : glm::min(colour, Vec3d(1));
}

Vec3d LevelCanvas::rounded_on_screen(const Rgb& colour) const {
    Vec3d result;
    for (int c = 0; c < 3; ++c) {
        result[c] = linear_of(std::floor(srgb(colour[c]) * most_ + 0.5) / most_);
    }
    return result;
}

/// A plane of light: rounded to the levels, or as a wide sum has it.
Vec3d LevelCanvas::plane(const Rgb& light) {
    Vec3d colour = Vec3d(light) * double{look_.exposure};
    for (int c = 0; c < 3; ++c) {
        misfits_.not_a_number += std::isnan(colour[c]) ? 1 : 0;
        misfits_.too_bright += colour[c] > 1 ? 1 : 0;
        colour[c] = colour[c] > 0 ? std::min(colour[c], 4112.0) : 0.0;
    }
    return look_.gathers ? colour : rounded(glm::min(colour, Vec3d(1)));
}

Vec3d LevelCanvas::composed(const DeferredPixels& pixels, std::size_t point) {
    using Kind = ShadedParts::Kind;
    const ShadedParts& parts = pixels.parts;
    const Kind kind = parts.kinds()[point];
    if (kind == Kind::other || (kind == Kind::layered && look_.gathers)) {
        return plane(pixels.light[point]);
    }
    Vec3d sum(0);
    if (kind == Kind::layered) {
        for (const auto& layer : parts.layers()) {
            sum = rounded(lerped(sum, plane(layer.light[point]), Vec3d(layer.blend[point])));
        }
        return sum;
    }
    sum = plane(look_.ambient);
    for (const auto& light : parts.lights()) {
        if (!light.diffuse.empty()) sum = saturated(sum + plane(light.diffuse[point]));
    }
    const Rgb albedo = glm::clamp(parts.albedo()[point], 0.0f, 1.0f);
    sum = look_.gathers ? sum * rounded_on_screen(albedo) : rounded(sum * rounded(Vec3d(albedo)));
    for (const auto& light : parts.lights()) {
        if (!light.highlight.empty()) sum = saturated(sum + plane(light.highlight[point]));
    }
    return sum;
}

void LevelCanvas::add(const DeferredPixels& pixels, Slots slots, int, int,
                      std::span<const std::uint8_t>) {
    for (std::size_t i = 0; i < pixels.light.size(); ++i) {
        sums_[slots[i]] += composed(pixels, i);
    }
}

void LevelCanvas::resolve(int n, std::span<const std::uint8_t> dither, std::span<Rgb> colours,
                          std::span<std::uint8_t> alpha) {
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        const Vec3d mean = glm::min(sums_[i] / static_cast<double>(n), Vec3d(1));
        for (int c = 0; c < 3; ++c) {
            const double level = std::floor(srgb(mean[c]) * most_ + dither[i] / 256.0);
            colours[i][c] = static_cast<float>(linear_of(level / most_));
        }
        alpha[i] = 255;
    }
}

double LevelCanvas::brightest(std::size_t slot, int n) const {
    return max_norm(sums_[slot]) / n;
}

void LevelCanvas::tone(std::size_t slot, int n, double white) {
    for (int c = 0; c < 3; ++c) {
        sums_[slot][c] = toned(sums_[slot][c] / n, white) * n;
    }
}

}  // namespace luch::techniques::ldr
