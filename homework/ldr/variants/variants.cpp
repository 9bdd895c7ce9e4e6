// Honest solutions: other arithmetic, other order, and each as good as the reference.
#include "homework/ldr/check/others.h"
#include "techniques/ldr/swar.h"

#include <algorithm>
#include <cmath>

namespace luch::homework::ldr {
namespace {

using namespace techniques::ldr;

template <class F>
Word each_channel(F&& f) {
    return {f(3), f(2), f(1), f(0)};
}

std::uint32_t nearest(double value) {
    return static_cast<std::uint32_t>(std::lround(value));
}

/// In double, from the last pixel to the first, channels in turn.
void encode_in_double(std::span<const Rgb> light, float exposure, std::span<Word> words,
                      Misfits& misfits) {
    for (std::size_t i = words.size(); i-- > 0;) {
        std::uint32_t bits = 0xff;
        for (const double channel : {light[i].r, light[i].g, light[i].b}) {
            const double exposed = channel * exposure;
            if (exposed != exposed) ++misfits.not_a_number;
            if (exposed > 1) ++misfits.too_bright;
            bits = bits << 8 | nearest(exposed > 0 ? 255 * std::min(exposed, 1.0) : 0.0);
        }
        words[i] = Word(bits);
    }
}

/// Looks for the level instead of computing it.
void encode_by_search(std::span<const Rgb> light, float exposure, std::span<Word> words,
                      Misfits& misfits) {
    const auto level = [&](float channel) {
        misfits.not_a_number += std::isnan(channel) ? 1 : 0;
        misfits.too_bright += channel > 1 ? 1 : 0;
        std::uint32_t least = 0, most = 255;
        while (least < most) {
            const std::uint32_t middle = (least + most + 1) / 2;
            if (channel >= (static_cast<float>(middle) - 0.5f) / 255) {
                least = middle;
            } else {
                most = middle - 1;
            }
        }
        return least;
    };
    for (std::size_t i = 0; i < words.size(); ++i) {
        const Rgb exposed = light[i] * exposure;
        words[i] = {255, level(exposed.r), level(exposed.g), level(exposed.b)};
    }
}

void add_by_channel(std::span<Word> a, std::span<const Word> b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] =
            each_channel([&](int c) { return std::min(a[i].channel(c) + b[i].channel(c), 255u); });
    }
}

/// Two channels at a time, with a bit of room.
void add_in_pairs(std::span<Word> a, std::span<const Word> b) {
    const auto pair = [](std::uint32_t x, std::uint32_t y) {
        const std::uint32_t sum = (x & 0x00ff00ffu) + (y & 0x00ff00ffu);
        const std::uint32_t over = sum >> 8 & 0x00010001u;
        return (sum | over * 255u) & 0x00ff00ffu;
    };
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = Word(pair(a[i].bits, b[i].bits) | pair(a[i].bits >> 8, b[i].bits >> 8) << 8);
    }
}

void modulate_in_float(std::span<Word> a, std::span<const Word> b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = each_channel([&](int c) {
            return nearest(static_cast<float>(a[i].channel(c) * b[i].channel(c)) / 255.0f);
        });
    }
}

void modulate_by_division(std::span<Word> a, std::span<const Word> b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = each_channel([&](int c) { return (a[i].channel(c) * b[i].channel(c) + 127) / 255; });
    }
}

/// 1/255 = (1 + 1/256 + …)/256, in one multiplication.
void modulate_by_reciprocal(std::span<Word> a, std::span<const Word> b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = each_channel(
            [&](int c) { return (a[i].channel(c) * b[i].channel(c) + 128) * 257 >> 16; });
    }
}

void mix_by_channel(std::span<Word> a, std::span<const Word> b, std::span<const std::uint8_t> up) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = each_channel([&](int c) { return (a[i].channel(c) + b[i].channel(c) + up[i]) / 2; });
    }
}

void mix_by_choice(std::span<Word> a, std::span<const Word> b, std::span<const std::uint8_t> up) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = up[i] != 0 ? half_up(a[i], b[i]) : half_down(a[i], b[i]);
    }
}

void lerp_in_float(std::span<Word> a, std::span<const Word> b,
                   std::span<const std::uint8_t> alpha) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        const float t = static_cast<float>(alpha[i]) / 255;
        a[i] = each_channel([&](int c) {
            const auto from = static_cast<float>(a[i].channel(c));
            return nearest(from * (1 - t) + static_cast<float>(b[i].channel(c)) * t);
        });
    }
}

