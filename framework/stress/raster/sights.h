#pragma once

#include "framework/raster/item_buffer.h"
#include "framework/scene/scene.h"

#include <functional>

// Frames of an item buffer, held against rays pixel by pixel.
namespace luch::stress {

struct Sights {
    std::uint64_t pixels = 0;
    std::uint64_t hits = 0;
    std::uint64_t ambiguous = 0;
    std::uint64_t wrong_items = 0;  ///< certain ones that the ray does not hit first
    std::uint64_t wrong_hits =
        0;  ///< certain ones whose node, primitive, t, u or v is not the ray's
    std::uint64_t wrong_depths =
        0;  ///< hits farther than 1/nearest, or nearer than it at the rival
    std::uint64_t wrong_searches = 0;  ///< hits of rays alone and in packets that are not the truth

    Sights& operator+=(const Sights& other);
    /// Nothing wrong.
    [[nodiscard]] bool right() const {
        return wrong_items + wrong_hits + wrong_depths + wrong_searches == 0;
    }
};

using Truth = std::function<Hit(const Ray&)>;

/// Every pixel of a frame, against `truth`.
Sights compared(ItemBuffer& buffer, const Camera& camera, Size size, const Vec2d& offset,
                const Workers& workers, const Truth& truth);

/// The scene's own camera, pixel centres, closest_brute(), which rays alone and packets are held
/// against, too: all four ways to find a hit.
Sights compared_with_brute(const Scene& scene, Size size, Isa isa);

/// A camera at a point that looks somewhere.
Camera camera_at(const Vec3d& eye, double yaw_deg, double pitch_deg, double fov_deg);

}  // namespace luch::stress
