#include "techniques/shadow_map/judged.h"

#include "framework/trace/light_sample.h"

namespace luch::techniques::shadow_map {

ShadowPlanes::ShadowPlanes(Frame& frame, bool draw, bool judge) {
    const auto cleared = [&]<class T>(const char* name, PlaneKind kind, T nothing) {
        Image<T>& plane = frame.plane<T>(name, kind, kind == PlaneKind::mask ? "" : "share");
        std::ranges::fill(plane.pixels(), nothing);
        return &plane;
    };
    if (draw) {
        share = cleared("light", PlaneKind::scalar, 0.0f);
        traced = cleared("traced", PlaneKind::mask, std::uint8_t{0});
    }
    if (!judge) return;
    false_shadow = cleared("false shadow", PlaneKind::scalar, 0.0f);
    false_light = cleared("false light", PlaneKind::scalar, 0.0f);
}

void JudgedSource::look_at(const TileRays& rays) {
    rays_ = &rays;
    asked_.assign(rays.pixels.size(), 0);
}

void JudgedSource::shares(std::size_t light, std::span<const Surface> points,
                          std::span<const std::uint32_t> which, std::span<float> shares) const {
    source_->shares(light, points, which, shares);
    if (planes_->share != nullptr) show(which, shares);
    if (planes_->false_shadow != nullptr && stands_in_one_place(scene_->lights[light])) {
        judge(light, points, which, shares);
    }
}

void JudgedSource::show(std::span<const std::uint32_t> which, std::span<const float> shares) const {
    for (std::size_t i = 0; i < which.size(); ++i) {
        const auto& [x, y] = rays_->pixels[which[i]];
        if (shares[i] == unknown) {
            (*planes_->traced)(x, y) = 1;
            continue;
        }
        int& asked = asked_[which[i]];
        float& mean = (*planes_->share)(x, y);
        mean = (mean * static_cast<float>(asked) + shares[i]) / static_cast<float>(asked + 1);
        ++asked;
    }
}

void JudgedSource::judge(std::size_t light, std::span<const Surface> points,
                         std::span<const std::uint32_t> which,
                         std::span<const float> shares) const {
    std::vector<Ray> rays;
    std::vector<std::size_t> judged;
    for (std::size_t i = 0; i < which.size(); ++i) {
        const Surface& surface = points[which[i]];
        const LightSample sample = sample_of(scene_->lights[light], 0, Key(0), surface);
        if (shares[i] == unknown || is_dark(sample, surface)) continue;
        rays.push_back(sample.shadow);
        judged.push_back(i);
    }
    std::vector<std::uint8_t> blocked(rays.size());
    tracer_->occluded(RayKind::shadow, rays, blocked);
    for (std::size_t k = 0; k < judged.size(); ++k) {
        const auto& [x, y] = rays_->pixels[which[judged[k]]];
        const float share = shares[judged[k]];
        const float held_back = blocked[k] != 0 ? 0 : 1 - share;
        const float let_through = blocked[k] != 0 ? share : 0;
        (*planes_->false_shadow)(x, y) += held_back;
        (*planes_->false_light)(x, y) += let_through;
    }
}

}  // namespace luch::techniques::shadow_map
