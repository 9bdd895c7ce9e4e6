#include "framework/math/spread.h"
#include "techniques/sh_ambient/incoming.h"
#include "techniques/sh_ambient/sh_ambient.h"

#include <array>
#include <numbers>

namespace luch::techniques::sh_ambient {
namespace {

constexpr double pi = std::numbers::pi;

/// Sums of L·Y_lm·dω, in double: a sky has a million texels, and a sun among them.
struct Sums {
    std::array<Vec3d, sh_terms> l{};

    void add(const Vec3d& direction, const Vec3d& light) {
        const auto y = harmonics(direction);
        for (std::size_t k = 0; k < sh_terms; ++k) l[k] += light * y[k];
    }
};

/// A copy in which texels that are not finite are black; returns how many.
std::uint64_t silence_wild_texels(CubemapEnvironment& sky) {
    std::uint64_t wild = 0;
    for (Image<Rgb>& side : sky.sides) {
        for (Rgb& texel : side.pixels()) {
            if (all_finite(texel)) continue;
            texel = Rgb(0);
            ++wild;
        }
    }
    return wild;
}

/// Cells along a side on which the sky is one bilinear piece: texels' centres lie on the side's
/// ends too, so n texels make n − 1. Few texels are cut further, for the sake of Y and dω.
int cells_along(int texels) {
    constexpr int least = 48;
    const int pieces = std::max(texels - 1, 1);
    return pieces * ((least + pieces - 1) / pieces);
}

/// Two points of Gauss's along each axis of a cell, which is exact to degree 3.
void add_cell(const CubemapEnvironment& sky, int side, const Vec2d& low, const Vec2d& size,
              Sums& sums) {
    constexpr std::array gauss{0.21132486540518712, 0.78867513459481288};  // (1 ∓ 1/√3)/2
    for (const double gt : gauss) {
        for (const double gs : gauss) {
            const CubePoint point{static_cast<CubePoint::Side>(side), low.x + gs * size.x,
                                  low.y + gt * size.y};
            const Vec3d d = point.direction();
            // A square ds·dt of the cube's side covers the solid angle ds·dt/|d|³.
            const double length = glm::length(d);
            const double angle = size.x * size.y / 4 / (length * length * length);
            sums.add(d / length, Vec3d(sky.radiance(d)) * angle);
        }
    }
}

void add_side(const CubemapEnvironment& sky, int side, Sums& sums) {
    const Size texels = sky.sides[static_cast<std::size_t>(side)].size();
    const int columns = cells_along(texels.width), rows = cells_along(texels.height);
    const Vec2d size(2.0 / columns, 2.0 / rows);
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            add_cell(sky, side, Vec2d(-1) + Vec2d(x, y) * size, size, sums);
        }
    }
}

std::uint64_t project(const Environment& sky, Sh9& light) {
    light = {};
    if (const auto* constant = std::get_if<ConstantEnvironment>(&sky)) {
        // ∫ Y_00 dω = √4π, and the others vanish.
        light.l[0] = constant->color * static_cast<float>(2 * std::sqrt(pi));
        return all_finite(constant->color) ? 0 : 1;
    }
    CubemapEnvironment sound = std::get<CubemapEnvironment>(sky);
    const std::uint64_t wild = silence_wild_texels(sound);
    Sums sums;
    for (int side = 0; side < 6; ++side) add_side(sound, side, sums);
    for (std::size_t k = 0; k < sh_terms; ++k) light.l[k] = Rgb(sums.l[k]);
    return wild;
}

void irradiance(const Sh9& light, std::span<const Vec3> normals, std::span<Rgb> irradiance) {
    const int terms = (light.degree + 1) * (light.degree + 1);
    std::array<Rgb, sh_terms> a;  // A_l·L_lm
    for (int k = 0; k < terms; ++k) {
        const auto i = static_cast<std::size_t>(k);
        a[i] = light.l[i] * static_cast<float>(cosine_lobe[static_cast<std::size_t>(degree_of(k))]);
    }
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const auto y = harmonics(normals[i]);
        Rgb sum = a[0] * y[0];
        if (light.degree >= 1) sum += a[1] * y[1] + a[2] * y[2] + a[3] * y[3];
        if (light.degree >= 2) {
            sum += a[4] * y[4] + a[5] * y[5] + a[6] * y[6] + a[7] * y[7] + a[8] * y[8];
        }
        irradiance[i] = sum;
    }
}

/// What random numbers of a probe are drawn for.
enum Purpose : std::uint64_t { direction, path, distance };

/// The area-preserving map of the square to the unit sphere: Archimedes's, by height and turn.
Vec3d on_sphere(const Vec2d& square) {
    const double z = 1 - 2 * square.x, turn = 2 * pi * square.y;
    const double r = std::sqrt(std::max(0.0, 1 - z * z));
    return {r * std::cos(turn), r * std::sin(turn), z};
}

void probe(const Incoming& incoming, std::span<const Vec3d> places, const SampleRange& range,
           Key key, std::span<Sh9> light) {
    const double share = 4 * pi / range.of;
    for (std::size_t p = 0; p < places.size(); ++p) {
        const Key own = key_of(key, places[p]);
        Sums sums;
        for (std::uint32_t i = range.first; i < range.end; ++i) {
            const Vec3d way = on_sphere(spread(own.branch(direction), i));
            const Rgb comes = incoming.radiance({places[p], way}, own.branch(path).branch(i));
            if (all_finite(comes)) sums.add(way, Vec3d(comes) * share);
        }
        for (std::size_t k = 0; k < sh_terms; ++k) light[p].l[k] += Rgb(sums.l[k]);
    }
}

