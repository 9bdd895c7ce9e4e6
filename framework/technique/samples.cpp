#include "framework/technique/samples.h"

#include "framework/math/spread.h"

namespace luch {
namespace {

/// What a pixel's key is used for beside its samples, which are branches 0, 1, 2…
enum Purpose : std::uint64_t { place = ~std::uint64_t{0}, lens = ~std::uint64_t{1} };

Key pixel_key(const Shot& shot, int x, int y) {
    return Key(shot.seed).branch(static_cast<std::uint64_t>(y) *
                                     static_cast<std::uint64_t>(shot.size.width) +
                                 static_cast<std::uint64_t>(x));
}

}  // namespace

Key sample_key(const Shot& shot, int x, int y, int sample) {
    return pixel_key(shot, x, y).branch(static_cast<std::uint64_t>(sample));
}

int sample_count(const Shot& shot) {
    if (shot.spp > 0) return shot.spp;
    return shot.camera.has_lens() ? shot.camera.lens_samples : 1;
}

Vec2d sample_position(const Shot& shot, int x, int y, int sample, int samples) {
    const Vec2d corner(x, y);
    if (samples <= 1) return corner + 0.5;
    return corner + spread(pixel_key(shot, x, y).branch(place), static_cast<std::uint32_t>(sample));
}

Vec2d lens_point(const Shot& shot, int x, int y, int sample) {
    return disc_of(spread(pixel_key(shot, x, y).branch(lens), static_cast<std::uint32_t>(sample)));
}

Ray primary_ray(const Screen& screen, const Shot& shot, int x, int y, int sample, int samples,
                bool lens) {
    const Vec2d p = sample_position(shot, x, y, sample, samples);
    return lens ? screen.ray(p.x, p.y, lens_point(shot, x, y, sample)) : screen.ray(p.x, p.y);
}

}  // namespace luch
