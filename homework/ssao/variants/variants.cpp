#include "homework/ssao/check/others.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace luch::homework::ssao {
namespace {

using namespace techniques::ssao;

constexpr float infinite = std::numeric_limits<float>::infinity();

/// By the frame's ray, stretched to the depth.
void positions_by_rays(ImageView<const float> z, const Screen& screen, Tile tile,
                       ImageView<Vec3> position) {
    for (int x = tile.x0; x < tile.x1; ++x) {
        for (int y = tile.y0; y < tile.y1; ++y) {
            position(x, y) = {0, 0, infinite};
            if (!(z(x, y) > 0) || std::isinf(z(x, y))) continue;
            const Vec3d ahead =
                screen.to_view(screen.eye() + screen.ray(x + 0.5, y + 0.5).direction);
            position(x, y) = Vec3(ahead * (z(x, y) / ahead.z));
        }
    }
}

void positions_in_float(ImageView<const float> z, const Screen& screen, Tile tile,
                        ImageView<Vec3> position) {
    const auto width = static_cast<float>(screen.half_width()),
               height = static_cast<float>(screen.half_height());
    for (int y = tile.y1 - 1; y >= tile.y0; --y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            const float depth = z(x, y);
            const float across = (2 * static_cast<float>(x) + 1) / float(z.width()) - 1;
            const float upwards = 1 - (2 * static_cast<float>(y) + 1) / float(z.height());
            position(x, y) = depth > 0 && depth < infinite
                                 ? Vec3(across * width * depth, upwards * height * depth, depth)
                                 : Vec3(0, 0, infinite);
        }
    }
}

/// The neighbour that is nearest in depth, or the one that is nearest at all.
template <bool by_depth>
void normals_by_the_nearest(ImageView<const Vec3> position, Tile tile, ImageView<Vec3> normal) {
    const auto step = [&](int x, int y, int dx, int dy) {
        Vec3 best(0);
        float least = infinite;
        for (const int side : {-1, 1}) {
            const int u = x + side * dx, v = y + side * dy;
            if (u < 0 || v < 0 || u >= position.width() || v >= position.height()) continue;
            if (!is_seen(position(u, v))) continue;
            const Vec3 way = position(u, v) - position(x, y);
            const float off = by_depth ? std::abs(way.z) : glm::dot(way, way);
            if (!(off < least)) continue;
            least = off;
            best = float(side) * way;
        }
        return best;
    };
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            normal(x, y) = Vec3(0);
            if (!is_seen(position(x, y))) continue;
            const Vec3 n = glm::cross(step(x, y, 0, 1), step(x, y, 1, 0));
            const float length = glm::length(n);
            const Vec3 to_eye = -position(x, y) / glm::length(position(x, y));
            normal(x, y) = length > 0 ? n / length : to_eye;
            if (glm::dot(normal(x, y), to_eye) < 0) normal(x, y) *= -1.0f;
        }
    }
}

/// Independent points, near ones more often.
void kernel_of_chance(Key key, std::span<Vec3> points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Key own = key.branch(i);
        const double turn = 2 * std::numbers::pi * own.uniform(1), u = own.uniform(2);
        const double scale = 0.1 + 0.9 * own.uniform(3) * own.uniform(3);
        points[i] = Vec3(scale * Vec3d(std::sqrt(u) * std::cos(turn), std::sqrt(u) * std::sin(turn),
                                       std::sqrt(1 - u)));
    }
}

/// A point of the unit sphere around the top of the normal; some tries are thrown away.
void kernel_by_rejection(Key key, std::span<Vec3> points) {
    std::uint64_t drawn = 0;
    const auto between = [&] { return 2 * key.uniform(drawn++) - 1; };
    for (Vec3& point : points) {
        Vec3d ball(2);
        while (glm::dot(ball, ball) > 1 || glm::dot(ball, ball) < 1e-6) {
            ball = {between(), between(), between()};
        }
        Vec3d direction = glm::normalize(ball) + Vec3d(0, 0, 1);
        if (glm::length(direction) < 1e-9) direction = {0, 0, 1};
        direction = glm::normalize(direction);
        direction.z = std::max(direction.z, 0.0);
        point = Vec3(direction * std::cbrt(1 - key.uniform(drawn++)));
    }
}

struct Turned {
    bool by_chance = false, in_double = false;
};

