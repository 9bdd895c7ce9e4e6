#include "techniques/shadow_map/source.h"

#include "techniques/shadow_map/filters.h"

namespace luch::techniques::shadow_map {

/// Some of a tile's points.
struct MapSource::Asked {
    std::span<const Surface> points;
    std::span<const std::uint32_t> which;

    [[nodiscard]] std::size_t size() const { return which.size(); }
    [[nodiscard]] const Surface& operator[](std::size_t i) const { return points[which[i]]; }
};

namespace {

/// What a point of a light with an area would send to a surface were nothing in between, but for a
/// factor.
float unhindered(const Surface& surface, const LightPoint& point, const Vec3d& facing) {
    const Vec3d way = surface.position - point.position;
    const double squared = glm::dot(way, way);
    const double leaves = glm::dot(facing, way), arrives = -glm::dot(surface.normal, way);
    if (!(leaves > 0 && arrives > 0)) return 0;
    return static_cast<float>(leaves * arrives / (squared * squared)) * point.share;
}

/// A light in the place of its middle.
double width_of(const Light& light) {
    const auto* rect = std::get_if<RectLight>(&light);
    if (rect == nullptr) return 0;
    return (glm::length(rect->to_world.direction({1, 0, 0})) +
            glm::length(rect->to_world.direction({0, 0, 1}))) /
           2;
}

}  // namespace

Steps asked_steps(const Steps& steps, bool filter, Context& context) {
    Steps asked = steps;
    const CubeMap none{1, {}};
    if (!written(context, [&] { steps.bias({}, 1, {}); })) asked.bias = reference().bias;
    if (filter) {
        if (!written(context, [&] { steps.pcf(none, {}, {}, {}); })) asked.pcf = reference().pcf;
    } else if (!written(context, [&] { steps.lit(none, {}, {}, {}); })) {
        asked.lit = reference().lit;
    }
    return asked;
}

void offset_along_normal(Receiver& receiver, float& bias) {
    const float distance = glm::length(receiver.from_light);
    const float cosine = glm::dot(receiver.normal, receiver.from_light) / distance;
    if (!(std::abs(cosine) < grazing_cosine) || !(distance > 0)) return;
    if (!std::isfinite(bias)) {  // in its own plane no surface is lit
        bias = 0;
        return;
    }
    receiver.from_light -= bias * cosine * receiver.normal;
    bias = 0;
}

void MapSource::shares(std::size_t light, std::span<const Surface> points,
                       std::span<const std::uint32_t> which, std::span<float> shares) const {
    const Lights& lights = lights_[light];
    const Asked asked{points, which};
    if (lights.convex) {
        // Of one convex thing, whatever faces the light is lit, from outside.
        for (std::size_t i = 0; i < asked.size(); ++i) shares[i] = asked[i].front ? 1 : unknown;
    } else if (lights.lamps.empty()) {
        std::ranges::fill(shares, unknown);
    } else {
        mix(lights, width_of(scene_->lights[light]), asked, shares);
    }
}

float MapSource::share(std::size_t light, const Surface& surface) const {
    const std::uint32_t first = 0;
    float share = unknown;
    shares(light, {&surface, 1}, {&first, 1}, {&share, 1});
    return share;
}

void MapSource::mix(const Lights& lights, double width, const Asked& asked,
                    std::span<float> shares) const {
    if (lights.facing == Vec3d(0)) return ask(lights.lamps[0], width, asked, shares);
    std::vector<float> arrives(shares.size()), whole(shares.size(), 0.0f);
    std::vector<std::uint8_t> known(shares.size(), 1);
    std::ranges::fill(shares, 0.0f);
    for (const Lamp& lamp : lights.lamps) {
        ask(lamp, width, asked, arrives);
        for (std::size_t i = 0; i < shares.size(); ++i) {
            if (arrives[i] == unknown) known[i] = 0;
            const float weight = unhindered(asked[i], lamp.point, lights.facing);
            shares[i] += weight * arrives[i];
            whole[i] += weight;
        }
    }
    for (std::size_t i = 0; i < shares.size(); ++i) {
        if (whole[i] > 0) shares[i] = std::min(shares[i] / whole[i], 1.0f);
        // Points that do not agree leave it to rays.
        const bool split = Mode(params_->mode) == Mode::heuristic && shares[i] > 0 && shares[i] < 1;
        if (known[i] == 0 || split) shares[i] = unknown;
    }
}

void MapSource::ask(const Lamp& lamp, double width, const Asked& asked,
                    std::span<float> shares) const {
    if (Mode(params_->mode) == Mode::exact) return ask_items(lamp, asked, shares);
    const bool on_sphere = lamp.sphere.n > 0;
    const int n = on_sphere ? lamp.sphere.n : lamp.map.n;
    std::vector<Receiver> receivers;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        receivers.push_back(
            {Vec3(asked[i].position - lamp.point.position), Vec3(asked[i].geometric_normal)});
    }
    std::vector<float> biases(receivers.size());
    if (on_sphere) {
        sphere_bias(receivers, n, biases);
    } else {
        call_step(*context_, steps_->bias, reference().bias, receivers, n, biases);
    }
    const Mode mode = Mode(params_->mode);
    const bool wide = mode == Mode::heuristic || (mode == Mode::classic && filter_);
    const auto factor = static_cast<float>(params_->bias) * (wide ? pcf_width : 1);
    for (std::size_t i = 0; i < biases.size(); ++i) {
        biases[i] *= factor;
        if (params_->offset && mode == Mode::classic) offset_along_normal(receivers[i], biases[i]);
    }
    if (on_sphere) {
        sphere_shares(lamp.sphere, receivers, biases, filter_, shares);
    } else {
        ask_map(lamp, width, receivers, biases, shares);
    }
}

void MapSource::ask_map(const Lamp& lamp, double width, std::span<const Receiver> receivers,
                        std::span<const float> biases, std::span<float> shares) const {
    switch (Mode(params_->mode)) {
        case Mode::pcss:
            return soft_shares(lamp.map, width, receivers, biases, shares);
        case Mode::vsm:
        case Mode::msm:
            return shares_by_moments(lamp.map, lamp.moments, Mode(params_->mode) == Mode::msm,
                                     receivers, biases, shares);
        default:
            break;
    }
    const bool heuristic = Mode(params_->mode) == Mode::heuristic, filter = filter_ || heuristic;
    call_step(*context_, filter ? steps_->pcf : steps_->lit,
              filter ? reference().pcf : reference().lit, lamp.map, receivers, biases, shares);
    if (heuristic) keep_agreed(receivers, biases, shares);
}

void MapSource::ask_items(const Lamp& lamp, const Asked& asked, std::span<float> shares) const {
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const Ray shadow = shadow_ray(asked[i], lamp.point.position);
        shares[i] = share_by_items(lamp.items, *scene_, shadow, tracer_->counts(),
                                   own_convex(*scene_, asked[i], shadow));
    }
}

}  // namespace luch::techniques::shadow_map
