#include "framework/math/colour.h"

namespace luch {

float srgb_encoded(float linear) {
    if (!(linear > 0)) return 0;
    if (linear >= 1) return 1;
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

float srgb_decoded(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

Rgb srgb_encoded(const Rgb& linear) {
    return {srgb_encoded(linear.r), srgb_encoded(linear.g), srgb_encoded(linear.b)};
}

Rgb srgb_decoded(const Rgb& encoded) {
    return {srgb_decoded(encoded.r), srgb_decoded(encoded.g), srgb_decoded(encoded.b)};
}

}  // namespace luch
