#include "techniques/sh_ambient/probes.h"

#include "techniques/sh_ambient/incoming.h"
#include "techniques/sh_ambient/sky.h"

namespace luch::techniques::sh_ambient {
namespace {

/// Rays of a distance map for each ray that brings light: they are cheap, and a map has 256 texels.
constexpr int distance_rays = 4;

Boxd finite_box(const Scene& scene, const Vec3d& eye) {
    Boxd box;
    for (const Node& node : scene.nodes) {
        const Boxd each = node.to_world.box(bounds_of(scene.geometries[node.geometry]));
        if (!each.empty() && all_finite(each.lo) && all_finite(each.hi)) box.grow(each);
    }
    if (box.empty()) box = {eye - 1.0, eye + 1.0};
    return box;
}

}  // namespace

Vec3d ProbeGrid::place(std::size_t probe) const {
    const auto x = static_cast<int>(probe % static_cast<std::size_t>(count.x));
    const auto row = static_cast<int>(probe / static_cast<std::size_t>(count.x));
    return first() + Vec3d(x, row % count.y, row / count.y) * spacing();
}

ProbeGrid grid_around(const Scene& scene, const Vec3d& eye, int along) {
    ProbeGrid grid;
    grid.box = finite_box(scene, eye);
    const double longest = max_norm(grid.box.size());
    const double spacing = (longest > 0 ? longest : 1) / along;
    // What is flat gets the thickness of a cell.
    const Vec3d more = glm::max(spacing - grid.box.size(), Vec3d(0)) / 2.0;
    grid.box = {grid.box.lo - more, grid.box.hi + more};
    grid.count = glm::clamp(glm::ivec3(glm::round(grid.box.size() / spacing)), 1, along);
    return grid;
}

bool fill(ProbeGrid& grid, const Scene& scene, const Params& params, const Needs& needs, Key key,
          const Steps& steps, Context& context) {
    const bool distances = Leaks(params.leaks) == Leaks::distances;
    grid.light.assign(grid.size(), Sh9{});
    grid.distances.assign(distances ? grid.size() : 0, DistanceMap{});
    const double far = 2 * glm::length(grid.spacing());
    const auto rays = static_cast<std::uint32_t>(params.rays);
    const SampleRange all{0, rays, rays};
    context.for_each(static_cast<int>(grid.size()), [&](int i, int worker) {
        const auto index = static_cast<std::size_t>(i);
        const Incoming incoming(scene, needs, context.tracer(worker), params.bounces);
        const Vec3d place = grid.place(index);
        Sh9& light = grid.light[index];
        call_step(context, steps.probe, reference().probe, incoming, std::span(&place, 1), all, key,
                  std::span(&light, 1));
        light = tamed(light, 2, Ringing(params.ringing));
        if (!distances) return;
        call_step(context, steps.distances, reference().distances, incoming, std::span(&place, 1),
                  distance_rays * params.rays, far, key, std::span(&grid.distances[index], 1));
    });
    return !context.cancelled();
}

// The octahedron |x| + |y| + |z| = 1, seen from +z; its lower half is folded out.

Vec3d DistanceMap::direction(int x, int y) {
    const Vec2d at = (Vec2d(x, y) + 0.5) * (2.0 / side) - 1.0;
    const double z = 1 - std::abs(at.x) - std::abs(at.y);
    if (z >= 0) return glm::normalize(Vec3d(at, z));
    return glm::normalize(
        Vec3d(std::copysign(1 - std::abs(at.y), at.x), std::copysign(1 - std::abs(at.x), at.y), z));
}

DistanceMap::Texel DistanceMap::towards(const Vec3d& unit) const {
    const Vec3d on = unit / (std::abs(unit.x) + std::abs(unit.y) + std::abs(unit.z));
    Vec2d at(on);
    if (on.z < 0) {
        at = {std::copysign(1 - std::abs(on.y), on.x), std::copysign(1 - std::abs(on.x), on.y)};
    }
    at = (at + 1.0) * (side / 2.0) - 0.5;
    const Vec2d low = glm::floor(at);
    const auto texel = [&](int x, int y) {
        // Beyond an edge of the square the same edge goes on, from its other end.
        if (x < 0 || x >= side) x = std::clamp(x, 0, side - 1), y = side - 1 - y;
        if (y < 0 || y >= side) y = std::clamp(y, 0, side - 1), x = side - 1 - x;
        const Texel& t = texels[static_cast<std::size_t>(y * side + x)];
        return Vec2d(t.mean, t.mean_square);
    };
    const int x = static_cast<int>(low.x), y = static_cast<int>(low.y);
    const Vec2d part = at - low;
    const Vec2d mixed = glm::mix(glm::mix(texel(x, y), texel(x + 1, y), part.x),
                                 glm::mix(texel(x, y + 1), texel(x + 1, y + 1), part.x), part.y);
    return {static_cast<float>(mixed.x), static_cast<float>(mixed.y)};
}

}  // namespace luch::techniques::sh_ambient
