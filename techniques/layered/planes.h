#pragma once

namespace luch::techniques::layered {

/// Layers as planes that a lens ray crosses one after the other: 0 is the nearest. They are close
/// where circles of confusion are small, and grow with them: equal steps of c / (1 + |c| / 24 px).
class Planes {
 public:
    /// From signed radius `near_px` down to `far_px`. `merge`: no more planes than make circles of
    /// confusion differ by merged_px.
    Planes(double near_px, double far_px, int count, bool merge);

    /// Planes closer than this in diameters of circles of confusion are one.
    static constexpr double merged_px = 0.5;

    [[nodiscard]] int count() const { return count_; }
    /// Where a signed radius lies: 0…count − 1, between two planes.
    [[nodiscard]] float position(double radius_px) const;
    /// A plane's own; 0 for the one next to the plane of focus.
    [[nodiscard]] double radius_px(int plane) const;

 private:
    double first_, step_;
    int count_;
};

}  // namespace luch::techniques::layered