template <Turned how>
void occlusion(const GBuffer& seen, const Screen& screen, std::span<const Vec3> kernel,
               const Params& params, Key key, Tile tile, ImageView<float> occluded) {
    using Real = std::conditional_t<how.in_double, double, float>;
    using Vector = glm::vec<3, Real>;
    const auto radius = static_cast<Real>(params.radius);
    const double px = std::max(screen.size().width / screen.half_width(),
                               screen.size().height / screen.half_height()) /
                      2;
    for (int x = tile.x0; x < tile.x1; ++x) {
        for (int y = tile.y0; y < tile.y1; ++y) {
            occluded(x, y) = 0;
            if (!is_seen(seen.position(x, y))) continue;
            const Vector here(seen.position(x, y));
            if (!(params.radius / here.z * px >= 1)) continue;
            Vector n(seen.normal(x, y));
            const Vector eye = -glm::normalize(here);
            if (glm::dot(n, eye) < 0) n -= glm::dot(n, eye) * eye;
            if (!(glm::length(n) > Real(1e-6))) continue;
            n = glm::normalize(n);
            // Another basis than the reference's, another order of the turns.
            const Vector across = glm::normalize(
                glm::cross(n, std::abs(n.z) < Real(0.9) ? Vector(0, 0, 1) : Vector(1, 0, 0)));
            const Vector up = glm::cross(across, n);
            const double own = how.by_chance
                                   ? key.branch(std::uint64_t(y)).uniform(std::uint64_t(x))
                                   : (y % 4 * 4 + (x + 3) % 4 + 16 * key.uniform(3)) / 16;
            const Real c = Real(std::cos(2 * std::numbers::pi * own)),
                       s = Real(std::sin(2 * std::numbers::pi * own));
            int all = 0, hidden = 0;
            for (std::size_t i = kernel.size(); i-- > 0;) {
                const Vector k(kernel[i]);
                const Vector p = here + radius * ((c * k.x - s * k.y) * across +
                                                  (s * k.x + c * k.y) * up + k.z * n);
                const auto at = screen.project(Vec3d(p));
                if (!at || at->x < 0 || at->y < 0 || at->x >= occluded.width() ||
                    at->y >= occluded.height()) {
                    continue;
                }
                ++all;
                const Vec3& surface = seen.position(int(at->x), int(at->y));
                if (!is_seen(surface)) continue;
                const Vector way = Vector(surface) - here;
                const Real distance = glm::length(way), height = glm::dot(way, n);
                if (surface.z < p.z && distance <= radius && height > least_sine * distance &&
                    height > Real(4e-6) * here.z) {
                    ++hidden;
                }
            }
            if (all > 0) occluded(x, y) = float(hidden) / float(all);
        }
    }
}

/// In double, from the far side; the weights of a row at once.
void blur_in_double(ImageView<const float> in, const GBuffer& seen, const Blur& blur, Axis axis,
                    Tile tile, ImageView<float> out) {
    const int dx = axis == Axis::x ? 1 : 0, dy = 1 - dx;
    for (int x = tile.x0; x < tile.x1; ++x) {
        for (int y = tile.y0; y < tile.y1; ++y) {
            out(x, y) = in(x, y);
            if (!is_seen(seen.position(x, y)) || !std::isfinite(in(x, y))) continue;
            double sum = 0, whole = 0;
            for (int i = blur.reach_px; i >= -blur.reach_px; --i) {
                const int u = x + i * dx, v = y + i * dy;
                if (u < 0 || v < 0 || u >= in.width() || v >= in.height()) continue;
                if (!is_seen(seen.position(u, v)) || !std::isfinite(in(u, v))) continue;
                const Vec3d way = Vec3d(seen.position(u, v)) - Vec3d(seen.position(x, y));
                const double off = std::abs(glm::dot(Vec3d(seen.normal(x, y)), way));
                const double off_centre = i / double(blur.sigma_px);
                const double weight = std::exp(-0.5 * off_centre * off_centre) *
                                      std::max(0.0, 1 - off / double(blur.tolerance));
                sum += weight * in(u, v);
                whole += weight;
            }
            out(x, y) = static_cast<float>(sum / whole);
        }
    }
}

