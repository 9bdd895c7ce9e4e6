// Mistakes that students make, by task: each is the reference with one step spoilt.
#include "homework/ldr/check/others.h"
#include "techniques/ldr/swar.h"

#include <algorithm>
#include <cmath>

namespace luch::homework::ldr {
namespace {

using namespace techniques::ldr;

/// A word, channel by channel.
template <class F>
Word each_channel(F&& f) {
    return {f(3) & 255u, f(2) & 255u, f(1) & 255u, f(0) & 255u};
}

struct EncodeRules {
    bool rounds = true, clamps = true, clamp_first = false, exposes = true, counts = true;
    std::uint32_t not_a_number = 0, alpha = 255;
};

template <EncodeRules rules>
void encode(std::span<const Rgb> light, float exposure, std::span<Word> words, Misfits& misfits) {
    const auto level = [&](float channel) -> std::uint32_t {
        if (rules.clamp_first) channel = std::min(channel, 1.0f);
        if (rules.exposes) channel *= exposure;
        if (std::isnan(channel)) {
            misfits.not_a_number += rules.counts ? 1 : 0;
            return rules.not_a_number;
        }
        misfits.too_bright += rules.counts && channel > 1 ? 1 : 0;
        const double most = rules.clamps ? 1.0 : 1e9;
        const double scaled = 255.0 * std::clamp<double>(channel, 0, most);
        return static_cast<std::uint32_t>(
                   static_cast<std::int64_t>(scaled + (rules.rounds ? 0.5 : 0))) &
               255u;
    };
    for (std::size_t i = 0; i < words.size(); ++i) {
        words[i] = {rules.alpha, level(light[i].r), level(light[i].g), level(light[i].b)};
    }
}

void add_wraps(std::span<Word> a, std::span<const Word> b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = each_channel([&](int c) { return a[i].channel(c) + b[i].channel(c); });
    }
}

void add_carries(std::span<Word> a, std::span<const Word> b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = Word(a[i].bits + b[i].bits);
}

void add_without_alpha(std::span<Word> a, std::span<const Word> b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = Word((a[i] + b[i]).bits & 0x00ffffffu);
    }
}

/// Only the highest bit of a channel that overflows is set.
void add_half_full(std::span<Word> a, std::span<const Word> b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = each_channel([&](int c) {
            const std::uint32_t sum = a[i].channel(c) + b[i].channel(c);
            return sum > 255 ? sum | 128u : sum;
        });
    }
}

template <std::uint32_t (*product_of)(std::uint32_t, std::uint32_t)>
void modulate(std::span<Word> a, std::span<const Word> b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = each_channel([&](int c) { return product_of(a[i].channel(c), b[i].channel(c)); });
    }
}

std::uint32_t by_256(std::uint32_t a, std::uint32_t b) {
    return a * b >> 8;
}
std::uint32_t cut_off(std::uint32_t a, std::uint32_t b) {
    return a * b / 255;
}
std::uint32_t not_divided(std::uint32_t a, std::uint32_t b) {
    return std::min(a * b, 255u);
}

void modulate_without_alpha(std::span<Word> a, std::span<const Word> b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = Word((a[i] * b[i]).bits | 0xff000000u);
}

void mix_of_lecture(std::span<Word> a, std::span<const Word> b, std::span<const std::uint8_t>) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = half_of_lecture(a[i], b[i]);
}

template <std::uint32_t up>
void mix_always(std::span<Word> a, std::span<const Word> b, std::span<const std::uint8_t>) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = half(a[i], b[i], up);
}

/// Each is halved by itself, with alpha.
void mix_of_halves(std::span<Word> a, std::span<const Word> b, std::span<const std::uint8_t>) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = each_channel([&](int c) { return a[i].channel(c) / 2 + b[i].channel(c) / 2; });
    }
}

void mix_unmasked(std::span<Word> a, std::span<const Word> b, std::span<const std::uint8_t>) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = Word((a[i].bits & b[i].bits) + ((a[i].bits ^ b[i].bits) >> 1));
    }
}

void lerp_backwards(std::span<Word> a, std::span<const Word> b,
                    std::span<const std::uint8_t> alpha) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = ldr::lerp(b[i], a[i], alpha[i]);
}

