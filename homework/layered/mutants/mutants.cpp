// Mistakes that students make, by task: each is the reference with one step spoilt.
#include "homework/layered/check/others.h"

#include <cmath>
#include <limits>

namespace luch::homework::layered {
namespace {

using namespace techniques::layered;

constexpr float infinite = std::numeric_limits<float>::infinity();

bool is_sound(const Rgba& pixel) {
    return all_finite(pixel) && std::isfinite(pixel.a);
}

/// Calls work(x, y) for the pixels of a tile.
template <class Work>
void each_pixel(Tile tile, Work&& work) {
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) work(x, y);
    }
}

struct CutRules {
    bool in_depth = false, backwards = false, takes_all = false, one_short = false, no_sky = false;
};

template <CutRules rules>
void cut(std::span<const float> depths, int k, std::span<float> cuts) {
    double near = infinite, far = 0;
    for (const float z : depths) {
        if (!rules.takes_all && !(z > 0)) continue;
        if (rules.no_sky && z == infinite) continue;
        near = std::min(near, double(z));
        far = std::max(far, double(z));
    }
    const int parts = rules.one_short ? k + 1 : k;
    for (int i = 1; i < k; ++i) {
        const double way = double(i) / parts;
        const double at = rules.in_depth ? near + (far - near) * way
                                         : 1 / (1 / near + (1 / far - 1 / near) * way);
        const auto place = static_cast<std::size_t>(rules.backwards ? k - 1 - i : i - 1);
        cuts[place] = near <= far ? static_cast<float>(at) : infinite;
    }
}

struct CocRules {
    bool with_sign = false, other_sign = false, radius = false, forgets_z = false;
    bool no_limit = false, infinity_over_infinity = false;
};

template <CocRules rules>
void coc(ImageView<const float> z, const Lens& lens, Tile tile, ImageView<float> px) {
    const double size = (rules.radius ? 1 : 2) * lens.radius * lens.px_per_unit;
    each_pixel(tile, [&](int x, int y) {
        const double depth = z(x, y), focus = lens.focal_distance;
        double off = 1 / focus - 1 / depth;
        if (rules.forgets_z) off = (depth - focus) / (focus * focus);
        if (rules.infinity_over_infinity) off = (depth - focus) / (depth * focus);
        double diameter = size * std::abs(off);
        if (rules.with_sign) diameter = std::max(0.0, size * off);
        if (rules.other_sign) diameter = std::max(0.0, -size * off);
        if (!(depth > 0) && !rules.no_limit) diameter = lens.largest_px;
        if (!rules.no_limit) diameter = std::min(diameter, double(lens.largest_px));
        px(x, y) = static_cast<float>(diameter);
    });
}

struct GaussianRules {
    double reach = 3, width = 2;
    bool black_outside = false, other_axis = false, spreads_all = false, repeats_border = false;
    bool weighs_colours_only = false;
};

template <GaussianRules rules>
void gaussian(ImageView<const Rgba> in, float sigma, Axis axis, Tile tile, ImageView<Rgba> out) {
    const bool along_x = (axis == Axis::x) != rules.other_axis;
    const int length = along_x ? in.width() : in.height();
    const int radius =
        sigma > 0 ? int(std::min(std::ceil(rules.reach * sigma), double(length))) : 0;
    each_pixel(tile, [&](int x, int y) {
        out(x, y) = in(x, y);
        if (radius == 0 || (!rules.spreads_all && !is_sound(in(x, y)))) return;
        glm::dvec4 sum(0);
        double whole = 0;
        const int at = along_x ? x : y;
        for (int i = at - radius; i <= at + radius; ++i) {
            const double off = (i - at) / double(sigma);
            const double weight = std::exp(-off * off / rules.width);
            const bool inside = i >= 0 && i < length;
            if (inside || rules.black_outside) whole += weight;
            if (!inside && !rules.repeats_border) continue;
            const int j = std::clamp(i, 0, length - 1);
            const Rgba& there = along_x ? in(j, y) : in(x, j);
            if (!rules.spreads_all && !is_sound(there)) {
                whole -= weight;
                continue;
            }
            if (!inside) whole += weight;
            sum += weight * glm::dvec4(there);
        }
        out(x, y) = Rgba(sum / whole);
        if (rules.weighs_colours_only) out(x, y).a = in(x, y).a;
    });
}

struct DiscRules {
    enum Share { even, bright_middle, whole } share = even;
    bool receivers_size = false, square = false, diameter_as_radius = false;
    bool not_divided = false, counts_covered = false, spreads_all = false;
};

