#pragma once

#include "framework/accel/accelerator.h"
#include "framework/trace/parts.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace luch {

/// Why a ray was shot.
enum class RayKind { primary, shadow, reflection, refraction, glossy, gi };
inline constexpr std::array<std::string_view, 6> ray_kind_names{
    "primary", "shadow", "reflection", "refraction", "glossy", "gi"};

/// What a frame cost, in numbers that do not depend on the machine (but for `work`).
struct Counts {
    std::array<std::uint64_t, ray_kind_names.size()> rays{};
    std::uint64_t object_tests = 0;  ///< one ray against one node, without a search
    std::uint64_t shades = 0;        ///< surface points that were lit
    std::uint64_t fallbacks = 0;     ///< pixels that a technique gave up on and traced
    std::uint64_t cells = 0;         ///< squares, texels… a technique's own unit of work
    WorkCounts work;

    void did(Part part, std::uint64_t times = 1) { parts[static_cast<std::size_t>(part)] += times; }
    /// How often a part was at work; what is counted, part_names says.
    [[nodiscard]] std::uint64_t of(Part part) const;
    [[nodiscard]] std::uint64_t& of(RayKind kind) { return rays[static_cast<std::size_t>(kind)]; }
    [[nodiscard]] std::uint64_t of(RayKind kind) const {
        return rays[static_cast<std::size_t>(kind)];
    }
    [[nodiscard]] std::uint64_t all_rays() const;
    Counts& operator+=(const Counts& other);

    std::array<std::uint64_t, part_names.size()> parts{};  ///< but scene_tree, which is in `work`
};

}  // namespace luch
