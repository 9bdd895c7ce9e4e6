#include "framework/technique/context.h"
#include "techniques/ldr/canvas.h"

namespace luch::techniques::ldr {
namespace {

/// Layers' blends are grey in a word: lerp() has one weight for all channels.
std::uint8_t grey(const Rgb& blend) {
    return byte_of((blend.r + blend.g + blend.b) / 3);
}

bool is_grey(const Rgb& blend) {
    return blend.r == blend.g && blend.g == blend.b;
}

}  // namespace

std::span<const Word> WordSample::encoded(std::span<const Rgb> light, float exposure) {
    other_.resize(light.size());
    call_step(*look_.context, look_.steps->encode, look_.reference->encode, light, exposure,
              std::span(other_), misfits_);
    return other_;
}

void WordSample::add(std::span<const Rgb> light) {
    if (light.empty()) return;
    call_step(*look_.context, look_.steps->add, look_.reference->add, std::span(words_),
              encoded(light, look_.exposure));
}

/// What is no lit point's goes to `rest_` where something was hit, else to `sky_`. Layers that have
/// a colour of their own stay as the baseline has blended them.
void WordSample::split(const DeferredPixels& pixels) {
    using Kind = ShadedParts::Kind;
    const std::size_t n = pixels.light.size();
    rest_.assign(n, Rgb(0));
    sky_.assign(n, Rgb(0));
    alpha_.assign(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
        alpha_[i] = pixels.hits[i] ? 255 : 0;
        if (pixels.parts.kinds()[i] != Kind::other) continue;
        (pixels.hits[i] ? rest_ : sky_)[i] = pixels.light[i];
    }
    for (const ShadedParts::Layer& layer : pixels.parts.layers()) {
        for (std::size_t i = 0; i < n; ++i) {
            if (!is_grey(layer.blend[i])) rest_[i] = pixels.light[i];
        }
    }
}

void WordSample::add_layers(const DeferredPixels& pixels) {
    const std::size_t n = pixels.light.size();
    std::vector<std::uint8_t> blend(n);
    for (const ShadedParts::Layer& layer : pixels.parts.layers()) {
        for (std::size_t i = 0; i < n; ++i) {
            // Whatever colour it has, the whole is in rest_.
            const bool kept = rest_[i] == Rgb(0);
            blend[i] = kept ? grey(layer.blend[i]) : 0;
        }
        call_step(*look_.context, look_.steps->lerp, look_.reference->lerp, std::span(words_),
                  encoded(layer.light, look_.exposure), std::span<const std::uint8_t>(blend));
    }
}

void WordSample::over_sky(const DeferredPixels& pixels) {
    if (pixels.light.empty()) return;
    encoded(sky_, look_.exposure);
    for (Word& word : other_) word.bits &= 0x00ffffffu;
    std::swap(words_, other_);
    call_step(*look_.context, look_.steps->lerp, look_.reference->lerp, std::span(words_),
              std::span<const Word>(other_), std::span<const std::uint8_t>(alpha_));
}

void WordSample::compose(const DeferredPixels& pixels) {
    const std::size_t n = pixels.light.size();
    split(pixels);
    words_.assign(n, Word(0));
    ambient_.assign(n, look_.ambient);
    add(ambient_);
    for (const auto& light : pixels.parts.lights()) add(light.diffuse);
    call_step(*look_.context, look_.steps->modulate, look_.reference->modulate, std::span(words_),
              encoded(pixels.parts.albedo(), 1));
    for (const auto& light : pixels.parts.lights()) add(light.highlight);
    add(rest_);
    add_layers(pixels);
    over_sky(pixels);
}

}  // namespace luch::techniques::ldr