double count_within(double radius, bool square) {
    const int reach = static_cast<int>(radius);
    if (square) return (2.0 * reach + 1) * (2 * reach + 1);
    double count = 0;
    for (int y = -reach; y <= reach; ++y) {
        for (int x = -reach; x <= reach; ++x) count += x * x + y * y <= radius * radius;
    }
    return count;
}

/// What a disc of that radius hands to a pixel that is `off` away.
template <DiscRules rules>
double share(double radius, double off) {
    switch (rules.share) {
        case DiscRules::even:
            return 1 / count_within(radius, rules.square);
        case DiscRules::bright_middle:  // the radius drawn evenly, not the area
            return 1 / (6.2832 * radius * std::max(off, 0.5));
        case DiscRules::whole:
            return 1;
    }
    return 0;
}

template <DiscRules rules>
void disc(ImageView<const Rgba> in, ImageView<const float> coc, Tile tile, ImageView<Rgba> out) {
    const auto radius_of = [&](int x, int y) {
        return std::max(double(coc(x, y)) * (rules.diameter_as_radius ? 1 : 0.5), 0.5);
    };
    double widest = 0;
    each_pixel(in.tile(), [&](int x, int y) { widest = std::max(widest, radius_of(x, y)); });
    const int reach = static_cast<int>(std::min(widest, double(in.width() + in.height())));
    each_pixel(tile, [&](int x, int y) {
        out(x, y) = in(x, y);
        if (!rules.spreads_all && !is_sound(in(x, y))) return;
        glm::dvec4 sum(0);
        double whole = 0;
        const Tile near{std::max(x - reach, 0), std::max(y - reach, 0),
                        std::min(x + reach + 1, in.width()), std::min(y + reach + 1, in.height())};
        each_pixel(near, [&](int i, int j) {
            if (!rules.spreads_all && !is_sound(in(i, j))) return;
            const double radius = rules.receivers_size ? radius_of(x, y) : radius_of(i, j);
            const int across = std::abs(i - x), down = std::abs(j - y);
            const bool within = rules.square ? std::max(across, down) <= radius
                                             : across * across + down * down <= radius * radius;
            if (!within) return;
            const double weight = share<rules>(radius, std::hypot(across, down));
            sum += weight * glm::dvec4(in(i, j));
            whole += rules.counts_covered ? weight * in(i, j).a : weight;
        });
        if (rules.not_divided) whole = 1;
        out(x, y) = whole > 0 ? Rgba(sum / whole) : in(x, y);
    });
}

struct OverRules {
    bool straight = false, back_in_front = false, added = false, keeps_alpha = false;
    bool halves = false, not_guarded = false;
};

template <OverRules rules>
void over(ImageView<const Rgba> front, Tile tile, ImageView<Rgba> back) {
    each_pixel(tile, [&](int x, int y) {
        const Rgba behind = rules.back_in_front ? front(x, y) : back(x, y);
        Rgba before = rules.back_in_front ? back(x, y) : front(x, y);
        float through = 1 - before.a;
        if (rules.straight) before = Rgba(Rgb(before) * before.a, before.a);
        if (rules.added) through = 1;
        if (rules.halves) through = before.a > 0.5f ? 0 : 1;
        Rgba result = through > 0 || rules.not_guarded ? before + through * behind : before;
        if (rules.keeps_alpha) result.a = before.a;
        back(x, y) = result;
    });
}

}  // namespace

