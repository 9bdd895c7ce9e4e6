#pragma once

#include <cstdint>

// What the builder and its kernel share.
namespace luch::wide {

/// A triangle on its way into the tree: its box, four floats a corner for the kernel's sake.
struct alignas(32) Ref {
    float lo[3];
    std::uint32_t id;
    float hi[3];
    std::uint32_t unused;
};

/// Bounds by components; the fourth lane means nothing.
struct alignas(16) Corners {
    float lo[4];
    float hi[4];
};

/// Consecutive refs, the bounds of their boxes and of their boxes' centres (times two).
struct Range {
    std::uint32_t first, count;
    Corners box, centres;
};

/// Half of the surface of a box; 0 for an empty one.
inline float half_area(const Corners& c) {
    const float x = c.hi[0] - c.lo[0], y = c.hi[1] - c.lo[1], z = c.hi[2] - c.lo[2];
    return x >= 0 && y >= 0 && z >= 0 ? x * y + y * z + z * x : 0;
}

}  // namespace luch::wide
