#include "framework/accel/hit.h"
#include "framework/stress/made/everything.h"
#include "framework/stress/made/meshes.h"
#include "framework/stress/made/scenes.h"
#include "framework/stress/rays/ask.h"

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace luch::stress {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

double extreme_number(Key key) {
    constexpr double numbers[] = {nan,   inf,   -inf, 0.0,  -0.0,  1e-310, 1e-45, -1e-39, 1e-30,
                                  1e-19, -1e-5, 1e5,  1e19, -1e30, 1e38,   1e45,  1,      -1};
    return numbers[key.bits(0) % std::size(numbers)];
}

/// One or more of everything, and two spheres of many.
Scene everything() {
    Scene scene = bit_of_everything();
    scene.nodes.erase(scene.nodes.begin(), scene.nodes.begin() + 58);
    return scene;
}

/// A point in a node's box; often at whole numbers there, where a heightfield has its corners.
Vec3d point_within(const Scene& scene, const Node& node, Key key) {
    const Boxd box = bounds_of(scene.geometries[node.geometry]);
    Vec3d point;
    for (int k = 0; k < 3; ++k) {
        const double lo = std::max(box.lo[k], -20.0), hi = std::min(box.hi[k], 20.0);
        point[k] = lo + key.uniform(k) * (hi - lo);
        if (key.bits(k + 3) % 4 == 0) point[k] = std::round(point[k]);
    }
    return node.to_world.point(point);
}

/// Rays through one point of the scene that run along an axis, or are next to nothing off it, up or
/// down, from places that are next to nothing off the point; some of them at the speed at which the
/// times of hits become denormal.
RayPacket packet_along_axis(const Scene& scene, int count, Key key) {
    constexpr double tiny[] = {0.0, -0.0, 5e-324, -1e-310, 1e-308, -1e-300, 1e-160, -1e-45, 1e-39};
    const auto next_to_nothing = [&](Key own) { return tiny[own.bits(0) % std::size(tiny)]; };
    const int axis = static_cast<int>(key.bits(0) % 3);
    RayPacket rays;
    rays.origin = point_within(scene, scene.nodes[key.bits(3) % scene.nodes.size()], key.branch(0));
    rays.origin[axis] += 20 * key.uniform(1) - 10;
    if (key.bits(2) % 4 == 0) rays.origin[(axis + 1) % 3] = next_to_nothing(key.branch(1));
    for (int i = 0; i < count; ++i) {
        const Key own = key.branch(i + 2);
        Vec3d direction;
        for (int k = 0; k < 3; ++k) direction[k] = next_to_nothing(own.branch(k));
        direction[axis] = (4 * own.uniform(0) - 2) * (own.bits(1) % 4 == 0 ? 1e38 : 1);
        rays.add(direction, static_cast<float>(inf));
    }
    return rays;
}

/// `which` tells where extreme numbers stand: 0 directions, 1 origins, 2 t_min, 3 t_max.
RayPacket extreme_packet(const Scene& scene, std::uint64_t which, int count, Key key) {
    RayPacket rays;
    rays.origin = random_point(key.branch(0), 10);
    if (which == 1) rays.origin[key.bits(1) % 3] = extreme_number(key.branch(2));
    if (which == 2) rays.t_min = static_cast<float>(extreme_number(key.branch(3)));
    for (int i = 0; i < count; ++i) {
        const Key own = key.branch(i + 4);
        Vec3d direction = awkward_point(scene, own.branch(0)) - rays.origin;
        double t_max = inf;
        if (which == 0) {
            direction[own.bits(1) % 3] = extreme_number(own.branch(2));
            if (own.bits(3) % 2 == 0) direction[own.bits(4) % 3] = extreme_number(own.branch(5));
            if (own.bits(3) % 4 == 1) direction *= extreme_number(own.branch(6));
        }
        if (which == 3) t_max = extreme_number(own.branch(7));
        rays.add(direction, static_cast<float>(t_max));
    }
    return rays;
}

bool is_no_ray(const Ray& ray) {
    return !all_finite(ray.origin) || !all_finite(ray.direction) ||
           max_norm(ray.direction) < std::numeric_limits<double>::min() || !(ray.t_min < ray.t_max);
}

/// intersect_triangle() must leave what it is given alone when it finds nothing.
void judge_record(const Ray& ray, Tally& tally) {
    constexpr TriangleHit before{-7, -8, -9};
    TriangleHit hit = before;
    const bool found =
        intersect_triangle(object_ray(ray), {-1, -1, 1}, {1, -1, 1}, {0, 1, 1}, false, hit);
    const bool same = hit.t == before.t && hit.u == before.u && hit.v == before.v;
    tally.judge(found ? !std::isnan(hit.t + hit.u + hit.v) : same,
                [&] { return words_of(ray) + ": the record was written, or is NaN"; });
}

#if defined(__SSE__)
/// Denormals flushed to zero, as inputs too (FTZ and DAZ), until the end of its life.
class Flushed {
 public:
    Flushed() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040); }
    Flushed(const Flushed&) = delete;
    Flushed& operator=(const Flushed&) = delete;
    ~Flushed() { _mm_setcsr(before_); }

 private:
    unsigned before_;
};
#else
struct Flushed {};
#endif

