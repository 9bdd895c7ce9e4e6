#include "framework/trace/path_lights.h"

#include <algorithm>

namespace luch {

PathLights::PathLights(const Scene& scene)
    : tree_(scene.lights),
      sky_(scene),
      rect_of_light_(scene.lights.size(), no_light),
      light_of_node_(scene.nodes.size(), no_light) {
    double sum = 0;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        if (const auto* rect = std::get_if<RectLight>(&scene.lights[i])) {
            rect_of_light_[i] = static_cast<std::uint32_t>(rects_.size());
            rects_.emplace_back(*rect);
        } else if (const auto* distant = std::get_if<DirectionalLight>(&scene.lights[i])) {
            const double power = max_norm(Vec3d(distant->color) * double(distant->power));
            if (!(power > 0)) continue;
            distant_.push_back(distant);
            distant_sums_.push_back(sum += power);
        }
    }
    for (double& value : distant_sums_) value /= sum;
    match_faces(scene);
}

void PathLights::match_faces(const Scene& scene) {
    // Lights and faces are added together, so they come in the same order.
    std::size_t next = 0;
    for (NodeId node = 0; node < scene.nodes.size(); ++node) {
        if (!std::holds_alternative<Emission>(material_of(scene, {.node = node}))) continue;
        while (next < scene.lights.size() && rect_of_light_[next] == no_light) ++next;
        if (next == scene.lights.size()) return;
        light_of_node_[node] = static_cast<std::uint32_t>(next++);
    }
}

std::optional<PathLights::Distant> PathLights::choose_distant(double random) const {
    if (distant_.empty()) return std::nullopt;
    const auto found = std::upper_bound(distant_sums_.begin(), distant_sums_.end() - 1, random);
    const auto index = static_cast<std::size_t>(found - distant_sums_.begin());
    const double below = index == 0 ? 0 : distant_sums_[index - 1];
    return Distant{distant_[index], distant_sums_[index] - below};
}

}  // namespace luch
