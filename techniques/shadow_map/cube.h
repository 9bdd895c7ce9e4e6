#pragma once

#include "techniques/shadow_map/shadow_map.h"

#include <optional>

// The cube around a light, as Texel has it.
namespace luch::techniques::shadow_map {

/// The axes of a face: what it looks along, and what its x and y run with.
[[nodiscard]] inline int main_axis(int face) {
    return face / 2;
}
[[nodiscard]] inline int x_axis(int face) {
    return (face / 2 + 1) % 3;
}
[[nodiscard]] inline int y_axis(int face) {
    return (face / 2 + 2) % 3;
}
[[nodiscard]] inline double sign_of(int face) {
    return face % 2 == 1 ? -1 : 1;
}

/// The face that a direction goes through: of equal components the first axis's.
template <class V>
[[nodiscard]] int face_of(const V& d) {
    const V size{std::abs(d.x), std::abs(d.y), std::abs(d.z)};
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return 2 * axis + (d[axis] < 0 ? 1 : 0);
}

/// A place past one edge of its face, folded over that edge; nothing past two, where there is no
/// texel.
std::optional<Texel> folded_over(const Texel& place, int n);

/// The texel of a place that may lie one texel past the edges of its face.
[[nodiscard]] inline std::optional<Texel> folded(const Texel& place, int n) {
    const bool inside = place.x >= 0 && place.y >= 0 && place.x < n && place.y < n;
    return inside ? std::optional(place) : folded_over(place, n);
}

/// The texels of a face through which a box is seen, n × n a face, and `margin` more on each side,
/// but none beyond the face. The box is relative to the light; it may be infinite, and may hold the
/// light. No texel is lost.
Tile window_of(const Boxd& box, int face, int n, int margin);

/// A box of the directions that a spot light shines in, as window_of() takes it.
Boxd directions_of(const SpotLight& light);

/// What both have.
[[nodiscard]] inline Tile common(const Tile& a, const Tile& b) {
    Tile both{std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1),
              std::min(a.y1, b.y1)};
    if (both.x0 >= both.x1 || both.y0 >= both.y1) both = {};
    return both;
}

/// The least tile that holds both; one without texels adds nothing.
[[nodiscard]] inline Tile around(const Tile& a, const Tile& b) {
    if (a == Tile{}) return b;
    if (b == Tile{}) return a;
    return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

}  // namespace luch::techniques::shadow_map
