#include "homework/ldr/check/make_samples.h"

#include "framework/math/rng.h"
#include "homework/ldr/check/store.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace luch::homework::ldr {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

/// What a sample is like: its light lies about so high, its words have levels in that range, and
/// some channels are no light at all.
struct Taste {
    float least = 0, most = 1;  ///< light, before exposure
    float exposure = 1;
    std::uint32_t lowest = 0, highest = 255;  ///< levels
    bool smooth = false;                      ///< ramps instead of noise
    bool wild = false;                        ///< NaN, infinities, 1e30, negative light
    int n = 1;
};

Taste taste_of(std::size_t index) {
    constexpr Taste tastes[] = {
        {.most = 2.2f, .exposure = 0.5f, .smooth = true, .n = 3},
        {.most = 1.2f, .exposure = 2, .wild = true, .n = 2},
        {.most = 3, .exposure = 0.25f, .lowest = 150, .wild = true, .n = 1},
        {.most = 0.1f, .exposure = 8, .highest = 90, .wild = true, .n = 64},
    };
    return tastes[index];
}

class Maker {
 public:
    Maker(Key key, const Taste& taste) : key_(key), taste_(taste) {}

    Sample inputs(std::string name) {
        Sample sample;
        sample.name = std::move(name);
        sample.exposure = taste_.exposure;
        sample.n = taste_.n;
        for (int y = 0; y < sample_size.height; ++y) {
            for (int x = 0; x < sample_size.width; ++x) add_pixel(sample, x, y);
        }
        return sample;
    }

 private:
    void add_pixel(Sample& sample, int x, int y) {
        const float across = (static_cast<float>(x) + 0.5f) / sample_size.width;
        const float down = (static_cast<float>(y) + 0.5f) / sample_size.height;
        const auto value = [&](float ramp) {
            return taste_.smooth ? 0.9f * ramp + 0.1f * uniform() : uniform();
        };
        sample.light.emplace_back(light(value(across)), light(value(down)),
                                  light(value((across + down) / 2)));
        sample.a.push_back(word(value(across), value(down)));
        sample.b.push_back(word(value(1 - across), value(across * down)));
        sample.alpha.push_back(end_or(static_cast<std::uint8_t>(255 * value(down) + 0.5f)));
        sample.up.push_back(static_cast<std::uint8_t>((x + y) & 1));
        sample.dither.push_back(static_cast<std::uint8_t>(256 * uniform()));
        sample.sums.push_back(sum(sample.a.back(), sample.b.back()));
    }
    float uniform() { return static_cast<float>(key_.uniform(drawn_++)); }
    /// Now and then one of the extremes.
    std::uint8_t end_or(std::uint8_t usual) {
        const float which = uniform();
        return which < 0.05f ? 0 : which < 0.1f ? 255 : usual;
    }
    float light(float value) {
        if (taste_.wild && uniform() < 0.06f) {
            constexpr float wild[] = {nan, infinite, -infinite, 1e30f, -1, 0};
            return wild[static_cast<std::size_t>(6 * uniform())];
        }
        return (taste_.least + (taste_.most - taste_.least) * value);
    }
    std::uint32_t level(float value) {
        const auto range = static_cast<float>(taste_.highest - taste_.lowest);
        return end_or(
            static_cast<std::uint8_t>(static_cast<float>(taste_.lowest) + range * value + 0.5f));
    }
    Word word(float first, float second) {
        return {level(second), level(first), level(uniform()), level((first + second) / 2)};
    }
    /// Of n words between a and b, some of them far above white.
    Wide sum(Word a, Word b) {
        Wide sum;
        for (int c = 0; c < 4; ++c) {
            const auto between =
                static_cast<double>(a.channel(c)) +
                (static_cast<double>(b.channel(c)) - static_cast<double>(a.channel(c))) * uniform();
            sum.channel[c] = static_cast<std::uint32_t>(between * Wide::level * taste_.n);
            if (taste_.wild && uniform() < 0.03f) {
                sum.channel[c] = ~std::uint32_t{0} - static_cast<std::uint32_t>(c);
            }
        }
        return sum;
    }

    Key key_;
    Taste taste_;
    std::uint64_t drawn_ = 0;
};

/// The reference's answers.
Sample answered(Sample sample, const Steps& steps) {
    sample.encoded.resize(sample.light.size());
    steps.encode(sample.light, sample.exposure, sample.encoded, sample.misfits);
    sample.added = sample.modulated = sample.mixed = sample.lerped = sample.a;
    steps.add(sample.added, sample.b);
    steps.modulate(sample.modulated, sample.b);
    steps.mix(sample.mixed, sample.b, sample.up);
    steps.lerp(sample.lerped, sample.b, sample.alpha);
    sample.accumulated = sample.sums;
    steps.accumulate(sample.a, sample.accumulated);
    sample.resolved.resize(sample.sums.size());
    steps.resolve(sample.sums, sample.n, sample.dither, sample.resolved);
    return sample;
}

}  // namespace

std::vector<Sample> samples_from_seed(std::uint64_t seed, const Steps& steps) {
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < std::size(sample_names); ++i) {
        Maker maker(Key(seed).branch(i), taste_of(i));
        samples.push_back(
            answered(maker.inputs(fmt::format("seed {}, {}", seed, sample_names[i])), steps));
    }
    return samples;
}

int regenerate(const std::filesystem::path& root, const Steps& steps,
               const grading::Regeneration& regeneration) {
    constexpr std::uint64_t public_seed = 2026;
    int changed = 0;
    for (std::size_t i = 0; i < std::size(sample_names); ++i) {
        Maker maker(Key(public_seed).branch(i), taste_of(i));
        const Sample sample = answered(maker.inputs(sample_names[i]), steps);
        const auto folder = root / "homework/ldr/reference" / sample.name;
        for (const grading::StoredPlane& plane : planes_of(sample)) {
            changed += grading::regenerate_plane(folder, plane, {}, regeneration);
        }
    }
    return changed;
}

}  // namespace luch::homework::ldr
