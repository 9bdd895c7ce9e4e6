#include "framework/trace/focus.h"

namespace luch {

Camera focused(Camera camera, Tracer& tracer) {
    if (!camera.has_lens() || !camera.auto_focus) return camera;
    const Screen screen(camera, {1, 1});
    const Ray ray = screen.ray(0.5, 0.5);
    const Hit hit = tracer.closest(RayKind::primary, ray);
    if (hit) camera.focal_distance = hit.t * glm::dot(ray.direction, screen.forward());
    return camera;
}

}  // namespace luch