/// The directions of a map's texels.
std::array<Vec3d, DistanceMap::side * DistanceMap::side> texel_directions() {
    std::array<Vec3d, DistanceMap::side * DistanceMap::side> directions;
    for (int i = 0; i < DistanceMap::side * DistanceMap::side; ++i) {
        directions[static_cast<std::size_t>(i)] =
            DistanceMap::direction(i % DistanceMap::side, i / DistanceMap::side);
    }
    return directions;
}

DistanceMap smoothed(std::span<const Ray> rays, std::span<const Hit> hits, double far) {
    static const auto texels = texel_directions();
    constexpr double least_cosine = 0.9;  // to the power of 100 it is nothing
    DistanceMap map;
    for (std::size_t t = 0; t < texels.size(); ++t) {
        double sum = 0, squares = 0, weights = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const double cosine = glm::dot(rays[i].direction, texels[t]);
            if (cosine < least_cosine) continue;
            const double weight = std::pow(cosine, distance_sharpness);
            const double d = std::min(static_cast<double>(hits[i].t), far);
            sum += weight * d;
            squares += weight * d * d;
            weights += weight;
        }
        // No ray near: nothing is known to be in the way.
        map.texels[t] = weights > 0 ? DistanceMap::Texel{static_cast<float>(sum / weights),
                                                         static_cast<float>(squares / weights)}
                                    : DistanceMap::Texel{static_cast<float>(far),
                                                         static_cast<float>(far * far)};
    }
    return map;
}

void distances(const Incoming& incoming, std::span<const Vec3d> places, int samples, double far,
               Key key, std::span<DistanceMap> maps) {
    std::vector<Ray> rays(static_cast<std::size_t>(samples));
    std::vector<Hit> hits(rays.size());
    for (std::size_t p = 0; p < places.size(); ++p) {
        const Key own = key_of(key, places[p]).branch(distance);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            rays[i] = {places[p], on_sphere(spread(own, static_cast<std::uint32_t>(i)))};
        }
        incoming.tracer().closest(RayKind::gi, rays, hits);
        maps[p] = smoothed(rays, hits, far);
    }
}

/// How likely a probe sees a point: Chebyshev's bound on the share of distances beyond it,
/// sharpened.
double seen(const DistanceMap& map, const Vec3d& from_probe) {
    const double d = glm::length(from_probe);
    if (!(d > 0)) return 1;
    const DistanceMap::Texel sees = map.towards(from_probe / d);
    const double mean = sees.mean, beyond = d - mean;
    if (beyond <= 0) return 1;
    const double variance = std::max(sees.mean_square - mean * mean, 0.0);
    const double bound = variance / (variance + beyond * beyond);
    return bound * bound * bound;
}

/// How much a probe counts at a point, whatever their distance; 1 where nothing is done.
double trust(const ProbeGrid& grid, std::uint32_t probe, const Receiver& point, Leaks leaks) {
    if (leaks == Leaks::shown) return 1;
    const Vec3d way = grid.place(probe) - point.position;
    const double length = glm::length(way);
    const double cosine = length > 0 ? glm::dot(way, point.normal) / length : 1;
    const double facing = (cosine + 1) * (cosine + 1) / 4;
    if (leaks == Leaks::normals) return facing;
    // Off the surface, which else would hide the point from whatever grazes it.
    const Vec3d spacing = grid.spacing();
    const double off = std::min({spacing.x, spacing.y, spacing.z}) * ProbeGrid::off_surface;
    return facing * seen(grid.distances[probe], off * point.normal - way);
}

Blend blend_at(const ProbeGrid& grid, const Receiver& point, Leaks leaks) {
    const Vec3d last(grid.count - 1);
    const Vec3d at = glm::clamp((point.position - grid.first()) / grid.spacing(), Vec3d(0), last);
    const glm::ivec3 low = glm::max(glm::min(glm::ivec3(at), grid.count - 2), glm::ivec3(0));
    const Vec3d part = at - Vec3d(low);
    Blend blend;
    std::array<double, 8> near{}, weight{};
    double sum = 0;
    for (unsigned k = 0; k < 8; ++k) {
        const glm::ivec3 step(k & 1, k >> 1 & 1, k >> 2 & 1);
        blend.probe[k] = grid.index(glm::min(low + step, grid.count - 1));
        const Vec3d share = glm::mix(1.0 - part, part, Vec3d(step));
        near[k] = share.x * share.y * share.z;
        if (near[k] > 0) weight[k] = near[k] * trust(grid, blend.probe[k], point, leaks);
        sum += weight[k];
    }
    // Where no probe sees the point there is nothing better than all of them.
    for (unsigned k = 0; k < 8; ++k) {
        blend.weight[k] = static_cast<float>(sum > 0 ? weight[k] / sum : near[k]);
    }
    return blend;
}

void blend(const ProbeGrid& grid, std::span<const Receiver> points, Leaks leaks,
           std::span<Blend> blends) {
    for (std::size_t i = 0; i < points.size(); ++i) blends[i] = blend_at(grid, points[i], leaks);
}

void trilinear(const ProbeGrid& grid, std::span<const Blend> blends, std::span<Sh9> light) {
    for (std::size_t i = 0; i < blends.size(); ++i) {
        light[i] = {};
        for (std::size_t k = 0; k < 8; ++k) {
            // A probe that does not count, were it infinite.
            if (blends[i].weight[k] == 0) continue;
            const Sh9& of = grid.light[blends[i].probe[k]];
            for (std::size_t j = 0; j < sh_terms; ++j)
                light[i].l[j] += of.l[j] * blends[i].weight[k];
        }
    }
}

}  // namespace

Steps reference() {
    return {project, irradiance, probe, distances, blend, trilinear};
}

}  // namespace luch::techniques::sh_ambient