std::vector<grading::Other> mutants() {
    return {
        {"equal_in_depth", "layered.t1", "layers are equally thick in z: divide 1/z instead",
         with(&Steps::cut, cut<CutRules{.in_depth = true}>)},
        {"far_to_near", "layered.t1", "the order of the layers is turned round: near comes first",
         with(&Steps::cut, cut<CutRules{.backwards = true}>)},
        {"takes_every_depth", "layered.t1", "depths that are not > 0 are counted",
         with(&Steps::cut, cut<CutRules{.takes_all = true}>)},
        {"one_layer_short", "layered.t1", "k cuts make k + 1 layers: divide by k",
         with(&Steps::cut, cut<CutRules{.one_short = true}>)},
        {"no_sky", "layered.t1", "the sky does not count; its 1/z is 0",
         with(&Steps::cut, cut<CutRules{.no_sky = true}>)},

        {"coc_sign", "layered.t2",
         "in front of the focus the sign is lost: take the absolute value",
         with(&Steps::coc, coc<CocRules{.with_sign = true}>)},
        {"coc_other_sign", "layered.t2", "only what is in front of the focus is blurred",
         with(&Steps::coc, coc<CocRules{.other_sign = true}>)},
        {"radius_for_diameter", "layered.t2", "the radius, not the diameter",
         with(&Steps::coc, coc<CocRules{.radius = true}>)},
        {"forgets_z", "layered.t2", "divided by z_f² instead of z·z_f",
         with(&Steps::coc, coc<CocRules{.forgets_z = true}>)},
        {"no_limit", "layered.t2", "no limit at the lens: largest_px",
         with(&Steps::coc, coc<CocRules{.no_limit = true}>)},
        {"infinity_over_infinity", "layered.t2", "∞/∞ at the sky: use |1/z_f − 1/z|",
         with(&Steps::coc, coc<CocRules{.infinity_over_infinity = true}>)},

        {"black_outside", "layered.t3", "black outside the picture: divide by the weights inside",
         with(&Steps::gaussian, gaussian<GaussianRules{.black_outside = true}>)},
        {"repeats_border", "layered.t3", "the border is repeated outside: leave it out",
         with(&Steps::gaussian, gaussian<GaussianRules{.repeats_border = true}>)},
        {"ends_at_sigma", "layered.t3", "the kernel ends at σ instead of 3σ",
         with(&Steps::gaussian, gaussian<GaussianRules{.reach = 1}>)},
        {"sigma_squared", "layered.t3", "exp(−i²/σ²): the 2 is missing",
         with(&Steps::gaussian, gaussian<GaussianRules{.width = 1}>)},
        {"other_axis", "layered.t3", "the axes are swapped",
         with(&Steps::gaussian, gaussian<GaussianRules{.other_axis = true}>)},
        {"sharp_coverage", "layered.t3", "coverage is not blurred with the colours",
         with(&Steps::gaussian, gaussian<GaussianRules{.weighs_colours_only = true}>)},
        {"gaussian_spreads_all", "layered.t3", "a pixel that is not finite is spread",
         with(&Steps::gaussian, gaussian<GaussianRules{.spreads_all = true}>)},

        {"disc_r_u", "layered.t4", "the radius is drawn evenly (r = u): the middle is too bright",
         with(&Steps::disc, disc<DiscRules{.share = DiscRules::bright_middle}>)},
        {"background_bleeds", "layered.t4",
         "the size of the receiver's circle is used: what is sharp bleeds into what is blurred",
         with(&Steps::disc, disc<DiscRules{.receivers_size = true}>)},
        {"energy_grows", "layered.t4", "every pixel hands out its whole colour: divide by n",
         with(&Steps::disc, disc<DiscRules{.share = DiscRules::whole}>)},
        {"dark_border", "layered.t4", "not divided by the weights received: borders darken",
         with(&Steps::disc, disc<DiscRules{.not_divided = true}>)},
        {"only_what_is_covered", "layered.t4", "divided by coverage: layers lose their soft edges",
         with(&Steps::disc, disc<DiscRules{.counts_covered = true}>)},
        {"square_kernel", "layered.t4", "a square instead of a disc",
         with(&Steps::disc, disc<DiscRules{.square = true}>)},
        {"diameter_as_radius", "layered.t4", "coc is a diameter: halve it",
         with(&Steps::disc, disc<DiscRules{.diameter_as_radius = true}>)},
        {"disc_spreads_all", "layered.t4", "a pixel that is not finite is handed out",
         with(&Steps::disc, disc<DiscRules{.spreads_all = true}>)},

        {"straight_alpha", "layered.t5", "front is multiplied by its coverage once more",
         with(&Steps::over, over<OverRules{.straight = true}>)},
        {"layer_order", "layered.t5", "the layers have changed places: the back covers the front",
         with(&Steps::over, over<OverRules{.back_in_front = true}>)},
        {"added", "layered.t5", "the layers are added: the back must be dimmed by 1 − front.a",
         with(&Steps::over, over<OverRules{.added = true}>)},
        {"coverage_lost", "layered.t5", "the result's coverage is the front's: it is composed, too",
         with(&Steps::over, over<OverRules{.keeps_alpha = true}>)},
        {"all_or_nothing", "layered.t5", "half covered is taken for covered",
         with(&Steps::over, over<OverRules{.halves = true}>)},
        {"infinity_shines_through", "layered.t5", "0·∞ behind full coverage",
         with(&Steps::over, over<OverRules{.not_guarded = true}>)},
    };
}

}  // namespace luch::homework::layered
