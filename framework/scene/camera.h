#pragma once

#include "framework/math/ray.h"
#include "framework/math/size.h"
#include "framework/math/transform.h"

#include <optional>

namespace luch {

/// The block Camera, in the file's units: degrees; left-handed world, y up, z forward.
struct Camera {
    Vec3d position{0};
    double yaw_deg = 0;
    double pitch_deg = 0;
    double roll_deg = 0;
    double fov_deg = 90;  ///< the diagonal field of view
    double aspect = 4.0 / 3.0;
    bool depth_of_field = false;
    double f_number = 2;
    double focal_distance = 100;
    bool auto_focus = false;
    int lens_samples = 32;
    double stereo_separation = 0;

    /// Camera space to world: x right, y up, z forward.
    [[nodiscard]] Transform to_world() const;
};

/// A camera's image plane at a frame size. The plane lies at distance 1 and spans ±aspect·m by ±m,
/// m = tan(fov/2)/√(aspect² + 1). Pixel coordinates are continuous: (0, 0) is the top-left corner
/// of the top-left pixel, (x + ½, y + ½) the centre of pixel (x, y).
class Screen {
 public:
    Screen(const Camera& camera, Size size);

    /// The ray through a point of the screen (the course's getScreenRay); its direction has
    /// length 1.
    [[nodiscard]] Ray ray(double x_px, double y_px) const;

    /// World to camera space: x right, y up, z forward, in the world's units.
    [[nodiscard]] Vec3d to_view(const Vec3d& world) const;

    /// The inverse of ray(): the pixel coordinates that a point in camera space falls on.
    /// Nothing when it lies on or behind the plane of the eye (z ≤ 0).
    [[nodiscard]] std::optional<Vec2d> project(const Vec3d& view) const;

    [[nodiscard]] Size size() const { return size_; }
    [[nodiscard]] const Vec3d& eye() const { return eye_; }
    [[nodiscard]] double half_width() const { return half_width_; }    ///< of the plane at z = 1
    [[nodiscard]] double half_height() const { return half_height_; }  ///< of the plane at z = 1

 private:
    Size size_;
    Vec3d eye_, right_, up_, forward_;
    double half_width_, half_height_;
};

}  // namespace luch
