#pragma once

#include "framework/technique/run.h"
#include "framework/window/renderer.h"

#include <string>
#include <vector>

namespace luch {

/// The keys and what they do, one a line, a tab between.
std::vector<std::string> help_lines();

/// "x,y,z,yaw,pitch,roll,fov", exactly: what --camera reads.
std::string camera_text(const Camera& camera);

/// "camera 0 60 -150  yaw 0  pitch -12.5  fov 90  flying 40/s", rounded.
std::string camera_line(const Camera& camera, double speed);

/// "vista  12.3 ms  1.24 Mrays  640x480 (1/2)", and what else is to be known about a picture: what
/// was left out, why the technique does not apply, what a homework has not written yet, pixels that
/// are not finite. Of the first of the techniques.
std::vector<std::string> status_lines(const RenderResult& result, const std::string& fallback);

/// What was timed: one line for each technique (median, rays), then the ratio of the first to the
/// last where there are two.
std::vector<std::string> timing_lines(const RenderResult& result);

/// "plane depth [0, 12.5] m".
std::string plane_line(const Plane2d& plane);

}  // namespace luch
