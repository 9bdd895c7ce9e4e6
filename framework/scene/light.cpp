#include "framework/scene/light.h"

#include <algorithm>

namespace luch {

Vec3d RectLight::facing() const {
    const double orientation = glm::determinant(to_world.matrix) < 0 ? -1 : 1;
    return orientation *
           glm::normalize(glm::cross(to_world.direction({1, 0, 0}), to_world.direction({0, 0, 1})));
}

double SpotLight::falloff(const Vec3d& away) const {
    const double cosine = glm::dot(direction, away);
    if (cosine >= inner_cosine) return 1;
    if (!(cosine > outer_cosine)) return 0;
    const double x = (cosine - outer_cosine) / (inner_cosine - outer_cosine);
    return x * x * (3 - 2 * x);
}

}  // namespace luch