/// a + (b − a)·t, the difference being rounded away from zero.
void lerp_by_difference(std::span<Word> a, std::span<const Word> b,
                        std::span<const std::uint8_t> alpha) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = each_channel([&](int c) {
            const int from = static_cast<int>(a[i].channel(c));
            const int way = (static_cast<int>(b[i].channel(c)) - from) * alpha[i];
            return static_cast<std::uint32_t>(from + (way + (way < 0 ? -127 : 127)) / 255);
        });
    }
}

void accumulate_in_64_bits(std::span<const Word> words, std::span<Wide> sums) {
    for (int c = 3; c >= 0; --c) {
        for (std::size_t i = 0; i < words.size(); ++i) {
            const std::uint64_t sum =
                sums[i].channel[c] + std::uint64_t{words[i].channel(c)} * Wide::level;
            sums[i].channel[c] = static_cast<std::uint32_t>(std::min<std::uint64_t>(sum, ~0u));
        }
    }
}

template <class Real>
Real srgb(Real x) {
    return x <= Real(0.0031308) ? Real(12.92) * x
                                : Real(1.055) * std::pow(x, 1 / Real(2.4)) - Real(0.055);
}

/// No table, in Real.
template <class Real>
void resolve_in(std::span<const Wide> sums, int n, std::span<const std::uint8_t> dither,
                std::span<Word> words) {
    const Real one = Real(Wide::white) * Real(n);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto level = [&](int c) {
            const Real x = std::min(Real(sums[i].channel[c]) / one, Real(1));
            return static_cast<std::uint32_t>(255 * srgb(x) + Real(dither[i]) / 256);
        };
        const Real alpha = std::min(Real(sums[i].channel[3]) / one, Real(1));
        words[i] = {static_cast<std::uint32_t>(255 * alpha + Real(0.5)), level(2), level(1),
                    level(0)};
    }
}

/// By a table of 4096 entries, between which it is a straight line.
void resolve_by_table(std::span<const Wide> sums, int n, std::span<const std::uint8_t> dither,
                      std::span<Word> words) {
    std::vector<double> table;
    for (int i = 0; i <= 4097; ++i) table.push_back(255 * srgb(i / 4096.0));
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto part = [&](int c) {
            return std::min(sums[i].channel[c] / (double{Wide::white} * n), 1.0);
        };
        const auto level = [&](int c) {
            const double at = 4096 * part(c);
            const auto k = static_cast<std::size_t>(at);
            const double between = at - static_cast<double>(k);
            const double value = table[k] * (1 - between) + table[k + 1] * between;
            return static_cast<std::uint32_t>(value + dither[i] / 256.0);
        };
        words[i] = {nearest(255 * part(3)), level(2), level(1), level(0)};
    }
}

}  // namespace

std::vector<grading::Other> variants() {
    return {
        {"reference", "", "the reference itself", reference()},
        {"encode_in_double", "ldr.t1", "in double, backwards",
         with(&Steps::encode, encode_in_double)},
        {"encode_by_search", "ldr.t1", "by trying levels", with(&Steps::encode, encode_by_search)},
        {"add_by_channel", "ldr.t2", "a channel at a time", with(&Steps::add, add_by_channel)},
        {"add_in_pairs", "ldr.t2", "two channels at a time", with(&Steps::add, add_in_pairs)},
        {"modulate_in_float", "ldr.t3", "in float", with(&Steps::modulate, modulate_in_float)},
        {"modulate_by_division", "ldr.t3", "by a division",
         with(&Steps::modulate, modulate_by_division)},
        {"modulate_by_reciprocal", "ldr.t3", "by one multiplication",
         with(&Steps::modulate, modulate_by_reciprocal)},
        {"mix_by_channel", "ldr.t4", "a channel at a time", with(&Steps::mix, mix_by_channel)},
        {"mix_by_choice", "ldr.t4", "one of two formulas", with(&Steps::mix, mix_by_choice)},
        {"lerp_in_float", "ldr.t5", "in float", with(&Steps::lerp, lerp_in_float)},
        {"lerp_by_difference", "ldr.t5", "the difference is weighed",
         with(&Steps::lerp, lerp_by_difference)},
        {"accumulate_in_64_bits", "ldr.t6", "in 64 bits, channel after channel",
         with(&Steps::accumulate, accumulate_in_64_bits)},
        {"resolve_in_double", "ldr.t7", "in double, without a table",
         with(&Steps::resolve, resolve_in<double>)},
        {"resolve_in_float", "ldr.t7", "in float, without a table",
         with(&Steps::resolve, resolve_in<float>)},
        {"resolve_by_table", "ldr.t7", "a table of 4096 entries, and straight lines",
         with(&Steps::resolve, resolve_by_table)},
    };
}

}  // namespace luch::homework::ldr