/// Alone and in a packet.
void judge_flushed(const Accelerator& accelerator, const RayPacket& rays, Tally& tally) {
    WorkCounts work;
    HitPacket packet, flushed_packet;
    accelerator.closest(rays, packet, work);
    for (int i = 0; i < rays.count; ++i) {
        const Ray ray = rays.ray(i);
        const Hit hit = accelerator.closest(ray, work);
        const Hit flushed = [&] {
            const Flushed during;
            return accelerator.closest(ray, work);
        }();
        tally.judge(hit.node == flushed.node && hit.primitive == flushed.primitive, [&] {
            return fmt::format("{}: node {} triangle {} becomes node {} triangle {}", words_of(ray),
                               hit.node, hit.primitive, flushed.node, flushed.primitive);
        });
    }
    {
        const Flushed during;
        accelerator.closest(rays, flushed_packet, work);
    }
    for (int i = 0; i < rays.count; ++i) {
        const bool same = packet.node[i] == flushed_packet.node[i] &&
                          packet.primitive[i] == flushed_packet.primitive[i];
        tally.judge(same, [&] { return words_of(rays.ray(i)) + ": in a packet"; });
    }
}

}  // namespace

Tally extreme_rays(const Effort& effort) {
    Tally tally;
    const Scene scene = everything();
    const auto accelerator = build_accelerator(scene, effort.isa);
    each_packet(effort.of(200'000), Key(52), [&](Key key, int count) {
        const RayPacket rays = extreme_packet(scene, key.bits(0) % 4, count, key.branch(1));
        ask(*accelerator, rays, tally, [&](int i, const Hit& hit) {
            const Ray ray = rays.ray(i);
            if (is_no_ray(ray)) return hit == Hit{};
            return hit == closest_brute(scene, ray);
        });
        for (int i = 0; i < count; ++i) judge_record(rays.ray(i), tally);
    });
    return tally;
}

Tally rays_without_denormals(const Effort& effort) {
    Tally tally;
    const Scene scene = everything();
    const auto accelerator = build_accelerator(scene, effort.isa);
    each_packet(effort.of(2'000'000), Key(53), [&](Key key, int count) {
        judge_flushed(*accelerator, extreme_packet(scene, key.bits(0) % 5, count, key.branch(1)),
                      tally);
    });
    return tally;
}

Tally rays_along_axes(const Effort& effort) {
    constexpr int together = 4;  // few, for they start from one point
    Tally tally;
    const Scene scene = everything();
    const auto accelerator = build_accelerator(scene, effort.isa);
    for (std::uint64_t i = 0; i < effort.of(400'000) / together; ++i) {
        const RayPacket rays = packet_along_axis(scene, together, Key(54).branch(i));
        judge_flushed(*accelerator, rays, tally);
        ask(*accelerator, rays, tally,
            [&](int k, const Hit& hit) { return hit == closest_brute(scene, rays.ray(k)); });
    }
    return tally;
}

}  // namespace luch::stress