void lerp_by_256(std::span<Word> a, std::span<const Word> b, std::span<const std::uint8_t> alpha) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        const std::uint32_t t = alpha[i];
        a[i] = each_channel(
            [&](int c) { return (a[i].channel(c) * (256 - t) + b[i].channel(c) * t) >> 8; });
    }
}

void lerp_keeps_alpha(std::span<Word> a, std::span<const Word> b,
                      std::span<const std::uint8_t> alpha) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        const std::uint32_t kept = a[i].bits & 0xff000000u;
        a[i] = Word((ldr::lerp(a[i], b[i], alpha[i]).bits & 0x00ffffffu) | kept);
    }
}

void lerp_adds(std::span<Word> a, std::span<const Word> b, std::span<const std::uint8_t> alpha) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = a[i] + scaled(b[i], alpha[i]);
}

struct SumRules {
    std::uint32_t worth = Wide::level;
    bool adds = true, saturates = true, alpha = true;
};

template <SumRules rules>
void accumulate(std::span<const Word> words, std::span<Wide> sums) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        for (int c = 0; c < (rules.alpha ? 4 : 3); ++c) {
            const std::uint32_t more = words[i].channel(c) * rules.worth;
            const std::uint32_t before = rules.adds ? sums[i].channel[c] : 0;
            sums[i].channel[c] = rules.saturates ? plus(before, more) : before + more;
        }
    }
}

enum class Curve { srgb, gamma, none };

double curved(double x, Curve curve) {
    if (curve == Curve::none) return x;
    if (curve == Curve::gamma) return std::pow(x, 1 / 2.2);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

struct ResolveRules {
    Curve curve = Curve::srgb;
    bool divides = true, dithers = true, clamps = true, curved_alpha = false;
};

template <ResolveRules rules>
void resolve(std::span<const Wide> sums, int n, std::span<const std::uint8_t> dither,
             std::span<Word> words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        words[i] = each_channel([&](int c) {
            double x = sums[i].channel[c] / (double{Wide::white} * (rules.divides ? n : 1));
            if (rules.clamps) x = std::min(x, 1.0);
            if (c == 3 && !rules.curved_alpha) {
                return static_cast<std::uint32_t>(255 * std::min(x, 1.0) + 0.5);
            }
            const double between = rules.dithers ? dither[i] / 256.0 : 0.0;
            return static_cast<std::uint32_t>(255 * curved(x, rules.curve) + between);
        });
    }
}

std::vector<grading::Other> encode_and_add() {
    return {
        {"truncation", "ldr.t1", "levels are cut off, not rounded: add ½ first",
         with(&Steps::encode, encode<EncodeRules{.rounds = false}>)},
        {"clamp_before_exposure", "ldr.t1", "the clamp comes before the exposure",
         with(&Steps::encode, encode<EncodeRules{.clamp_first = true}>)},
        {"wrap_at_255", "ldr.t1", "what is above white begins again at black",
         with(&Steps::encode, encode<EncodeRules{.clamps = false}>)},
        {"nan_is_white", "ldr.t1", "what is no number becomes white",
         with(&Steps::encode, encode<EncodeRules{.not_a_number = 255}>)},
        {"no_exposure", "ldr.t1", "light is not multiplied by the exposure",
         with(&Steps::encode, encode<EncodeRules{.exposes = false}>)},
        {"no_alpha", "ldr.t1", "alpha is 0, not 255",
         with(&Steps::encode, encode<EncodeRules{.alpha = 0}>)},
        {"not_counted", "ldr.t1", "misfits are not counted",
         with(&Steps::encode, encode<EncodeRules{.counts = false}>)},
        {"add_wraps", "ldr.t2", "a sum above 255 begins again at 0", with(&Steps::add, add_wraps)},
        {"add_carries", "ldr.t2", "one integer addition: carries run into the next channel",
         with(&Steps::add, add_carries)},
        {"add_loses_alpha", "ldr.t2", "alpha is lost", with(&Steps::add, add_without_alpha)},
        {"add_half_full", "ldr.t2", "of a channel that overflows only the highest bit is set",
         with(&Steps::add, add_half_full)},
    };
}

