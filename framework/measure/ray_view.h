#pragma once

#include "framework/accel/accelerator.h"
#include "framework/trace/ray_log.h"

#include <filesystem>
#include <string>
#include <vector>

// A tree of rays, seen from a second camera.
namespace luch {

/// A camera that sees the rays well: of some hundred around them, looking at their middle, the one
/// that sees most of them, every kind counting alike. Perspective, a field of view of 75°, the
/// frame's proportions those of `size`.
Camera overview_camera(const RayLog& log, const Accelerator& accelerator, Size size);

/// A piece of a ray on the screen.
struct RayStroke {
    Vec2d from_px{0}, to_px{0};
    int ray = 0;           ///< index into RayLog::rays()
    bool hidden = false;   ///< behind a surface
    bool blocked = false;  ///< the part of a shadow ray that lies beyond what blocks it
};

/// The rays as a camera sees them. One to the sky is drawn as long as all the others are wide.
std::vector<RayStroke> ray_strokes(const RayLog& log, const Accelerator& accelerator,
                                   const Screen& screen);

/// A picture of the scene (a PNG file, held inside) with the rays over it: primary ones yellow,
/// every other kind a colour of its own, what is hidden fainter; and a legend that counts them.
/// Throws Error when the picture cannot be read.
std::string ray_svg(const RayLog& log, const Scene& scene, const std::vector<RayStroke>& strokes,
                    Size size, const std::filesystem::path& png);

}  // namespace luch
