#include "framework/math/rng.h"
#include "framework/measure/bench_contender.h"
#include "framework/scene/word_texture.h"

#include <array>
#include <cmath>
#include <memory>

namespace luch {
namespace {

constexpr int plane_count = 6;

/// Albedo, three lights, highlights, all else; and the frame.
template <class T>
struct PlaneSet {
    std::vector<Aligned<T>> planes;

    explicit PlaneSet(std::size_t n) : planes(plane_count + 1, Aligned<T>(n)) {}
    [[nodiscard]] mix::Planes<T> all() {
        const auto plane = [&](std::size_t i) { return planes[i].data(); };
        return {plane(0), {plane(1), plane(2), plane(3)}, plane(4), plane(5), plane(6)};
    }
};

/// Levels of a plane: light so dim that no sum is above white.
std::uint8_t level(int plane, std::size_t i) {
    const std::uint64_t bits = Key(62).branch(static_cast<std::uint64_t>(plane)).bits(i);
    if (plane == 0) return static_cast<std::uint8_t>(bits & 255);
    return static_cast<std::uint8_t>((bits & 255) / (plane < 4 ? 4 : 8));
}

double exact(const std::array<double, plane_count>& v) {
    return v[0] * (v[1] + v[2] + v[3]) / 255 + v[4] + v[5];
}

/// In 255ths; `to_levels`: what a number of T is multiplied with for that.
template <class T>
double error_of(const PlaneSet<T>& set, double to_levels) {
    double worst = 0;
    for (std::size_t i = 0; i < set.planes[0].size(); ++i) {
        std::array<double, plane_count> values{};
        for (std::size_t p = 0; p < plane_count; ++p) values[p] = set.planes[p][i] * to_levels;
        const double got = set.planes[plane_count][i] * to_levels;
        worst = std::max(worst, std::abs(got - exact(values)));
    }
    return worst;
}

/// A picture of 1024 × 1024 texels of 8 bits a channel.
BitmapTexture noise_texture() {
    BitmapTexture texture{Image<Rgb>({1024, 1024}), 1, 0.5};
    std::array<float, 256> levels{};
    for (std::size_t i = 0; i < 256; ++i) levels[i] = srgb_decoded(static_cast<float>(i) / 255);
    for (std::size_t i = 0; i < texture.pixels.pixels().size(); ++i) {
        const std::uint64_t bits = Key(63).bits(i);
        texture.pixels.pixels()[i] = {levels[bits & 255], levels[bits >> 8 & 255],
                                      levels[bits >> 16 & 255]};
    }
    return texture;
}

/// Where a pixel looks: along slanted lines, a texel or so from one to the next.
Vec2d place(std::size_t i) {
    const auto x = static_cast<double>(i % 2048), y = static_cast<double>(i / 2048 % 2048);
    return {(x * 0.8 - y * 0.6) / 1024, (x * 0.6 + y * 0.8) / 1024};
}

struct Textures {
    Texture floats = noise_texture();
    WordTexture words = *WordTexture::of(std::get<BitmapTexture>(floats));
    std::vector<Rgb> from_floats, from_words;

    explicit Textures(std::size_t pixels) : from_floats(pixels), from_words(pixels) {}
    [[nodiscard]] double difference() const {
        float worst = 0;
        for (std::size_t i = 0; i < from_floats.size(); ++i) {
            worst = std::max(worst, max_norm(from_floats[i] - from_words[i]));
        }
        return 255.0 * worst;
    }
};

}  // namespace

std::vector<Contender> plane_contenders(const mix::Kernels& kernels, std::size_t pixels) {
    auto floats = std::make_shared<PlaneSet<float>>(3 * pixels);
    auto bytes = std::make_shared<PlaneSet<std::uint8_t>>(4 * pixels);
    for (int p = 0; p < plane_count; ++p) {
        const auto index = static_cast<std::size_t>(p);
        for (std::size_t i = 0; i < 4 * pixels; ++i) {
            bytes->planes[index][i] = level(p, i);
            if (i % 4 == 3) continue;
            floats->planes[index][i / 4 * 3 + i % 4] = static_cast<float>(level(p, i)) / 255;
        }
    }
    constexpr double planes = plane_count + 1;
    constexpr int plane_tile = 32;  // seven planes of words are then in the nearest cache
    return {{{"float planes", "float planes", 12 * planes, plane_tile},
             [floats, work = kernels.float_planes](std::size_t n) { work(floats->all(), 3 * n); },
             [floats] { return error_of(*floats, 255); }},
            {{"word planes", "float planes", 4 * planes, plane_tile},
             [bytes, work = kernels.byte_planes](std::size_t n) { work(bytes->all(), 4 * n); },
             [bytes] { return error_of(*bytes, 1); }}};
}

std::vector<Contender> texture_contenders(std::size_t pixels) {
    auto textures = std::make_shared<Textures>(pixels);
    const auto floats = [textures](std::size_t n) {
        for (std::size_t i = 0; i < n; ++i) {
            textures->from_floats[i] = colour_at(textures->floats, {place(i)});
        }
    };
    const auto words = [textures](std::size_t n) {
        for (std::size_t i = 0; i < n; ++i) {
            textures->from_words[i] = textures->words.colour_at(place(i));
        }
    };
    // Four texels are read, a colour is written.
    return {{{"float texture", "float texture", 4 * 12 + 12}, floats, [] { return 0.0; }},
            {{"word texture", "float texture", 4 * 4 + 12}, words, [textures] {
                 return textures->difference();
             }}};
}

}  // namespace luch
