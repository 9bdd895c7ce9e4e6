#pragma once

#include "techniques/layered/fragments.h"
#include "techniques/layered/planes.h"

#include <bitset>
#include <vector>

namespace luch::techniques::layered {

/// Points of the lens and of a pixel, the same for pixels eight apart.
class LensPattern {
 public:
    struct Sample {
        float x, y;            ///< in the pixel, 0..1
        float lens_x, lens_y;  ///< in the unit disc
    };
    LensPattern(std::uint64_t seed, int samples);
    [[nodiscard]] std::span<const Sample> of(int x, int y) const;

 private:
    int count_;
    std::vector<Sample> samples_;
};

/// A picture through the lens, found in sharp fragments: a lens ray crosses one plane after the
/// other, where it stands in front of another texel each time, until that texel's surface is there.
class ThroughLens {
 public:
    /// sky_depth: where the sky is taken to be; may be infinite. `skip_small`: where no circle of
    /// confusion reaches Planes::merged_px the picture is taken as it is.
    ThroughLens(const Fragments& fragments, const Planes& planes, const Shot& shot, float sky_depth,
                bool skip_small);

    /// Fills a tile. unknown: the share of a pixel's rays that found nothing, and took what the
    /// last texel had. Returns how many rays were followed: 0 where the picture is sharp.
    std::uint64_t look(Tile tile, const LensPattern& pattern, ImageView<Rgb> colour,
                       ImageView<float> unknown) const;

 private:
    using Present = std::bitset<most_layers + 1>;
    struct Plane {
        int index;
        float shift_x, shift_y;  ///< texels for a point at the lens's rim
    };
    struct Found {
        const Rgb* colour;
        bool known = true;
    };
    [[nodiscard]] std::vector<Plane> planes_near(Tile tile) const;
    [[nodiscard]] Found find(std::span<const Plane> planes, float x, float y,
                             const LensPattern::Sample& sample) const;
    [[nodiscard]] const Rgb* behind(int x, int y, float plane) const;
    [[nodiscard]] Rgb sharp(int x, int y) const;

    const Fragments* fragments_;
    Planes planes_;
    int detail_, margin_;
    double stretch_;  ///< pixels across for a pixel down
    bool skip_small_;
    Image<float> place_;  ///< of each texel's front, in planes
    std::vector<float> hidden_place_;
    Image<Present> blocks_;  ///< planes next to a fragment in a block of texels
};

}  // namespace luch::techniques::layered
