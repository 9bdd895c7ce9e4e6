// What must hold whatever the reference says.
#include "homework/ldr/check/same_words.h"
#include "homework/ldr/check/tests.h"

#include <fmt/format.h>

#include <cmath>

namespace luch::homework::ldr {

using grading::failure;
using grading::Finding;

namespace {

/// A channel is left where the mask is.
std::vector<Word> masked(const std::vector<Word>& words, std::uint32_t mask) {
    std::vector<Word> result;
    for (const Word& word : words) result.push_back(Word(word.bits & mask));
    return result;
}

}  // namespace

Finding counts_misfits(const Steps& steps, const Sample& sample) {
    std::vector<Word> words(sample.light.size());
    // What was counted before must stay.
    Misfits misfits{3, 5};
    steps.encode(sample.light, sample.exposure, words, misfits);
    const Misfits expected{sample.misfits.not_a_number + 3, sample.misfits.too_bright + 5};
    if (misfits == expected) return {};
    return failure("the misfits are not counted right",
                   fmt::format("expected {} that are no number and {} too bright, got {} and {}",
                               expected.not_a_number, expected.too_bright, misfits.not_a_number,
                               misfits.too_bright));
}

Finding black_adds_nothing(const Steps& steps, const Sample& sample) {
    std::vector<Word> words = sample.a;
    const std::vector<Word> black(words.size(), Word(0));
    steps.add(words, black);
    return exactly(words, sample.a, "a colour plus black is that colour");
}

/// Two channels that overflow leave their neighbours alone.
Finding no_carry(const Steps& steps, const Sample& sample) {
    const std::uint32_t mask = 0x00ff00ffu;
    std::vector<Word> words = masked(sample.a, mask);
    for (Word& word : words) word.bits |= 0x00c800c8u;
    const std::vector<Word> more(words.size(), Word(0x00640064u));
    const std::vector<Word> expected(words.size(), Word(mask));
    steps.add(words, more);
    return exactly(words, expected, "200 and more plus 100 is 255, and nothing beside it");
}

Finding white_changes_nothing(const Steps& steps, const Sample& sample) {
    std::vector<Word> words = sample.a;
    const std::vector<Word> white(words.size(), Word(~0u));
    steps.modulate(words, white);
    return exactly(words, sample.a, "a colour times white is that colour");
}

/// A quarter of all 65,536 pairs of levels, which quarter goes by the sample.
Finding all_pairs(const Steps& steps, const Sample& sample) {
    const auto first = static_cast<std::uint32_t>(sample.name.back() & 3);
    std::vector<Word> a, b, exact;
    for (std::uint32_t x = first; x < 256; x += 4) {
        for (std::uint32_t y = 0; y < 256; ++y) {
            const std::uint32_t product = (2 * x * y + 255) / 510;
            a.emplace_back(x, x, x, x);
            b.emplace_back(y, y, y, y);
            exact.emplace_back(product, product, product, product);
        }
    }
    steps.modulate(a, b);
    return exactly(a, exact, "products are rounded to the nearest level");
}

Finding half_of_the_same(const Steps& steps, const Sample& sample) {
    std::vector<Word> words = sample.a;
    steps.mix(words, sample.a, sample.up);
    return exactly(words, sample.a, "half of a colour and half of the same is that colour");
}

Finding no_bias(const Steps& steps, const Sample& sample) {
    std::vector<Word> words = sample.a;
    steps.mix(words, sample.b, sample.up);
    double bias = 0;
    for (std::size_t i = 0; i < words.size(); ++i) {
        for (int c = 0; c < 4; ++c) {
            const double exact = (sample.a[i].channel(c) + sample.b[i].channel(c)) / 2.0;
            bias += (words[i].channel(c) - exact) / (4.0 * static_cast<double>(words.size()));
        }
    }
    if (std::abs(bias) <= 0.1) return {};
    return failure("halves are not rounded up and down in turn",
                   fmt::format("expected no error on the whole, got {:+.2f} levels", bias));
}

Finding from_end_to_end(const Steps& steps, const Sample& sample) {
    std::vector<Word> none = sample.a, all = sample.a;
    const std::vector<std::uint8_t> zero(none.size(), 0), full(none.size(), 255);
    steps.lerp(none, sample.b, zero);
    steps.lerp(all, sample.b, full);
    Finding start = exactly(none, sample.a, "alpha 0 leaves the colour");
    return start.passed ? exactly(all, sample.b, "alpha 255 gives the other colour") : start;
}

Finding sixty_four_layers(const Steps& steps, const Sample& sample) {
    std::vector<Wide> sums(sample.a.size()), expected(sample.a.size());
    for (int i = 0; i < 64; ++i) steps.accumulate(sample.a, sums);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        for (int c = 0; c < 4; ++c) {
            expected[i].channel[c] = 64 * Wide::level * sample.a[i].channel(c);
        }
    }
    return same_sums(sums, expected);
}

Finding many_are_as_one(const Steps& steps, const Sample& sample) {
    std::vector<Wide> one(sample.a.size()), many(sample.a.size());
    constexpr int n = 50;
    for (std::size_t i = 0; i < one.size(); ++i) {
        for (int c = 0; c < 4; ++c) {
            one[i].channel[c] = Wide::level * sample.a[i].channel(c);
            many[i].channel[c] = n * one[i].channel[c];
        }
    }
    std::vector<Word> from_one(one.size()), from_many(one.size());
    steps.resolve(one, 1, sample.dither, from_one);
    steps.resolve(many, n, sample.dither, from_many);
    return same_words(from_many, from_one);
}

}  // namespace luch::homework::ldr
