#pragma once

#include "framework/math/ray.h"
#include "framework/math/size.h"
#include "framework/math/transform.h"

#include <optional>
#include <span>

namespace luch {

/// How a camera lays the world on its frame; see Screen.
enum class Projection { perspective, fisheye, spherical, orthographic };

/// The blocks Camera, FisheyeCamera, SphericalCamera and OrthographicCamera, in the file's units:
/// degrees; left-handed world, y up, z forward.
struct Camera {
    Projection projection = Projection::perspective;
    Vec3d position{0};
    double yaw_deg = 0;
    double pitch_deg = 0;
    double roll_deg = 0;
    /// perspective: the diagonal field of view, 0.0001..179; fisheye: across the frame's shorter
    /// side, 1..360; elsewhere without a meaning.
    double fov_deg = 90;
    double width = 10;  ///< orthographic: of the frame, in world units
    double aspect = 4.0 / 3.0;
    bool depth_of_field = false;
    double f_number = 2;
    double focal_distance = 100;  ///< of the plane in focus, along the view axis
    bool auto_focus = false;
    int lens_samples = 32;
    double stereo_separation = 0;  ///< between the eyes; 0: one eye

    /// Camera space to world: x right, y up, z forward.
    [[nodiscard]] Transform to_world() const;
    /// Whether it looks through a thin lens, not a pinhole: perspective only.
    [[nodiscard]] bool has_lens() const {
        return depth_of_field && projection == Projection::perspective;
    }
    /// The lens's, in world units: 2.5 / f_number; 0 where there is none.
    [[nodiscard]] double lens_radius() const { return has_lens() ? 2.5 / f_number : 0; }
    /// One eye of a stereo pair, with no stereo of its own: the camera moved along its right axis
    /// by half of the separation, the axes staying parallel.
    [[nodiscard]] Camera left_eye() const;
    [[nodiscard]] Camera right_eye() const;
};

/// A camera at a frame size: which ray goes through which point of the frame, and back. Pixel
/// coordinates are continuous: (0, 0) is the top-left corner of the top-left pixel, (x + ½, y + ½)
/// the centre of pixel (x, y). The frame is stretched over ±half_width() by ±half_height():
///  perspective   the plane at distance 1: ±aspect·m by ±m, m = tan(fov/2)/√(aspect² + 1);
///  fisheye       angles in radians: a point's distance from the middle is the angle between its
///                ray and the view axis (equidistant). ±fov/2 along the shorter side; the picture
///                is a disc, and there is nothing outside it;
///  spherical     longitude ±π by latitude ±π/2 (equirectangular), whatever the aspect;
///  orthographic  world units across the view axis: ±width/2 by ±width/2/aspect; parallel rays.
class Screen {
 public:
    Screen(const Camera& camera, Size size);

    /// The ray through a point of the screen (the course's getScreenRay), from the middle of the
    /// lens; its direction has length 1. Outside a fisheye's disc there is none: nowhere(ray).
    [[nodiscard]] Ray ray(double x_px, double y_px) const;

    /// The same from a point of the lens, given in its unit disc. All rays of one point of the
    /// screen meet in the plane at the focal distance. Without a lens: ray(x_px, y_px), bit for
    /// bit.
    [[nodiscard]] Ray ray(double x_px, double y_px, const Vec2d& lens) const;

    /// A point of the frame in the units of half_width() and half_height(): to the right and up.
    [[nodiscard]] double across(double x_px) const {
        return (2 * x_px / size_.width - 1) * half_width_;
    }
    [[nodiscard]] double upwards(double y_px) const {
        return (1 - 2 * y_px / size_.height) * half_height_;
    }
    /// The directions of rays through many points, across(x_px) in `sx` and upwards(y_px) in `sy`:
    /// bit for bit those of ray(x_px, y_px), but some at once.
    void directions(std::span<const double> sx, std::span<const double> sy, double* x, double* y,
                    double* z) const;
    /// Whether ray(x_px, y_px) always starts in eye().
    [[nodiscard]] bool one_eye() const { return projection_ != Projection::orthographic; }

    /// World to camera space: x right, y up, z forward, in the world's units.
    [[nodiscard]] Vec3d to_view(const Vec3d& world) const;

    /// The inverse of ray(): the pixel coordinates that a point in camera space falls on, perhaps
    /// outside the frame. Nothing where no ray comes: z ≤ 0 (perspective, orthographic), outside
    /// the disc or straight behind (fisheye), the eye itself.
    [[nodiscard]] std::optional<Vec2d> project(const Vec3d& view) const;

    [[nodiscard]] Projection projection() const { return projection_; }
    [[nodiscard]] Size size() const { return size_; }
    [[nodiscard]] const Vec3d& eye() const { return eye_; }
    [[nodiscard]] const Vec3d& forward() const { return forward_; }  ///< the view axis, unit length
    [[nodiscard]] double half_width() const { return half_width_; }  ///< units: see the class
    [[nodiscard]] double half_height() const { return half_height_; }

 private:
    [[nodiscard]] Vec3d direction(double sx, double sy) const;
    [[nodiscard]] Vec3d fisheye_direction(double sx, double sy) const;
    [[nodiscard]] Vec3d spherical_direction(double sx, double sy) const;
    [[nodiscard]] std::optional<Vec2d> on_screen(const Vec3d& view) const;

    Projection projection_;
    Size size_;
    Vec3d eye_, right_, up_, forward_;
    double half_width_ = 0, half_height_ = 0;
    double lens_radius_, focal_distance_;
};

/// Whether Screen::ray had no ray to give: its direction is zero. Such a ray misses everything, and
/// what it shows is black, not the sky.
[[nodiscard]] inline bool nowhere(const Ray& ray) {
    return ray.direction == Vec3d(0);
}

}  // namespace luch
