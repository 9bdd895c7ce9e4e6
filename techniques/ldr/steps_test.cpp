#include "framework/accel/isa.h"
#include "framework/math/rng.h"
#include "techniques/ldr/ldr.h"
#include "techniques/ldr/spans.h"
#include "techniques/ldr/swar.h"
#include "tests/testing/kernel_objects.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace luch::techniques::ldr {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

Word encoded(const Rgb& light, float exposure = 1, Misfits* misfits = nullptr) {
    Misfits unused;
    Word word;
    reference().encode({&light, 1}, exposure, {&word, 1}, misfits != nullptr ? *misfits : unused);
    return word;
}

Word resolved(const Wide& sum, int n, std::uint8_t dither = 128) {
    Word word;
    reference().resolve({&sum, 1}, n, {&dither, 1}, {&word, 1});
    return word;
}

std::vector<Word> noise(std::size_t n, std::uint64_t seed) {
    std::vector<Word> words;
    for (std::size_t i = 0; i < n; ++i) {
        words.push_back(Word(static_cast<std::uint32_t>(Key(seed).bits(i))));
    }
    return words;
}

TEST(Encode, RoundsToTheNearestLevelAfterExposure) {
    EXPECT_EQ(encoded({0.5f, 0.25f, 1}), Word(255, 128, 64, 255));
    EXPECT_EQ(encoded({0.499f / 255, 0.501f / 255, 1.5f / 255}), Word(255, 0, 1, 2));
    EXPECT_EQ(encoded({4, 2, 0.5f}, 0.25f), Word(255, 255, 128, 32));
}

TEST(Encode, MakesWhatIsBeyondWhiteWhite) {
    Misfits misfits;
    EXPECT_EQ(encoded({1e30f, infinite, -1e30f}, 1, &misfits), Word(255, 255, 255, 0));
    EXPECT_EQ(misfits, (Misfits{.not_a_number = 0, .too_bright = 2}));
}

TEST(Encode, CountsWhatIsNoNumber) {
    Misfits misfits;
    EXPECT_EQ(encoded({nan, 0.5f, nan}, 1, &misfits), Word(255, 0, 128, 0));
    EXPECT_EQ(misfits, (Misfits{.not_a_number = 2, .too_bright = 0}));
}

TEST(Resolve, BringsBackSixtyFourLayersOfOneSixtyFourth) {
    const std::vector<Word> words = noise(500, 1);
    std::vector<Wide> sums(words.size());
    for (int i = 0; i < 64; ++i) reference().accumulate(words, sums);
    const std::vector<std::uint8_t> dither(words.size(), 128);
    std::vector<Word> means(words.size());
    reference().resolve(sums, 64, dither, means);
    for (std::size_t i = 0; i < words.size(); ++i) ASSERT_EQ(means[i], shown(words[i]));
}

/// What words alone make of it: every layer is rounded by itself.
TEST(Resolve, IsNeededBecauseWordsAloneDoNotBringThemBack) {
    Word sum(0);
    for (int i = 0; i < 64; ++i) sum = sum + scaled(Word(0x00646464u), 4);
    EXPECT_EQ(sum.channel(0), 128u) << "100/64 is 1.56 levels, which is 2 each";
}

TEST(Resolve, ShowsHalfBlackHalfWhiteAs188) {
    const Word both[] = {Word(0xff000000u), Word(0xffffffffu)};
    Wide sum;
    for (const Word& word : both) reference().accumulate({&word, 1}, {&sum, 1});
    EXPECT_EQ(resolved(sum, 2), Word(255, 188, 188, 188));
}

TEST(Resolve, IsWhiteForAllThatIsBrighter) {
    Wide sum;
    const Rgb bright(1e30f, 4000, 1.001f);
    Misfits misfits;
    reference().gather({&bright, 1}, 1, {&sum, 1}, misfits);
    EXPECT_EQ(misfits.too_bright, 3u);
    for (const int n : {1, 2}) {
        const Word word = resolved(sum, n);
        EXPECT_EQ(word.channel(2), 255u);
        EXPECT_EQ(word.channel(1), 255u);
    }
    reference().gather({&bright, 1}, 1, {&sum, 1}, misfits);
    EXPECT_EQ(resolved(sum, 1).channel(2), 255u) << "more than the largest stays the largest";
}

TEST(Resolve, IsTheCurveOfSrgbToTheNearestLevel) {
    for (std::uint32_t level = 0; level < 256; ++level) {
        const float exact = 255 * srgb_encoded(static_cast<float>(level) / 255);
        EXPECT_NEAR(shown(Word(level)).channel(0), exact, 0.501) << level;
        const Rgb back = seen(Word(level, level, level, level));
        EXPECT_EQ(byte_of(srgb_encoded(back.r)), level);
    }
}

