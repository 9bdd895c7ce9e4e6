#include "framework/window/develop.h"

#include <array>

namespace luch {
namespace {

constexpr Pixel not_finite{255, 0, 255};
constexpr int tile_side = 64;

template <class T, class Colour>
Image<Pixel> painted(const Image<T>& from, const Colour& colour) {
    Image<Pixel> picture(from.size());
    std::transform(from.pixels().begin(), from.pixels().end(), picture.pixels().begin(), colour);
    return picture;
}

Pixel shown(const Rgb& linear) {
    return all_finite(linear) ? pixel_of(srgb_encoded(linear)) : not_finite;
}

/// Lightness rises from end to end, so that it reads in grey too.
Pixel heat(float value, float least, float most) {
    static constexpr std::array<Rgb, 4> ramp{Rgb(0.16f, 0.10f, 0.32f), Rgb(0.13f, 0.40f, 0.55f),
                                             Rgb(0.30f, 0.70f, 0.42f), Rgb(0.98f, 0.92f, 0.35f)};
    if (!std::isfinite(value)) return not_finite;
    const float range = most - least;
    const float t = range > 0 ? std::clamp((value - least) / range, 0.0f, 1.0f) : 0.0f;
    const float place = t * (ramp.size() - 1);
    const std::size_t i = std::min<std::size_t>(static_cast<std::size_t>(place), ramp.size() - 2);
    return pixel_of(glm::mix(ramp[i], ramp[i + 1], place - static_cast<float>(i)));
}

/// Neighbouring ids get colours far apart: the bits are mixed by a multiplicative hash (Knuth's
/// golden-ratio constant), and no channel is darker than 64.
Pixel id_colour(std::uint32_t id) {
    if (id == ~0u) return {};
    std::uint32_t bits = (id + 1) * 2654435769u;
    bits ^= bits >> 15;
    bits *= 2246822519u;
    const auto channel = [&](int shift) {
        return static_cast<std::uint8_t>(64 + ((bits >> shift) & 255u) * 191 / 255);
    };
    return {channel(0), channel(8), channel(16)};
}

Pixel normal_colour(const Rgb& normal) {
    return all_finite(normal) ? pixel_of(normal * 0.5f + 0.5f) : not_finite;
}

struct PlanePainter {
    const Plane2d& plane;

    Image<Pixel> operator()(const Image<float>& pixels) const {
        return painted(pixels, [&](float value) { return heat(value, plane.least, plane.most); });
    }
    Image<Pixel> operator()(const Image<std::uint32_t>& pixels) const {
        return painted(pixels, id_colour);
    }
    Image<Pixel> operator()(const Image<Rgb>& pixels) const {
        return painted(pixels, plane.kind == PlaneKind::normal ? normal_colour : shown);
    }
    Image<Pixel> operator()(const Image<std::uint8_t>& pixels) const {
        return painted(pixels, [](std::uint8_t value) {
            return value != 0 ? Pixel{255, 255, 255} : Pixel{};
        });
    }
};

void draw_line(ImageView<Pixel> picture, Vec2 from, Vec2 to, Pixel colour) {
    if (!std::isfinite(from.x + from.y + to.x + to.y)) return;
    const Vec2 way = to - from;
    const float longest = std::max(std::abs(way.x), std::abs(way.y));
    const int steps = static_cast<int>(std::min(longest, 1e5f)) + 1;
    for (int i = 0; i <= steps; ++i) {
        const Vec2 at = from + way * (static_cast<float>(i) / static_cast<float>(steps));
        if (!(at.x >= 0 && at.y >= 0)) continue;
        if (!(at.x < static_cast<float>(picture.width()))) continue;
        if (!(at.y < static_cast<float>(picture.height()))) continue;
        picture(static_cast<int>(at.x), static_cast<int>(at.y)) = colour;
    }
}

}  // namespace

Image<Pixel> developed(const Frame& frame, const Workers& workers) {
    Image<Pixel> picture(frame.size());
    workers.for_each_tile(frame.size(), tile_side, [&](Tile tile, int) {
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) picture(x, y) = shown(frame.colour(x, y));
        }
    });
    return picture;
}

Image<Pixel> developed(const Plane2d& plane) {
    return std::visit(PlanePainter{plane}, plane.pixels);
}

void draw_marks(ImageView<Pixel> picture, const std::vector<Mark>& marks) {
    for (const Mark& mark : marks) {
        const Pixel colour = shown(mark.colour);
        if (mark.shape == Mark::line) {
            draw_line(picture, {mark.x0, mark.y0}, {mark.x1, mark.y1}, colour);
            continue;
        }
        // A rectangle's far sides are those of its last pixels.
        const float right = std::max(mark.x0, mark.x1 - 1), bottom = std::max(mark.y0, mark.y1 - 1);
        draw_line(picture, {mark.x0, mark.y0}, {right, mark.y0}, colour);
        draw_line(picture, {mark.x0, bottom}, {right, bottom}, colour);
        draw_line(picture, {mark.x0, mark.y0}, {mark.x0, bottom}, colour);
        draw_line(picture, {right, mark.y0}, {right, bottom}, colour);
    }
}

}  // namespace luch
