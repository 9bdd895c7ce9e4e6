#include "framework/measure/bench_mix.h"

#include "framework/math/rng.h"
#include "framework/measure/bench_contender.h"
#include "framework/measure/metrics.h"

#include <cmath>
#include <cstring>
#include <ctime>

namespace luch {
namespace {

constexpr std::size_t tile_pixels = 64 * 64;  // of the largest tile

const mix::Kernels& kernels(Isa isa) {
#if defined(LUCH_X86_64_LEVELS)
    if (isa == Isa::v2) return mix::kernels_v2();
    if (isa == Isa::v3) return mix::kernels_v3();
    if (isa == Isa::v4) return mix::kernels_v4();
#endif
    static_cast<void>(isa);
    return mix::kernels_plain();
}

/// Two pictures and a place for their mean. A value is a channel, or several packed into one.
template <class T>
struct Pictures {
    Aligned<T> a, b, mean;
    explicit Pictures(std::size_t n) : a(n), b(n), mean(n) {}
};

/// The same noise for all representations: RGB of 255 levels, and an alpha of 255.
void fill(Pictures<float>& pictures, Pictures<std::uint8_t>& bytes) {
    const Key key(61);
    for (std::size_t i = 0; i < bytes.a.size(); ++i) {
        const std::uint64_t noise = key.bits(i);
        bytes.a[i] = i % 4 == 3 ? 255 : static_cast<std::uint8_t>(noise);
        bytes.b[i] = i % 4 == 3 ? 255 : static_cast<std::uint8_t>(noise >> 8);
        if (i % 4 == 3) continue;
        pictures.a[i / 4 * 3 + i % 4] = static_cast<float>(bytes.a[i]) / 255;
        pictures.b[i / 4 * 3 + i % 4] = static_cast<float>(bytes.b[i]) / 255;
    }
}

/// The same bytes as integers.
template <class T>
Pictures<T> packed(const Pictures<std::uint8_t>& bytes) {
    Pictures<T> pictures(bytes.a.size() / sizeof(T));
    std::memcpy(pictures.a.data(), bytes.a.data(), pictures.a.size() * sizeof(T));
    std::memcpy(pictures.b.data(), bytes.b.data(), pictures.b.size() * sizeof(T));
    return pictures;
}

double error_of(const Pictures<float>& pictures) {
    double worst = 0;
    for (std::size_t i = 0; i < pictures.mean.size(); ++i) {
        const double exact = 0.5 * (double{pictures.a[i]} + double{pictures.b[i]});
        worst = std::max(worst, 255 * std::abs(pictures.mean[i] - exact));
    }
    return worst;
}

template <class T>
double error_of(const Pictures<T>& pictures) {
    const auto bytes_of = [](const Aligned<T>& values) {
        return reinterpret_cast<const unsigned char*>(values.data());
    };
    const auto *a = bytes_of(pictures.a), *b = bytes_of(pictures.b), *m = bytes_of(pictures.mean);
    double worst = 0;
    for (std::size_t i = 0; i < pictures.mean.size() * sizeof(T); ++i) {
        worst = std::max(worst, std::abs(m[i] - 0.5 * (a[i] + b[i])));
    }
    return worst;
}

template <class T>
Contender contender(const std::string& mode, int bytes_per_pixel,
                    void (*mix)(const T*, const T*, T*, std::size_t), Pictures<T>& pictures) {
    // Three pictures are read or written.
    const auto bytes = static_cast<std::size_t>(bytes_per_pixel / 3);
    return {{mode, "float", static_cast<double>(bytes_per_pixel)},
            [mix, bytes, &pictures](std::size_t pixels) {
                mix(pictures.a.data(), pictures.b.data(), pictures.mean.data(),
                    pixels * bytes / sizeof(T));
            },
            [&pictures] { return error_of(pictures); }};
}

/// The mean replaces what was `mean` before, which is `a` when the error is asked for.
template <class T>
Contender in_place(const std::string& mode, const std::string& against, int bytes_per_pixel,
                   void (*mix)(T*, const T*, std::size_t), Pictures<T>& pictures) {
    const auto bytes = static_cast<std::size_t>(bytes_per_pixel / 3);
    return {{mode, against, static_cast<double>(bytes_per_pixel)},
            [mix, bytes, &pictures](std::size_t pixels) {
                mix(pictures.mean.data(), pictures.b.data(), pixels * bytes / sizeof(T));
            },
            [mix, &pictures] {
                pictures.mean = pictures.a;
                mix(pictures.mean.data(), pictures.b.data(), pictures.mean.size());
                return error_of(pictures);
            }};
}

double seconds_of(const std::function<void()>& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// A frame whole, once more, then the same number of pixels tile by tile, all in one tile's memory.
void run_once(Contender& contender, std::size_t pixels, bool counts) {
    const double to_ns = 1e9 / static_cast<double>(pixels);
    const double frame = seconds_of([&] { contender.work(pixels); });
    const double again = seconds_of([&] { contender.work(pixels); });
    const auto side = static_cast<std::size_t>(contender.speed.tile_side);
    const std::size_t tiles = pixels / (side * side);
    const double tile = seconds_of([&] {
        for (std::size_t i = 0; i < tiles; ++i) contender.work(side * side);
    });
    if (!counts) return;
    contender.frame_ns.push_back(frame * to_ns);
    contender.again_ns.push_back(again * to_ns);
    contender.tile_ns.push_back(tile * 1e9 / static_cast<double>(tiles * side * side));
}

}  // namespace

std::vector<MixSpeed> raced(const MixBench& bench) {
    const std::size_t wanted = bench.size.area();
    // Whole tiles, so that every representation ends with a whole value.
    const std::size_t pixels = (wanted + tile_pixels - 1) / tile_pixels * tile_pixels;
    Pictures<float> floats(3 * pixels);
    Pictures<std::uint8_t> bytes(4 * pixels);
    fill(floats, bytes);
    auto words = packed<std::uint32_t>(bytes);
    auto longs = packed<std::uint64_t>(bytes);
    const mix::Kernels& with = kernels(bench.isa);
    std::vector<Contender> contenders{
        contender("float", 36, with.floats, floats),
        contender("float alone", 36, with.floats_alone, floats),
        contender("bytes alone", 12, with.bytes_alone, bytes),
        contender("word alone", 12, with.words_alone, words),
        contender("long alone", 12, with.longs_alone, longs),
        contender("word", 12, with.words, words),
        contender("bytes", 12, with.bytes, bytes),
        in_place("float in place", "float in place", 36, with.floats_in_place, floats),
        in_place("bytes in place", "float in place", 12, with.bytes_in_place, bytes)};
    for (auto& more : {plane_contenders(with, pixels), texture_contenders(pixels)}) {
        contenders.insert(contenders.end(), more.begin(), more.end());
    }
    std::vector<MixSpeed> speeds;
    for (int round = -1; round < bench.rounds; ++round) {  // the first one warms up
        for (Contender& each : contenders) run_once(each, pixels, round >= 0);
    }
    for (Contender& each : contenders) {
        each.work(pixels);
        each.speed.frame_ns = median(each.frame_ns);
        each.speed.again_ns = median(each.again_ns);
        each.speed.tile_ns = median(each.tile_ns);
        each.speed.worst_error = each.worst_error();
        speeds.push_back(each.speed);
    }
    return speeds;
}

}  // namespace luch
