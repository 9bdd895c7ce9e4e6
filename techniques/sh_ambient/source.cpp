#include "techniques/sh_ambient/source.h"

#include "techniques/sh_ambient/incoming.h"

namespace luch::techniques::sh_ambient {

TileAmbient::~TileAmbient() {
    of_.points += points_;
    of_.negative += negative_;
}

Rgb TileAmbient::at(const Surface& surface, std::size_t point) const {
    if (!of_.any) return Rgb(0);
    ++points_;
    const Rgb arrives = irradiance(surface, point);
    negative_ += std::min({arrives.x, arrives.y, arrives.z}) < 0 ? 1 : 0;
    if (const auto* pixel = pixel_of(point)) {
        planes_.irradiance(pixel->first, pixel->second) = arrives;
    }
    return arrives / std::numbers::pi_v<float>;
}

Rgb TileAmbient::irradiance(const Surface& surface, std::size_t point) const {
    constexpr float pi = std::numbers::pi_v<float>;
    const int samples = of_.params.samples;
    switch (Mode(of_.params.mode)) {
        case Mode::environment:
            return from(of_.sky, surface);
        case Mode::probes:
            return from(from_probes(surface, point), surface);
        case Mode::sampled: {
            const Key own = key_of(of_.key, surface.position);
            return pi * mean_of_sky(of_.scene, surface.normal, samples, own);
        }
        case Mode::traced:
            break;
    }
    const Incoming incoming(of_.scene, of_.needs, tracer_, of_.params.bounces);
    return pi * incoming.mean_at(surface, samples, key_of(of_.key, surface.position));
}

Rgb TileAmbient::from(const Sh9& light, const Surface& surface) const {
    const Vec3 normal(surface.normal);
    Rgb arrives(0);
    call_step(context_, of_.steps.irradiance, reference().irradiance, light, std::span(&normal, 1),
              std::span(&arrives, 1));
    return arrives;
}

Sh9 TileAmbient::from_probes(const Surface& surface, std::size_t point) const {
    const Receiver receiver{surface.position, surface.geometric_normal};
    Blend blend;
    call_step(context_, of_.steps.blend, reference().blend, *of_.grid, std::span(&receiver, 1),
              Leaks(of_.params.leaks), std::span(&blend, 1));
    Sh9 light;
    call_step(context_, of_.steps.trilinear, reference().trilinear, *of_.grid,
              std::span<const Blend>(&blend, 1), std::span(&light, 1));
    if (const auto* pixel = pixel_of(point)) {
        const auto most = std::ranges::max_element(blend.weight) - blend.weight.begin();
        planes_.probe(pixel->first, pixel->second) = blend.probe[static_cast<std::size_t>(most)];
        planes_.weight(pixel->first, pixel->second) = blend.weight[static_cast<std::size_t>(most)];
    }
    return light;
}

const std::pair<int, int>* TileAmbient::pixel_of(std::size_t point) const {
    if (point == nowhere || planes_.irradiance.size().area() == 0) return nullptr;
    return &rays_->pixels[point];
}

}  // namespace luch::techniques::sh_ambient
