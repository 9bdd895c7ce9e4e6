#include "techniques/ldr/canvas.h"

#include "framework/technique/context.h"
#include "techniques/ldr/swar.h"

#include <algorithm>

namespace luch::techniques::ldr {
namespace {

/// Words where they belong in a tile, black elsewhere.
void scatter(std::span<const Word> words, Slots slots, std::vector<Word>& to, std::size_t size) {
    to.assign(size, Word(0));
    for (std::size_t i = 0; i < words.size(); ++i) to[slots[i]] = words[i];
}

void see(std::span<const Word> displayed, std::span<Rgb> colours, std::span<std::uint8_t> alpha) {
    for (std::size_t i = 0; i < displayed.size(); ++i) {
        colours[i] = seen(displayed[i]);
        alpha[i] = static_cast<std::uint8_t>(displayed[i].alpha());
    }
}

}  // namespace

void WordCanvas::add(const DeferredPixels& pixels, Slots slots, int sample, int n,
                     std::span<const std::uint8_t> up) {
    sample_.compose(pixels);
    scatter(sample_.words(), slots, scattered_, sums_.size());
    if (n == 2 && sample == 1) {
        call_step(*look_.context, look_.steps->mix, look_.reference->mix, std::span(sums_),
                  std::span<const Word>(scattered_), up);
        return;
    }
    if (n > 2) {
        const auto share = static_cast<std::uint32_t>(std::lround(255.0 / n));
        for (Word& word : scattered_) word = scaled(word, share);
    }
    call_step(*look_.context, look_.steps->add, look_.reference->add, std::span(sums_),
              std::span<const Word>(scattered_));
}

void WordCanvas::share(int n) {
    const auto part = static_cast<std::uint32_t>(std::lround(255.0 / n));
    for (Word& word : sums_) word = scaled(word, part);
}

void WordCanvas::resolve(int, std::span<const std::uint8_t> dither, std::span<Rgb> colours,
                         std::span<std::uint8_t> alpha) {
    scattered_.resize(sums_.size());
    for (std::size_t i = 0; i < sums_.size(); ++i) scattered_[i] = shown(sums_[i], dither[i]);
    see(scattered_, colours, alpha);
}

void WideCanvas::gather(std::span<const Rgb> light) {
    if (light.empty()) return;
    call_step(*look_.context, look_.steps->gather, look_.reference->gather, light, look_.exposure,
              std::span(gathered_), misfits_);
}

/// Albedo goes the way of light to become words of the screen.
void WideCanvas::tint(std::span<const Rgb> albedo) {
    albedo_.assign(albedo.size(), Wide());
    no_dither_.assign(albedo.size(), 128);
    call_step(*look_.context, look_.steps->gather, look_.reference->gather, albedo, 1.0f,
              std::span(albedo_), misfits_);
    resolve(albedo_, 1, no_dither_);
    call_step(*look_.context, look_.steps->tint, look_.reference->tint, std::span(gathered_),
              std::span<const Word>(resolved_));
}

void WideCanvas::resolve(std::span<const Wide> sums, int n, std::span<const std::uint8_t> dither) {
    resolved_.resize(sums.size());
    call_step(*look_.context, look_.steps->resolve, look_.reference->resolve, sums, n, dither,
              std::span(resolved_));
}

void WideCanvas::gather(const DeferredPixels& pixels) {
    using Kind = ShadedParts::Kind;
    const std::size_t n = pixels.light.size();
    gathered_.assign(n, Wide());
    sample_.ambient_.assign(n, look_.ambient);
    gather(sample_.ambient_);
    for (const auto& light : pixels.parts.lights()) gather(light.diffuse);
    tint(pixels.parts.albedo());
    for (const auto& light : pixels.parts.lights()) gather(light.highlight);
    std::vector<Rgb>& rest = sample_.rest_;
    rest.assign(n, Rgb(0));
    for (std::size_t i = 0; i < n; ++i) {
        if (pixels.parts.kinds()[i] != Kind::lit) rest[i] = pixels.light[i];
        gathered_[i].channel[3] = pixels.hits[i] ? Wide::white : 0;
    }
    gather(rest);
}

void WideCanvas::add(const DeferredPixels& pixels, Slots slots, int, int,
                     std::span<const std::uint8_t>) {
    if (look_.gathers) {
        gather(pixels);
        for (std::size_t i = 0; i < gathered_.size(); ++i) {
            for (int c = 0; c < 4; ++c) {
                std::uint32_t& sum = sums_[slots[i]].channel[c];
                sum = plus(sum, gathered_[i].channel[c]);
            }
        }
        return;
    }
    sample_.compose(pixels);
    scatter(sample_.words(), slots, scattered_, sums_.size());
    call_step(*look_.context, look_.steps->accumulate, look_.reference->accumulate,
              std::span<const Word>(scattered_), std::span(sums_));
}

void WideCanvas::resolve(int n, std::span<const std::uint8_t> dither, std::span<Rgb> colours,
                         std::span<std::uint8_t> alpha) {
    resolve(sums_, n, dither);
    see(resolved_, colours, alpha);
}

double WideCanvas::brightest(std::size_t slot, int n) const {
    const auto& channel = sums_[slot].channel;
    return std::max({channel[0], channel[1], channel[2]}) / (double{Wide::white} * n);
}

void WideCanvas::tone(std::size_t slot, int n, double white) {
    const double one = double{Wide::white} * n;
    for (int c = 0; c < 3; ++c) {
        std::uint32_t& channel = sums_[slot].channel[c];
        channel = static_cast<std::uint32_t>(toned(channel / one, white) * one + 0.5);
    }
}

Misfits WideCanvas::misfits() const {
    return {misfits_.not_a_number + sample_.misfits().not_a_number,
            misfits_.too_bright + sample_.misfits().too_bright};
}

}  // namespace luch::techniques::ldr