/// The differences to the pixel itself are added up.
void blur_by_differences(ImageView<const float> in, const GBuffer& seen, const Blur& blur,
                         Axis axis, Tile tile, ImageView<float> out) {
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            const float own = in(x, y);
            out(x, y) = own;
            if (!is_seen(seen.position(x, y)) || !std::isfinite(own)) continue;
            float more = 0, whole = 1;
            for (int i = 1; i <= blur.reach_px; ++i) {
                for (const int side : {-i, i}) {
                    const int u = axis == Axis::x ? x + side : x,
                              v = axis == Axis::x ? y : y + side;
                    if (u < 0 || v < 0 || u >= in.width() || v >= in.height()) continue;
                    if (!is_seen(seen.position(u, v)) || !std::isfinite(in(u, v))) continue;
                    const float off = std::abs(
                        glm::dot(seen.normal(x, y), seen.position(u, v) - seen.position(x, y)));
                    const float near = off < blur.tolerance ? 1 - off / blur.tolerance : 0;
                    const float weight =
                        near * std::pow(std::exp(-0.5f / (blur.sigma_px * blur.sigma_px)),
                                        static_cast<float>(i * i));
                    more += weight * (in(u, v) - own);
                    whole += weight;
                }
            }
            out(x, y) = own + more / whole;
        }
    }
}

/// Gathers first, decides then; in double.
void upsample_by_lists(ImageView<const float> in, const GBuffer& coarse, const GBuffer& fine,
                       float tolerance, Tile tile, ImageView<float> out) {
    for (int x = tile.x0; x < tile.x1; ++x) {
        for (int y = tile.y0; y < tile.y1; ++y) {
            std::vector<std::pair<double, double>> near;  // e, value
            for (int i = 0; i < (x % 2 == 0 ? 1 : 2); ++i) {
                for (int j = 0; j < (y % 2 == 0 ? 1 : 2); ++j) {
                    const int u = x / 2 + i, v = y / 2 + j;
                    if (u >= in.width() || v >= in.height()) continue;
                    if (!is_seen(coarse.position(u, v))) continue;
                    const Vec3d way = Vec3d(coarse.position(u, v)) - Vec3d(fine.position(x, y));
                    near.emplace_back(std::abs(glm::dot(way, Vec3d(fine.normal(x, y)))), in(u, v));
                }
            }
            out(x, y) = 0;
            if (near.empty() || !is_seen(fine.position(x, y))) continue;
            double sum = 0, whole = 0;
            for (const auto& [off, value] : near) {
                const double weight = std::max(0.0, 1 - off / double(tolerance));
                sum += weight * value;
                whole += weight;
            }
            out(x, y) = static_cast<float>(whole > 0 ? sum / whole
                                                     : std::ranges::min_element(near)->second);
        }
    }
}

void apply_by_channels(ImageView<const float> visibility, const Rgb& ambient, Tile tile,
                       ImageView<Rgb> light) {
    for (int x = tile.x0; x < tile.x1; ++x) {
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int k = 0; k < 3; ++k) {
                light(x, y)[k] = static_cast<float>(double(visibility(x, y)) * double(ambient[k]));
            }
        }
    }
}

}  // namespace

std::vector<grading::Other> variants() {
    return {
        {"reference", "", "the reference itself", reference()},
        {"positions_by_rays", "ssao.t1", "the frame's rays, stretched",
         with(&Steps::positions, positions_by_rays)},
        {"positions_in_float", "ssao.t1", "in float, from below",
         with(&Steps::positions, positions_in_float)},
        {"normals_by_depth", "ssao.t2", "the neighbour nearest in depth",
         with(&Steps::normals, normals_by_the_nearest<true>)},
        {"normals_by_distance", "ssao.t2", "the nearest neighbour, in float",
         with(&Steps::normals, normals_by_the_nearest<false>)},
        {"kernel_of_chance", "ssao.t3", "independent points, more of them near",
         with(&Steps::kernel, kernel_of_chance)},
        {"kernel_by_rejection", "ssao.t3", "a sphere on the plane, by rejection",
         with(&Steps::kernel, kernel_by_rejection)},
        {"occlusion_in_double", "ssao.t4", "in double, another basis, other turns",
         with(&Steps::occlusion, occlusion<Turned{.in_double = true}>)},
        {"occlusion_by_chance", "ssao.t4", "a random turn for every pixel",
         with(&Steps::occlusion, occlusion<Turned{.by_chance = true}>)},
        {"occlusion_in_float", "ssao.t4", "in float, from the last point",
         with(&Steps::occlusion, occlusion<Turned{}>)},
        {"blur_in_double", "ssao.t5", "in double, by columns, from the far side",
         with(&Steps::blur, blur_in_double)},
        {"blur_by_differences", "ssao.t5", "the pixel itself and what the others differ by",
         with(&Steps::blur, blur_by_differences)},
        {"upsample_by_lists", "ssao.t6", "gathered first, in double",
         with(&Steps::upsample, upsample_by_lists)},
        {"apply_by_channels", "ssao.t7", "in double, channel by channel",
         with(&Steps::apply, apply_by_channels)},
    };
}

}  // namespace luch::homework::ssao
