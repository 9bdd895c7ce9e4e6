#pragma once

#include "framework/accel/accelerator.h"
#include "framework/accel/packet.h"
#include "framework/measure/bench_rays.h"

#include <span>
#include <string_view>
#include <vector>

namespace luch {

/// The rays of one kind, in tiles of 16 × 16 pixels and blocks of 4 × 4 within. Origins and
/// directions are floats, so that every back end gets the same.
struct BenchShots {
    std::vector<Ray> rays;           ///< with t_max < t_min where there is nothing to ask
    std::vector<RayPacket> packets;  ///< the same, 256 each; empty when origins differ
    std::uint64_t active = 0;
    bool occlusion = false;
};

/// Primary rays of a side × side frame.
BenchShots primary_shots(const BenchView& view, int side);
/// From the light to what the primary rays met; `offset` lifts the end of the ray off the surface,
/// towards the light.
BenchShots shadow_shots(const Scene& scene, const BenchView& view, std::span<const Hit> hits,
                        double offset);
/// One cosine-weighted bounce off what the primary rays met; `offset` lifts it off the surface,
/// towards the eye.
BenchShots diffuse_shots(const Scene& scene, const BenchShots& primary, std::span<const Hit> hits,
                         double offset);

}  // namespace luch
