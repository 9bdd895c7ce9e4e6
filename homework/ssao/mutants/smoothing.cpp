// Mistakes with blurring, upsampling and light, tasks t5 to t7.
#include "homework/ssao/mutants/more.h"
#include "techniques/ssao/view.h"

#include <cmath>

namespace luch::homework::ssao {
namespace {

using namespace techniques::ssao;

struct BlurRules {
    bool across_edges = false, not_divided = false, one_short = false, takes_sky = false;
    bool takes_nan = false, other_axis = false, sigma = false, others_plane = false,
         all_or_nothing = false;
    bool by_depth = false;
};

template <BlurRules rules>
float weight_of(const GBuffer& seen, const Blur& blur, int x, int y, int u, int v, int i) {
    const float width = rules.sigma ? 1 : 2;
    float weight = std::exp(-static_cast<float>(i * i) / (width * blur.sigma_px * blur.sigma_px));
    if (rules.across_edges) return weight;
    float off = rules.others_plane ? off_plane(seen, u, v, seen.position(x, y))
                                   : off_plane(seen, x, y, seen.position(u, v));
    if (rules.by_depth) off = std::abs(seen.position(u, v).z - seen.position(x, y).z);
    if (rules.all_or_nothing) return off < blur.tolerance ? weight : 0;
    return weight * nearness(off, blur.tolerance);
}

template <BlurRules rules>
void blur(ImageView<const float> in, const GBuffer& seen, const Blur& blur, Axis axis, Tile tile,
          ImageView<float> out) {
    const bool along_x = (axis == Axis::x) != rules.other_axis;
    const int reach = rules.one_short ? blur.reach_px - 1 : blur.reach_px;
    const auto counts = [&](int x, int y) {
        return (rules.takes_sky || is_seen(seen.position(x, y))) &&
               (rules.takes_nan || std::isfinite(in(x, y)));
    };
    each_pixel(tile, [&](int x, int y) {
        out(x, y) = in(x, y);
        if (!counts(x, y)) return;
        float sum = 0, whole = 0, all = 0;
        for (int i = -reach; i <= reach; ++i) {
            const int u = along_x ? x + i : x, v = along_x ? y : y + i;
            all += std::exp(-static_cast<float>(i * i) / (2 * blur.sigma_px * blur.sigma_px));
            if (u < 0 || v < 0 || u >= in.width() || v >= in.height() || !counts(u, v)) continue;
            const float weight = rules.takes_sky && !is_seen(seen.position(u, v))
                                     ? 1
                                     : weight_of<rules>(seen, blur, x, y, u, v, i);
            sum += weight * in(u, v);
            whole += weight;
        }
        out(x, y) = sum / (rules.not_divided ? all : whole);
    });
}

struct UpRules {
    bool nearest = false, bilinear = false, half_pixel = false, not_divided = false,
         no_rescue = false;
};

template <UpRules rules>
void upsample(ImageView<const float> in, const GBuffer& coarse, const GBuffer& fine,
              float tolerance, Tile tile, ImageView<float> out) {
    each_pixel(tile, [&](int x, int y) {
        out(x, y) = 0;
        if (!is_seen(fine.position(x, y))) return;
        float sum = 0, whole = 0, least = std::numeric_limits<float>::infinity();
        int count = 0;
        const int x1 = rules.nearest ? x / 2 : (x + 1) / 2 + (rules.half_pixel ? 1 : 0);
        const int y1 = rules.nearest ? y / 2 : (y + 1) / 2 + (rules.half_pixel ? 1 : 0);
        for (int j = y / 2; j <= std::min(y1, in.height() - 1); ++j) {
            for (int i = x / 2; i <= std::min(x1, in.width() - 1); ++i) {
                if (!is_seen(coarse.position(i, j))) continue;
                const float off = off_plane(fine, x, y, coarse.position(i, j));
                const float weight = rules.bilinear || rules.nearest ? 1 : nearness(off, tolerance);
                if (off < least && !rules.no_rescue && !(whole > 0)) out(x, y) = in(i, j);
                least = std::min(least, off);
                sum += weight * in(i, j);
                whole += weight;
                ++count;
            }
        }
        if (whole > 0) out(x, y) = sum / (rules.not_divided ? float(count) : whole);
    });
}

struct LightRules {
    bool grey = false, occlusion = false, squared = false, white = false;
};

template <LightRules rules>
void apply(ImageView<const float> visibility, const Rgb& ambient, Tile tile, ImageView<Rgb> light) {
    each_pixel(tile, [&](int x, int y) {
        float share = visibility(x, y);
        if (rules.occlusion) share = 1 - share;
        if (rules.squared) share *= share;
        const Rgb colour = rules.white ? Rgb(1) : rules.grey ? Rgb(ambient.g) : ambient;
        light(x, y) = share * colour;
    });
}

}  // namespace

std::vector<grading::Other> smoothing_mutants() {
    return {
        {"across_edges", "ssao.t5", "blurred across edges: the tolerance is not used",
         with(&Steps::blur, blur<BlurRules{.across_edges = true}>)},
        {"unnormalised", "ssao.t5", "divided by the gaussian's sum: divide by the weights used",
         with(&Steps::blur, blur<BlurRules{.not_divided = true}>)},
        {"reach_minus_1", "ssao.t5", "one neighbour too few to each side",
         with(&Steps::blur, blur<BlurRules{.one_short = true}>)},
        {"blurred_sky", "ssao.t5", "the sky counts: it has no occlusion",
         with(&Steps::blur, blur<BlurRules{.takes_sky = true}>)},
        {"spreads_nan", "ssao.t5", "a pixel that is not finite is spread",
         with(&Steps::blur, blur<BlurRules{.takes_nan = true}>)},
        {"other_axis", "ssao.t5", "the axes are swapped",
         with(&Steps::blur, blur<BlurRules{.other_axis = true}>)},
        {"sigma_squared", "ssao.t5", "exp(−i²/σ²): the 2 is missing",
         with(&Steps::blur, blur<BlurRules{.sigma = true}>)},
        {"by_depth", "ssao.t5", "differences of depth: a tilted floor is full of edges",
         with(&Steps::blur, blur<BlurRules{.by_depth = true}>)},
        {"all_or_nothing", "ssao.t5", "within the tolerance all count alike: weight by nearness",
         with(&Steps::blur, blur<BlurRules{.all_or_nothing = true}>)},

        {"nearest_only", "ssao.t6", "one pixel of the small picture: blocks of 2 × 2",
         with(&Steps::upsample, upsample<UpRules{.nearest = true}>)},
        {"bilinear_only", "ssao.t6", "bilinear: it bleeds over edges",
         with(&Steps::upsample, upsample<UpRules{.bilinear = true}>)},
        {"one_pixel_more", "ssao.t6", "neighbours that are too far: (i, j) stands at (2i, 2j)",
         with(&Steps::upsample, upsample<UpRules{.half_pixel = true}>)},
        {"mean_of_the_count", "ssao.t6", "divided by the number of pixels: divide by the weights",
         with(&Steps::upsample, upsample<UpRules{.not_divided = true}>)},
        {"holes", "ssao.t6", "0 where all weights are 0: take the smallest e",
         with(&Steps::upsample, upsample<UpRules{.no_rescue = true}>)},

        {"grey_ambient", "ssao.t7", "ambient light has a colour",
         with(&Steps::apply, apply<LightRules{.grey = true}>)},
        {"occlusion_for_visibility", "ssao.t7", "1 − visibility: corners shine",
         with(&Steps::apply, apply<LightRules{.occlusion = true}>)},
        {"squared", "ssao.t7", "multiplied twice: no ad-hoc power",
         with(&Steps::apply, apply<LightRules{.squared = true}>)},
        {"white_ambient", "ssao.t7", "the ambient light is not multiplied in",
         with(&Steps::apply, apply<LightRules{.white = true}>)},
    };
}

}  // namespace luch::homework::ssao
