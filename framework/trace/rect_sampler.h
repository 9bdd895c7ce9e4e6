#pragma once

#include "framework/math/vec.h"
#include "framework/scene/light.h"

#include <optional>

namespace luch {

/// A point of a rect light, as a surface point sees it.
struct RectSample {
    Vec3d place;      ///< just in front of the light's face
    Vec3d direction;  ///< towards it, of unit length
    double pdf = 0;   ///< over solid angle
};

/// A rect light, made ready to be sampled from any point. Where its square is a rectangle, points
/// are uniform over the solid angle that it covers (Ureña, Fajardo and King, "An Area-Preserving
/// Parametrization for Spherical Rectangles", 2013); where that angle is too small to be computed
/// well, or the light's transform shears it, uniform over its area.
class RectSampler {
 public:
    explicit RectSampler(const RectLight& light);

    /// Nothing when the point lies behind the light, or in its plane.
    [[nodiscard]] std::optional<RectSample> sample(const Vec3d& from, const Vec2d& square) const;
    /// The density with which sample() finds a place of the light.
    [[nodiscard]] double pdf(const Vec3d& from, const Vec3d& place) const;

    /// What its lit side sends: color · power / area.
    [[nodiscard]] const Vec3d& radiance() const { return radiance_; }

 private:
    /// The rectangle seen from a point, which is the origin of a frame with the rectangle's axes:
    /// it spans x0..x1 by y0..y1 at height z < 0. tx = x/√(x² + z²), ty = y/√(y² + z²).
    struct View {
        double x0, x1, y0, y1, z;
        double tx0, tx1, ty0, ty1;
        double solid_angle;
    };
    [[nodiscard]] std::optional<View> view(const Vec3d& from) const;
    [[nodiscard]] Vec3d spherical_place(const View& view, const Vec2d& square) const;
    [[nodiscard]] double area_pdf(const Vec3d& from, const Vec3d& place) const;

    Vec3d corner_, edge_x_, edge_y_;  ///< of the square, in world space
    Vec3d axis_x_, axis_y_;           ///< the edges' directions
    double length_x_, length_y_, area_;
    Vec3d facing_;
    Vec3d radiance_;
    double lift_;  ///< how far off the face a sample is put, so that the face does not block it
    bool rectangle_;
};

}  // namespace luch
