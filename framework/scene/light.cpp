#include "framework/scene/light.h"

#include <algorithm>

namespace luch {

double SpotLight::falloff(const Vec3d& away) const {
    const double cosine = glm::dot(direction, away);
    if (cosine >= inner_cosine) return 1;
    if (!(cosine > outer_cosine)) return 0;
    const double x = (cosine - outer_cosine) / (inner_cosine - outer_cosine);
    return x * x * (3 - 2 * x);
}

}  // namespace luch