TEST(Resolve, DithersToTheRightMean) {
    for (const float light : {0.001f, 0.2f, 0.7123f}) {
        Wide sum;
        Misfits misfits;
        const Rgb colour(light);
        reference().gather({&colour, 1}, 1, {&sum, 1}, misfits);
        double mean = 0;
        for (int d = 0; d < 256; ++d) {
            mean += resolved(sum, 1, static_cast<std::uint8_t>(d)).channel(0) / 256.0;
        }
        // 16 bits of linear light are 0.05 levels of the screen where it is darkest.
        EXPECT_NEAR(mean, 255 * srgb_encoded(light), 0.03);
    }
}

TEST(Resolve, LeavesALevelAloneWhateverTheDither) {
    for (const std::uint32_t level : {0u, 255u}) {
        for (const int d : {0, 128, 255}) {
            EXPECT_EQ(shown(Word(level), static_cast<std::uint8_t>(d)).channel(0), level);
        }
    }
}

TEST(Gather, KeepsWhatIsLessThanALevel) {
    Wide sum;
    Misfits misfits;
    const Rgb dim(0.4f / 255);
    for (int i = 0; i < 100; ++i) reference().gather({&dim, 1}, 1, {&sum, 1}, misfits);
    EXPECT_NEAR(sum.channel[0] / double{Wide::white}, 40.0 / 255, 1e-4);
    EXPECT_EQ(misfits, Misfits{});
}

TEST(Tint, MultipliesRangeAndAll) {
    Wide sum;
    Misfits misfits;
    const Rgb bright(3);
    reference().gather({&bright, 1}, 1, {&sum, 1}, misfits);
    const Word albedo(255, 188, 255, 0);
    reference().tint({&sum, 1}, {&albedo, 1});
    EXPECT_NEAR(sum.channel[2], 3 * srgb_decoded(188 / 255.0f) * Wide::white, 32);
    EXPECT_EQ(sum.channel[1], 3 * Wide::white);
    EXPECT_EQ(sum.channel[0], 0u);
}

const Spans& spans_of(Isa isa) {
#if defined(__x86_64__)
    if (isa == Isa::v2) return spans_v2();
    if (isa == Isa::v3) return spans_v3();
    if (isa == Isa::v4) return spans_v4();
#endif
    static_cast<void>(isa);
    return spans_plain();
}

/// 67 of them: whole vectors, and a rest.
TEST(Spans, AreTheWordsOperationsOnEveryProcessor) {
    const std::vector<Word> a = noise(67, 2), b = noise(67, 3);
    std::vector<std::uint8_t> t, up;
    for (std::size_t i = 0; i < a.size(); ++i) {
        t.push_back(static_cast<std::uint8_t>(Key(4).bits(i)));
        up.push_back(t.back() & 1);
    }
    for (const Isa isa : usable_isas()) {
        const Spans& spans = spans_of(isa);
        std::vector<Word> sum = a, product = a, mixed = a, between = a;
        spans.add(sum.data(), b.data(), a.size());
        spans.modulate(product.data(), b.data(), a.size());
        spans.mix(mixed.data(), b.data(), up.data(), a.size());
        spans.lerp(between.data(), b.data(), t.data(), a.size());
        std::vector<Wide> sums(a.size(), Wide{{1, 2, 3, ~0u}});
        spans.accumulate(a.data(), sums.data(), a.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            ASSERT_EQ(sum[i], a[i] + b[i]) << to_string(isa) << ' ' << i;
            ASSERT_EQ(product[i], a[i] * b[i]) << to_string(isa) << ' ' << i;
            ASSERT_EQ(mixed[i], half(a[i], b[i], up[i])) << to_string(isa) << ' ' << i;
            ASSERT_EQ(between[i], lerp(a[i], b[i], t[i])) << to_string(isa) << ' ' << i;
            ASSERT_EQ(sums[i].channel[1], a[i].channel(1) * Wide::level + 2) << to_string(isa);
            ASSERT_EQ(sums[i].channel[3], ~0u) << to_string(isa);
        }
    }
}

TEST(Spans, ExportOneEntryEachAndNothingThatALinkerMightShare) {
    testing::expect_one_entry_each(LUCH_KERNEL_OBJECTS "/techniques_ldr_", ".dir/spans.cpp.o",
                                   "luch::techniques::ldr::spans_");
}

}  // namespace
}  // namespace luch::techniques::ldr
