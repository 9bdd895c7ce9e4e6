#include "homework/layered/check/others.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace luch::homework::layered {
namespace {

using namespace techniques::layered;

constexpr float infinite = std::numeric_limits<float>::infinity();

bool is_sound(const Rgba& pixel) {
    return std::isfinite(pixel.r) && std::isfinite(pixel.g) && std::isfinite(pixel.b) &&
           std::isfinite(pixel.a);
}

/// By sorting, in float, one cut after the other added up.
void cut_by_sorting(std::span<const float> depths, int k, std::span<float> cuts) {
    std::vector<float> sorted;
    for (const float z : depths) {
        if (z > 0) sorted.push_back(1 / z);
    }
    std::sort(sorted.begin(), sorted.end());
    float inverse = sorted.empty() ? 0 : sorted.back();
    const float step = sorted.empty() ? 0 : (sorted.back() - sorted.front()) / float(k);
    for (float& each : cuts) {
        inverse -= step;
        each = inverse > 0 ? 1 / inverse : infinite;
    }
}

/// From the far end.
void cut_from_afar(std::span<const float> depths, int k, std::span<float> cuts) {
    std::vector<float> turned(depths.rbegin(), depths.rend());
    reference().cut(turned, k, cuts);
}

/// In float; the sky and the lens are cases of their own.
void coc_by_cases(ImageView<const float> z, const Lens& lens, Tile tile, ImageView<float> px) {
    const auto size = static_cast<float>(2 * lens.radius * lens.px_per_unit);
    const auto focus = static_cast<float>(lens.focal_distance);
    for (int x = tile.x0; x < tile.x1; ++x) {
        for (int y = tile.y0; y < tile.y1; ++y) {
            const float depth = z(x, y);
            if (!(depth > 0)) {
                px(x, y) = lens.largest_px;
            } else if (depth == infinite) {
                px(x, y) = std::min(size / focus, lens.largest_px);
            } else {
                px(x, y) =
                    std::min(size * std::abs(depth - focus) / depth / focus, lens.largest_px);
            }
        }
    }
}

/// |1 − z_f/z| of the circle at infinity.
void coc_of_the_sky(ImageView<const float> z, const Lens& lens, Tile tile, ImageView<float> px) {
    const double sky = 2 * lens.radius / lens.focal_distance * lens.px_per_unit;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            const double share = z(x, y) > 0 ? std::abs(1 - lens.focal_distance / z(x, y)) : 1e30;
            px(x, y) = static_cast<float>(std::min(sky * share, double(lens.largest_px)));
        }
    }
}

/// In float, from the right to the left, with weights made anew each time.
void gaussian_in_float(ImageView<const Rgba> in, float sigma, Axis axis, Tile tile,
                       ImageView<Rgba> out) {
    const int length = axis == Axis::x ? in.width() : in.height();
    const float reach = sigma > 0 ? std::min(std::ceil(3 * sigma), float(length)) : 0;
    const int radius = static_cast<int>(reach);
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            out(x, y) = in(x, y);
            if (radius == 0 || !is_sound(in(x, y))) continue;
            Rgba sum(0);
            float whole = 0;
            for (int i = radius; i >= -radius; --i) {
                const int j = (axis == Axis::x ? x : y) + i;
                if (j < 0 || j >= length) continue;
                const Rgba there = axis == Axis::x ? in(j, y) : in(x, j);
                if (!is_sound(there)) continue;
                const float off = float(i) / sigma, weight = std::exp(-off * off / 2);
                sum += weight * there;
                whole += weight;
            }
            out(x, y) = sum / whole;
        }
    }
}

/// On a picture that is turned over, one row or column at a time.
void gaussian_of_turned(ImageView<const Rgba> in, float sigma, Axis axis, Tile tile,
                        ImageView<Rgba> out) {
    Image<Rgba> turned({in.height(), in.width()}), blurred(turned.size());
    for (int y = 0; y < in.height(); ++y) {
        for (int x = 0; x < in.width(); ++x) turned(y, x) = in(x, y);
    }
    reference().gaussian(turned.view(), sigma, axis == Axis::x ? Axis::y : Axis::x,
                         turned.view().tile(), blurred.view());
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) out(x, y) = blurred(y, x);
    }
}

/// Weights divided by their sum first, where the whole kernel is inside.
void gaussian_normalised_first(ImageView<const Rgba> in, float sigma, Axis axis, Tile tile,
                               ImageView<Rgba> out) {
    reference().gaussian(in, sigma, axis, tile, out);
    if (!(sigma > 0.2f) || sigma > 100) return;
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    std::vector<float> weights;
    float whole = 0;
    for (int i = -radius; i <= radius; ++i) {
        weights.push_back(std::exp(-0.5f * float(i * i) / (sigma * sigma)));
        whole += weights.back();
    }
    for (float& weight : weights) weight /= whole;
    const int length = axis == Axis::x ? in.width() : in.height();
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            const int at = axis == Axis::x ? x : y;
            if (at < radius || at + radius >= length) continue;
            Rgba sum(0);
            bool sound = true;
            for (int i = -radius; i <= radius; ++i) {
                const Rgba& there = axis == Axis::x ? in(x + i, y) : in(x, y + i);
                sound = sound && is_sound(there);
                sum += weights[static_cast<std::size_t>(i + radius)] * there;
            }
            if (sound) out(x, y) = sum;
        }
    }
}