std::vector<grading::Other> modulate_and_mix() {
    return {
        {"shift_by_eight", "ldr.t3", "a·b is divided by 256, not by 255",
         with(&Steps::modulate, modulate<by_256>)},
        {"product_cut_off", "ldr.t3", "a·b/255 is cut off, not rounded",
         with(&Steps::modulate, modulate<cut_off>)},
        {"not_divided", "ldr.t3", "a·b is not divided at all",
         with(&Steps::modulate, modulate<not_divided>)},
        {"modulate_keeps_alpha", "ldr.t3", "alpha is always 255",
         with(&Steps::modulate, modulate_without_alpha)},
        {"lecture_mix", "ldr.t4", "the lecture's mix: both lowest bits and alpha are lost",
         with(&Steps::mix, mix_of_lecture)},
        {"halves_by_themselves", "ldr.t4", "each colour is halved by itself: two bits are lost",
         with(&Steps::mix, mix_of_halves)},
        {"always_down", "ldr.t4", "halves are always rounded down, whatever up says",
         with(&Steps::mix, mix_always<0>)},
        {"always_up", "ldr.t4", "halves are always rounded up, whatever up says",
         with(&Steps::mix, mix_always<1>)},
        {"mix_unmasked", "ldr.t4", "a bit is shifted into the next channel: mask with 0x7f7f7f7f",
         with(&Steps::mix, mix_unmasked)},
    };
}

std::vector<grading::Other> lerp_to_resolve() {
    return {
        {"lerp_backwards", "ldr.t5", "alpha weighs the wrong colour",
         with(&Steps::lerp, lerp_backwards)},
        {"lerp_by_256", "ldr.t5", "weights of 256 in all, cut off: alpha 255 is not all",
         with(&Steps::lerp, lerp_by_256)},
        {"lerp_keeps_alpha", "ldr.t5", "alpha is not blended",
         with(&Steps::lerp, lerp_keeps_alpha)},
        {"lerp_adds", "ldr.t5", "the colour below is not weighed with 255 − alpha",
         with(&Steps::lerp, lerp_adds)},
        {"not_in_levels", "ldr.t6", "a level is worth 1, not Wide::level",
         with(&Steps::accumulate, accumulate<SumRules{.worth = 1}>)},
        {"replaces", "ldr.t6", "the sum is replaced, not added to",
         with(&Steps::accumulate, accumulate<SumRules{.adds = false}>)},
        {"sum_without_alpha", "ldr.t6", "alpha is not summed",
         with(&Steps::accumulate, accumulate<SumRules{.alpha = false}>)},
        {"sum_wraps", "ldr.t6", "a sum above the largest number begins again at 0",
         with(&Steps::accumulate, accumulate<SumRules{.saturates = false}>)},
        {"gamma_2_2", "ldr.t7", "a power of 1/2.2 instead of the curve of sRGB",
         with(&Steps::resolve, resolve<ResolveRules{.curve = Curve::gamma}>)},
        {"no_curve", "ldr.t7", "light goes to the screen without a curve",
         with(&Steps::resolve, resolve<ResolveRules{.curve = Curve::none}>)},
        {"not_divided_by_n", "ldr.t7", "the sum is not divided by n",
         with(&Steps::resolve, resolve<ResolveRules{.divides = false}>)},
        {"wraps_above_white", "ldr.t7", "what is above white begins again at black",
         with(&Steps::resolve, resolve<ResolveRules{.clamps = false}>)},
        {"resolve_cut_off", "ldr.t7", "levels are cut off: dither is not added",
         with(&Steps::resolve, resolve<ResolveRules{.dithers = false}>)},
        {"curved_alpha", "ldr.t7", "alpha goes through the curve too",
         with(&Steps::resolve, resolve<ResolveRules{.curved_alpha = true}>)},
    };
}

}  // namespace

std::vector<grading::Other> mutants() {
    std::vector<grading::Other> all;
    for (const auto& some : {encode_and_add(), modulate_and_mix(), lerp_to_resolve()}) {
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

}  // namespace luch::homework::ldr
