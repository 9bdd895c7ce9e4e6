#include "techniques/layered/through_lens.h"

#include "framework/math/spread.h"

#include <cmath>

namespace luch::techniques::layered {
namespace {

constexpr int block = 8;
/// Pixels after which the pattern repeats.
constexpr int period = 8;

/// Neighbours on a surface are no farther apart than this, in planes; else there is an edge.
constexpr float joined = 2.5f;

/// What a key is used for.
enum Purpose : std::uint64_t { place, lens };

}  // namespace

LensPattern::LensPattern(std::uint64_t seed, int samples) : count_(samples) {
    for (int pixel = 0; pixel < period * period; ++pixel) {
        const Key key = Key(seed).branch(static_cast<std::uint64_t>(pixel));
        for (int i = 0; i < samples; ++i) {
            const auto index = static_cast<std::uint32_t>(i);
            const Vec2d in_pixel = spread(key.branch(place), index);
            const Vec2d on_lens = disc_of(spread(key.branch(lens), index));
            samples_.push_back(
                {float(in_pixel.x), float(in_pixel.y), float(on_lens.x), float(on_lens.y)});
        }
    }
}

std::span<const LensPattern::Sample> LensPattern::of(int x, int y) const {
    const int pixel = y % period * period + x % period;
    return std::span(samples_).subspan(static_cast<std::size_t>(pixel) * count_, count_);
}

ThroughLens::ThroughLens(const Fragments& fragments, const Planes& planes, const Shot& shot,
                         float sky_depth, bool skip_small)
    : fragments_(&fragments),
      planes_(planes),
      detail_(fragments.wish().detail),
      margin_(fragments.wish().margin_px),
      skip_small_(skip_small),
      place_(fragments.size()),
      blocks_({(fragments.size().width + block - 1) / block,
               (fragments.size().height + block - 1) / block}) {
    const Screen screen(shot.camera, shot.size);
    stretch_ = shot.size.width / screen.half_width() / (shot.size.height / screen.half_height());
    const Lens model = lens_of(shot.camera, shot.size);
    const auto note = [&](int x, int y, float depth) {
        const float at = planes_.position(signed_radius_px(std::min(depth, sky_depth), model));
        Present& present = blocks_(x / block, y / block);
        present.set(static_cast<std::size_t>(at));
        present.set(static_cast<std::size_t>(std::ceil(at)));
        return at;
    };
    hidden_place_.resize(fragments.hidden().size());
    for (int y = 0; y < place_.height(); ++y) {
        for (int x = 0; x < place_.width(); ++x) {
            place_(x, y) = note(x, y, fragments.depth()(x, y));
            std::uint32_t i = fragments.behind(x, y);
            if (i == Fragments::none) continue;
            for (bool more = true; more; ++i) {
                hidden_place_[i] = note(x, y, fragments.hidden()[i].depth);
                more = !fragments.hidden()[i].last;
            }
        }
    }
}

std::vector<ThroughLens::Plane> ThroughLens::planes_near(Tile tile) const {
    std::vector<Plane> near;
    for (int k = 0; k < planes_.count(); ++k) {
        const double shift = planes_.radius_px(k) * detail_;
        const double reach_x = std::abs(shift * stretch_), reach_y = std::abs(shift);
        const auto first = [&](int from, double reach) {
            return static_cast<int>(std::max((from + margin_) * detail_ - reach, 0.0)) / block;
        };
        const auto last = [&](int to, double reach, int end) {
            return std::min(static_cast<int>((to + margin_) * detail_ + reach) / block, end - 1);
        };
        const int x1 = last(tile.x1, reach_x, blocks_.width());
        const int y1 = last(tile.y1, reach_y, blocks_.height());
        bool present = false;
        for (int y = first(tile.y0, reach_y); y <= y1 && !present; ++y) {
            for (int x = first(tile.x0, reach_x); x <= x1 && !present; ++x) {
                present = blocks_(x, y).test(static_cast<std::size_t>(k));
            }
        }
        // The screen's y runs down.
        if (present) near.push_back({k, float(shift * stretch_), float(-shift)});
    }
    return near;
}

const Rgb* ThroughLens::behind(int x, int y, float plane) const {
    std::uint32_t i = fragments_->behind(x, y);
    if (i == Fragments::none) return nullptr;
    for (;; ++i) {
        const float at = hidden_place_[i];
        if (at <= plane + 0.5f && at > plane - joined) return &fragments_->hidden()[i].colour;
        if (fragments_->hidden()[i].last) return nullptr;
    }
}

ThroughLens::Found ThroughLens::find(std::span<const Plane> planes, float x, float y,
                                     const LensPattern::Sample& sample) const {
    constexpr float nowhere_near = std::numeric_limits<float>::infinity();
    float before = nowhere_near;  // the surface that the ray stood in front of last
    int i = 0, j = 0;
    for (const Plane& plane : planes) {
        const float at_x = x + plane.shift_x * sample.lens_x;
        const float at_y = y + plane.shift_y * sample.lens_y;
        i = std::clamp(static_cast<int>(at_x), 0, place_.width() - 1);
        j = std::clamp(static_cast<int>(at_y), 0, place_.height() - 1);
        const float surface = place_(i, j), here = static_cast<float>(plane.index);
        if (surface > here + 0.5f) {
            before = surface;
            continue;
        }
        // There, or crossed since the last plane.
        if (surface >= here - 0.5f || before - surface < joined)
            return {&fragments_->colour()(i, j)};
        before = nowhere_near;
        if (const Rgb* found = behind(i, j, here)) return {found};
    }
    return {&fragments_->colour()(i, j), false};
}

Rgb ThroughLens::sharp(int x, int y) const {
    Rgb sum(0);
    for (int j = 0; j < detail_; ++j) {
        for (int i = 0; i < detail_; ++i) {
            sum += fragments_->colour()((x + margin_) * detail_ + i, (y + margin_) * detail_ + j);
        }
    }
    return sum / static_cast<float>(detail_ * detail_);
}

std::uint64_t ThroughLens::look(Tile tile, const LensPattern& pattern, ImageView<Rgb> colour,
                                ImageView<float> unknown) const {
    const std::vector<Plane> planes = planes_near(tile);
    const float small = skip_small_ ? float(Planes::merged_px / 2 * detail_) : 0;
    const bool is_sharp = std::ranges::all_of(
        planes, [&](const Plane& plane) { return std::abs(plane.shift_y) <= small; });
    std::uint64_t followed = 0;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            unknown(x, y) = 0;
            if (is_sharp) {
                colour(x, y) = sharp(x, y);
                continue;
            }
            const std::span<const LensPattern::Sample> samples = pattern.of(x, y);
            Rgb sum(0);
            int lost = 0;
            for (const LensPattern::Sample& sample : samples) {
                const auto texel = [&](int p, float in_pixel) {
                    return (float(p + margin_) + in_pixel) * float(detail_);
                };
                const Found found = find(planes, texel(x, sample.x), texel(y, sample.y), sample);
                sum += *found.colour;
                lost += found.known ? 0 : 1;
            }
            colour(x, y) = sum / static_cast<float>(samples.size());
            unknown(x, y) = static_cast<float>(lost) / static_cast<float>(samples.size());
            followed += samples.size();
        }
    }
    return followed;
}

}  // namespace luch::techniques::layered