/// Every pixel of the picture hands out, and only what falls into the tile is kept.
template <class Real, bool by_columns>
void disc_hands_out(ImageView<const Rgba> in, ImageView<const float> coc, Tile tile,
                    ImageView<Rgba> out) {
    using Sum = glm::vec<4, Real>;
    const Size size{tile.width(), tile.height()};
    Image<Sum> sums(size, Sum(0));
    Image<Real> whole(size, Real(0));
    const int outer = by_columns ? in.width() : in.height();
    const int inner = by_columns ? in.height() : in.width();
    for (int a = 0; a < outer; ++a) {
        for (int b = 0; b < inner; ++b) {
            const int x = by_columns ? a : b, y = by_columns ? b : a;
            if (!is_sound(in(x, y))) continue;
            const float radius = std::max(coc(x, y) / 2, 0.5f);
            const int reach = static_cast<int>(radius);
            int n = 0;
            for (int j = -reach; j <= reach; ++j) {
                for (int i = -reach; i <= reach; ++i) n += float(i * i + j * j) <= radius * radius;
            }
            for (int j = std::max(y - reach, tile.y0); j <= std::min(y + reach, tile.y1 - 1); ++j) {
                for (int i = std::max(x - reach, tile.x0); i <= std::min(x + reach, tile.x1 - 1);
                     ++i) {
                    const int off = (i - x) * (i - x) + (j - y) * (j - y);
                    if (float(off) > radius * radius) continue;
                    sums(i - tile.x0, j - tile.y0) += Sum(in(x, y)) / Real(n);
                    whole(i - tile.x0, j - tile.y0) += Real(1) / Real(n);
                }
            }
        }
    }
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            const Real all = whole(x - tile.x0, y - tile.y0);
            out(x, y) = is_sound(in(x, y)) ? Rgba(sums(x - tile.x0, y - tile.y0) / all) : in(x, y);
        }
    }
}

/// Collects from the bottom right, and looks at every pixel of the picture.
void disc_looks_everywhere(ImageView<const Rgba> in, ImageView<const float> coc, Tile tile,
                           ImageView<Rgba> out) {
    Image<double> share(in.size());
    for (int y = 0; y < in.height(); ++y) {
        for (int x = 0; x < in.width(); ++x) {
            const double radius = std::max(coc(x, y) / 2, 0.5f);
            double n = 0;
            for (int j = -int(radius); j <= int(radius); ++j) {
                n += 2 * std::floor(std::sqrt(radius * radius - j * j)) + 1;
            }
            share(x, y) = is_sound(in(x, y)) ? 1 / n : 0;
        }
    }
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            glm::dvec4 sum(0);
            double whole = 0;
            for (int j = in.height() - 1; j >= 0; --j) {
                for (int i = in.width() - 1; i >= 0; --i) {
                    const double off = std::hypot(i - x, j - y);
                    if (off > std::max(coc(i, j) / 2, 0.5f) || share(i, j) == 0) continue;
                    sum += share(i, j) * glm::dvec4(in(i, j));
                    whole += share(i, j);
                }
            }
            out(x, y) = is_sound(in(x, y)) ? Rgba(sum / whole) : in(x, y);
        }
    }
}

/// In double, channel by channel.
void over_in_double(ImageView<const Rgba> front, Tile tile, ImageView<Rgba> back) {
    for (int x = tile.x0; x < tile.x1; ++x) {
        for (int y = tile.y0; y < tile.y1; ++y) {
            const double through = 1 - double(front(x, y).a);
            for (int k = 0; k < 4; ++k) {
                const double behind = through == 0 ? 0 : through * back(x, y)[k];
                back(x, y)[k] = static_cast<float>(front(x, y)[k] + behind);
            }
        }
    }
}

/// back − front.a·back, which rounds elsewhere.
void over_by_taking_away(ImageView<const Rgba> front, Tile tile, ImageView<Rgba> back) {
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            const Rgba& before = front(x, y);
            const Rgba behind = back(x, y);
            back(x, y) = before.a >= 1 ? before : before + (behind - before.a * behind);
        }
    }
}

}  // namespace

std::vector<grading::Other> variants() {
    return {
        {"reference", "", "the reference itself", reference()},
        {"cut_by_sorting", "layered.t1", "sorted, in float, step by step",
         with(&Steps::cut, cut_by_sorting)},
        {"cut_from_afar", "layered.t1", "the last depth first", with(&Steps::cut, cut_from_afar)},
        {"coc_by_cases", "layered.t2", "in float, the sky a case of its own",
         with(&Steps::coc, coc_by_cases)},
        {"coc_of_the_sky", "layered.t2", "a share of the circle at infinity",
         with(&Steps::coc, coc_of_the_sky)},
        {"gaussian_in_float", "layered.t3", "in float, from the right",
         with(&Steps::gaussian, gaussian_in_float)},
        {"gaussian_of_turned", "layered.t3", "rows and columns changed",
         with(&Steps::gaussian, gaussian_of_turned)},
        {"gaussian_normalised_first", "layered.t3", "a kernel of sum 1 where all of it is inside",
         with(&Steps::gaussian, gaussian_normalised_first)},
        {"disc_hands_out", "layered.t4", "handing out instead of collecting",
         with(&Steps::disc, disc_hands_out<double, false>)},
        {"disc_hands_out_in_float", "layered.t4", "in float, by columns",
         with(&Steps::disc, disc_hands_out<float, true>)},
        {"disc_looks_everywhere", "layered.t4", "all pixels, the last first",
         with(&Steps::disc, disc_looks_everywhere)},
        {"over_in_double", "layered.t5", "in double, by columns",
         with(&Steps::over, over_in_double)},
        {"over_by_taking_away", "layered.t5", "rounded elsewhere",
         with(&Steps::over, over_by_taking_away)},
    };
}

}  // namespace luch::homework::layered
