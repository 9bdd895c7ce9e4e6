#include "techniques/ssao/ambient.h"

namespace luch::techniques::ssao {

Rgb PlaneAmbient::at(const Surface& surface, std::size_t point) const {
    if (point == nowhere) return plane_->elsewhere;
    const auto& [x, y] = rays_->pixels[point];
    if (centres_) return plane_->light(x, y);
    const Vec3 here(screen_->to_view(surface.position));
    Rgb light = plane_->elsewhere;
    float least = std::numeric_limits<float>::infinity();
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, plane_->light.height() - 1); ++j) {
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, plane_->light.width() - 1); ++i) {
            if (!is_seen(plane_->position(i, j))) continue;
            const Vec3 way = plane_->position(i, j) - here;
            const float squared = glm::dot(way, way);
            if (!(squared < least)) continue;
            least = squared;
            light = plane_->light(i, j);
        }
    }
    return light;
}

}  // namespace luch::techniques::ssao
