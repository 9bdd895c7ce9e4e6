#pragma once

#include "framework/scene/camera.h"
#include "framework/trace/tracer.h"

namespace luch {

/// The camera with the plane in focus where autoFocus puts it: at the view-axis depth of what the
/// middle of the frame sees. One primary ray, counted; where it sees nothing, the focal distance
/// stays. A camera without a lens or without autoFocus is returned as it is, and nothing is shot.
Camera focused(Camera camera, Tracer& tracer);

}  // namespace luch
