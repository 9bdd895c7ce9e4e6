#include "techniques/layered/composite.h"

#include <algorithm>
#include <limits>
#include <mutex>

namespace luch::techniques::layered {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

/// Tiles of the steps: large, as each call looks at more than its tile.
constexpr int tile_side = 64;

bool within(float depth, float near, float far) {
    return depth >= near && (depth < far || (depth == infinite && far == infinite));
}

bool overlap(const Tile& a, const Tile& b) {
    return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

/// The mean of what is sharp enough to be averaged: finite and > 0 numbers of confusion.
struct Mean {
    double sum = 0;
    std::size_t count = 0;
    void add(float px) {
        sum += px;
        ++count;
    }
    [[nodiscard]] float value() const {
        return count > 0 ? static_cast<float>(sum / static_cast<double>(count)) : 0;
    }
};

}  // namespace

void Composite::resize(Size size) {
    if (layer_.size() == size) return;
    depth_ = coc_ = Image<float>(size);
    layer_ = blurred_ = result_ = Image<Rgba>(size);
}

std::vector<float> Composite::cuts(const Image<float>& depth, int layers, Context& context) const {
    std::vector<float> between(static_cast<std::size_t>(layers - 1));
    call_step(context, steps_.cut, reference().cut, std::span<const float>(depth.pixels()), layers,
              std::span<float>(between));
    return between;
}

void Composite::confusion(const Fragments& fragments, const Lens& lens, Context& context,
                          ImageView<float> px) const {
    context.for_each_tile(
        px.size(),
        [&](Tile tile, int) {
            call_step(context, steps_.coc, reference().coc, fragments.depth().view(), lens, tile,
                      px);
        },
        tile_side);
}

Composite::Layer Composite::collect(const Fragments& fragments, const Lens& lens, float near,
                                    float far, Context& context) {
    const Size size = fragments.size();
    Layer layer{near, far, {size.width, size.height, 0, 0}};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const Rgb* colour = nullptr;
            depth_(x, y) = fragments.depth()(x, y);
            if (within(depth_(x, y), near, far)) colour = &fragments.colour()(x, y);
            std::uint32_t i = fragments.behind(x, y);
            while (colour == nullptr && i != Fragments::none) {
                const Hidden& hidden = fragments.hidden()[i];
                depth_(x, y) = hidden.depth;
                if (within(hidden.depth, near, far)) colour = &hidden.colour;
                i = hidden.last ? Fragments::none : i + 1;
            }
            layer_(x, y) = colour != nullptr ? Rgba(*colour, 1) : Rgba(0);
            if (colour == nullptr) continue;
            layer.reach = {std::min(layer.reach.x0, x), std::min(layer.reach.y0, y),
                           std::max(layer.reach.x1, x + 1), std::max(layer.reach.y1, y + 1)};
        }
    }
    context.for_each_tile(
        size,
        [&](Tile tile, int) {
            call_step(context, steps_.coc, reference().coc, depth_.view(), lens, tile, coc_.view());
        },
        tile_side);
    Mean mean;
    float largest = 0;
    for (std::size_t i = 0; i < coc_.pixels().size(); ++i) {
        if (layer_.pixels()[i].a == 0) continue;
        mean.add(coc_.pixels()[i]);
        largest = std::max(largest, coc_.pixels()[i]);
    }
    // Where the layer is empty, its emptiness is blurred as much as the rest of it.
    for (std::size_t i = 0; i < coc_.pixels().size(); ++i) {
        if (layer_.pixels()[i].a == 0) coc_.pixels()[i] = mean.value();
    }
    const int aside = static_cast<int>(std::min(largest / 2, float(size.width + size.height))) + 1;
    layer.reach = {layer.reach.x0 - aside, layer.reach.y0 - aside, layer.reach.x1 + aside,
                   layer.reach.y1 + aside};
    return layer;
}

void Composite::discs(const Fragments& fragments, const Lens& lens, std::span<const float> cuts,
                      Context& context, ImageView<Rgb> colour) {
    resize(fragments.size());
    std::fill(result_.pixels().begin(), result_.pixels().end(), Rgba(0));
    for (std::size_t k = cuts.size() + 1; k-- > 0;) {
        const float near = k == 0 ? -infinite : cuts[k - 1];
        const float far = k == cuts.size() ? infinite : cuts[k];
        if (!(near < far)) continue;
        const Layer layer = collect(fragments, lens, near, far, context);
        if (layer.reach.x0 >= layer.reach.x1) continue;
        context.for_each_tile(
            fragments.size(),
            [&](Tile tile, int) {
                if (!overlap(tile, layer.reach)) return;
                call_step(context, steps_.disc, reference().disc, layer_.view(), coc_.view(), tile,
                          blurred_.view());
                call_step(context, steps_.over, reference().over, blurred_.view(), tile,
                          result_.view());
            },
            tile_side);
    }
    for (int y = 0; y < colour.height(); ++y) {
        for (int x = 0; x < colour.width(); ++x) {
            const Rgba& pixel = result_(x, y);
            colour(x, y) = pixel.a > 0 ? Rgb(pixel) / pixel.a : Rgb(pixel);
        }
    }
}

void Composite::classic(const Fragments& fragments, const Lens& lens, float cut, Context& context,
                        ImageView<Rgb> colour) {
    resize(fragments.size());
    const Size size = fragments.size();
    collect(fragments, lens, cut, infinite, context);
    std::copy(layer_.pixels().begin(), layer_.pixels().end(), result_.pixels().begin());
    Mean mean;
    for (std::size_t i = 0; i < coc_.pixels().size(); ++i) {
        if (layer_.pixels()[i].a > 0) mean.add(coc_.pixels()[i]);
    }
    // What comes nearest to a disc of diameter 1 when it is an edge that is blurred.
    constexpr float sigma_of_disc = 0.25f;
    const float sigma = sigma_of_disc * mean.value();
    const auto blur = [&](const Image<Rgba>& in, Axis axis, Image<Rgba>& out) {
        context.for_each_tile(
            size,
            [&](Tile tile, int) {
                call_step(context, steps_.gaussian, reference().gaussian, in.view(), sigma, axis,
                          tile, out.view());
            },
            tile_side);
    };
    blur(result_, Axis::x, blurred_);
    blur(blurred_, Axis::y, result_);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const bool sharp = fragments.depth()(x, y) < cut;
            layer_(x, y) = sharp ? Rgba(fragments.colour()(x, y), 1) : Rgba(0);
        }
    }
    context.for_each_tile(
        size,
        [&](Tile tile, int) {
            call_step(context, steps_.over, reference().over, layer_.view(), tile, result_.view());
        },
        tile_side);
    for (int y = 0; y < colour.height(); ++y) {
        for (int x = 0; x < colour.width(); ++x) colour(x, y) = Rgb(result_(x, y));
    }
}

}  // namespace luch::techniques::layered
