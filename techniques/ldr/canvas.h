#pragma once

#include "framework/baseline/deferred.h"
#include "techniques/ldr/ldr.h"

#include <vector>

// Where the samples of a tile's pixels are put together: in words, in wide sums, or worked out with
// another number of levels. All three have the same functions; render.h asks for them.
namespace luch::techniques::ldr {

/// What does not change from tile to tile.
struct Look {
    const Steps* steps;      ///< to be used
    const Steps* reference;  ///< where one is not written
    Context* context;
    Rgb ambient;
    float exposure = 1;
    bool gathers = false;  ///< light is summed wide, before it is a word
    int levels = 256;
};

/// One sample of some pixels in words, composed by the steps:
/// albedo·(ambient + Σ diffuse) + Σ highlight + all else, then the layers over one another, then
/// all of it over the sky, by coverage.
class WordSample {
 public:
    explicit WordSample(const Look& look) : look_(look) {}

    /// Replaces words(); alpha is coverage: 255 where something was hit, else 0.
    void compose(const DeferredPixels& pixels);
    [[nodiscard]] std::vector<Word>& words() { return words_; }
    [[nodiscard]] const Misfits& misfits() const { return misfits_; }

 private:
    friend class WideCanvas;
    std::span<const Word> encoded(std::span<const Rgb> light, float exposure);
    void add(std::span<const Rgb> light);
    void add_layers(const DeferredPixels& pixels);
    void over_sky(const DeferredPixels& pixels);
    void split(const DeferredPixels& pixels);

    Look look_;
    Misfits misfits_;
    std::vector<Word> words_, other_;
    std::vector<Rgb> ambient_, rest_, sky_;
    std::vector<std::uint8_t> alpha_;
};

/// Where the points of a sample belong in a tile: slots[i] of point i.
using Slots = std::span<const std::uint32_t>;

/// Sums are words: n samples of a pixel are n words, each a share of it.
class WordCanvas {
 public:
    using Sum = Word;
    explicit WordCanvas(const Look& look) : look_(look), sample_(look) {}

    void start(std::size_t slots) { sums_.assign(slots, Word(0)); }
    /// The sample-th of n; `up`: how the halves of each slot are rounded.
    void add(const DeferredPixels& pixels, Slots slots, int sample, int n,
             std::span<const std::uint8_t> up);
    /// One sample becomes the first of n.
    void share(int n);
    void resolve(int n, std::span<const std::uint8_t> dither, std::span<Rgb> colours,
                 std::span<std::uint8_t> alpha);
    /// The largest channel of a slot, and what becomes of the brightest: nothing, they are
    /// within 1.
    [[nodiscard]] double brightest(std::size_t, int) const { return 1; }
    void tone(std::size_t, int, double) {}
    [[nodiscard]] std::vector<Sum>& sums() { return sums_; }
    [[nodiscard]] Misfits misfits() const { return sample_.misfits(); }

 private:
    Look look_;
    WordSample sample_;
    std::vector<Word> sums_, scattered_;
};

/// Sums are wide. Where light need not be gathered they are sums of words.
class WideCanvas {
 public:
    using Sum = Wide;
    explicit WideCanvas(const Look& look) : look_(look), sample_(look) {}

    void start(std::size_t slots) { sums_.assign(slots, Wide()); }
    void add(const DeferredPixels& pixels, Slots slots, int sample, int n,
             std::span<const std::uint8_t> up);
    void share(int) {}
    void resolve(int n, std::span<const std::uint8_t> dither, std::span<Rgb> colours,
                 std::span<std::uint8_t> alpha);
    [[nodiscard]] double brightest(std::size_t slot, int n) const;
    void tone(std::size_t slot, int n, double white);
    [[nodiscard]] std::vector<Sum>& sums() { return sums_; }
    [[nodiscard]] Misfits misfits() const;

 private:
    void gather(const DeferredPixels& pixels);
    void gather(std::span<const Rgb> light);
    void tint(std::span<const Rgb> albedo);
    void resolve(std::span<const Wide> sums, int n, std::span<const std::uint8_t> dither);

    Look look_;
    WordSample sample_;
    Misfits misfits_;
    std::vector<Wide> sums_, gathered_, albedo_;
    std::vector<Word> scattered_, resolved_;
    std::vector<std::uint8_t> no_dither_;
};

/// The same with any number of levels: what words of so many bits a channel would show.
class LevelCanvas {
 public:
    using Sum = Vec3d;
    explicit LevelCanvas(const Look& look) : look_(look), most_(look.levels - 1) {}

    void start(std::size_t slots) { sums_.assign(slots, Vec3d(0)); }
    void add(const DeferredPixels& pixels, Slots slots, int sample, int n,
             std::span<const std::uint8_t> up);
    void share(int) {}
    void resolve(int n, std::span<const std::uint8_t> dither, std::span<Rgb> colours,
                 std::span<std::uint8_t> alpha);
    [[nodiscard]] double brightest(std::size_t slot, int n) const;
    void tone(std::size_t slot, int n, double white);
    [[nodiscard]] std::vector<Sum>& sums() { return sums_; }
    [[nodiscard]] Misfits misfits() const { return misfits_; }

 private:
    [[nodiscard]] Vec3d rounded(const Vec3d& colour) const;
    [[nodiscard]] Vec3d rounded_on_screen(const Rgb& colour) const;
    [[nodiscard]] Vec3d plane(const Rgb& light);
    [[nodiscard]] Vec3d composed(const DeferredPixels& pixels, std::size_t point);
    [[nodiscard]] Vec3d saturated(const Vec3d& colour) const;

    Look look_;
    double most_;
    Misfits misfits_;
    std::vector<Vec3d> sums_;
};

/// Reinhard's curve with a white point ("Photographic Tone Reproduction for Digital Images", 2002,
/// eq. 4): x·(1 + x/white²)/(1 + x). white goes to 1; with white = 1 nothing changes.
[[nodiscard]] inline double toned(double x, double white) {
    return white <= 1 ? x : x * (1 + x / (white * white)) / (1 + x);
}

}  // namespace luch::techniques::ldr
