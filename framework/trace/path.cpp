#include "framework/trace/path.h"

namespace luch {
namespace {

/// What a vertex's random numbers are drawn for, beside those of its BSDF, which count from 0.
enum Purpose : std::uint64_t { light_choice = 64, light_place, sky_direction, survival };

/// From this depth on a path may be ended by roulette.
constexpr int first_roulette = 3;

Vec3d faded(const Vec3d& light, const Refraction* medium, double distance) {
    return medium == nullptr ? light : light * Vec3d(medium->transmittance(distance));
}

}  // namespace

Vec3d PathTracer::radiance(const Ray& camera_ray, const Draw& draw) {
    RayLog::Branch branch(tracer_->log());
    Path path{.ray = camera_ray};
    while (step(path, {draw.key.branch(static_cast<std::uint64_t>(path.depth)), draw.index})) {
        branch.follow();
    }
    return path.light;
}

bool PathTracer::at_work(Part part) {
    if (needs_[part]) tracer_->counts().did(part);
    return needs_[part];
}

bool PathTracer::step(Path& path, const Draw& draw) {
    const Hit hit = tracer_->closest(path.kind, path.ray);
    if (!hit) {
        meet_sky(path);
        return false;
    }
    path.throughput = faded(path.throughput, path.medium, hit.t);
    const std::uint32_t light =
        at_work(Part::visible_lights) ? lights_->light_of(hit.node) : PathLights::no_light;
    if (light != PathLights::no_light) {
        meet_lamp(path, hit, light);
        return false;
    }
    if (path.depth > settings_.depth) return false;
    surface_ = surface_at(*scene_, path.ray, hit, needs_, tracer_->counts());
    bsdf_.set(*scene_, surface_, path.ray.direction, material_of(*scene_, hit), path.medium);
    path.light += path.throughput * bsdf_.emitted();
    if (bsdf_.scatters()) {
        // The shadow rays are this surface's children: the log hears of it here.
        RayLog::Branch branch(tracer_->log());
        branch.follow();
        path.light += path.throughput * direct(draw, path.medium);
    }
    return go_on(path, draw);
}

void PathTracer::meet_sky(Path& path) const {
    const Vec3d light(sky_radiance(*scene_, path.ray.direction));
    const double pdf = path.pdf > 0 ? lights_->sky().pdf(path.from_normal, path.ray.direction) : 0;
    path.light += path.throughput * light * bsdf_weight(path.pdf, pdf);
}

void PathTracer::meet_lamp(Path& path, const Hit& hit, std::uint32_t light) {
    Needs needs(false);
    needs[Part::transforms] = needs_[Part::transforms];
    const Surface face = surface_at(*scene_, path.ray, hit, needs, tracer_->counts());
    if (face.front) return;
    const RectSampler& rect = lights_->rect(light);
    double pdf = 0;
    if (path.pdf > 0) {
        pdf = lights_->placed().probability(light, path.from, path.from_normal) *
              rect.pdf(path.from, face.position);
    }
    path.light += path.throughput * rect.radiance() * bsdf_weight(path.pdf, pdf);
}

bool PathTracer::go_on(Path& path, const Draw& draw) {
    const auto bounce = bsdf_.sample(draw);
    if (!bounce) return false;
    // Beyond the last surface there is nothing but the light that shines on it.
    const bool only_lights = path.depth >= settings_.depth;
    const bool may_meet_one =
        bounce->pdf > 0 && settings_.sampling != PathSampling::light && lights_->can_be_met();
    if (only_lights && !may_meet_one) return false;
    path.throughput *= bounce->weight;
    if (settings_.roulette && path.depth >= first_roulette) {
        const double survives = std::min(1.0, max_norm(path.throughput));
        if (!(draw.pair(survival).x < survives)) return false;
        path.throughput /= survives;
    }
    path.ray = leaving(surface_, bounce->direction);
    path.kind = bounce->kind;
    path.medium = bounce->medium;
    path.from = surface_.position;
    path.from_normal = bsdf_.normal();
    path.pdf = bounce->pdf;
    ++path.depth;
    return path.throughput != Vec3d(0);
}

Vec3d PathTracer::direct(const Draw& draw, const Refraction* medium) {
    ++tracer_->counts().shades;
    Vec3d light(0);
    if (at_work(Part::placed_lights)) light += from_placed(draw, medium);
    if (at_work(Part::distant_lights)) light += from_distant(draw);
    if (at_work(Part::sky) && !lights_->sky().black() && settings_.sampling != PathSampling::bsdf) {
        light += from_sky(draw.pair(sky_direction));
    }
    return light;
}

Vec3d PathTracer::from_placed(const Draw& draw, const Refraction* medium) {
    const LightTree& tree = lights_->placed();
    const double random = tree.single() ? 0 : draw.pair(light_choice).x;
    const auto choice = tree.choose(surface_.position, bsdf_.normal(), random);
    if (!choice) return Vec3d(0);
    const Light& light = scene_->lights[choice->light];
    if (const auto* point = std::get_if<PointLight>(&light)) {
        const Vec3d intensity = Vec3d(point->color) * (point->power / choice->probability);
        return from_point(point->position, intensity, medium);
    }
    if (const auto* spot = std::get_if<SpotLight>(&light)) {
        const Vec3d intensity = Vec3d(spot->color) * (spot->power / choice->probability);
        const double share = spot->falloff(glm::normalize(surface_.position - spot->position));
        return from_point(spot->position, share * intensity, medium);
    }
    if (settings_.sampling == PathSampling::bsdf) return Vec3d(0);
    return from_rect(choice->light, choice->probability, draw.pair(light_place), medium);
}

Vec3d PathTracer::from_rect(std::uint32_t light, double probability, const Vec2d& square,
                            const Refraction* medium) {
    const RectSampler& rect = lights_->rect(light);
    const auto sample = rect.sample(surface_.position, square);
    if (!sample) return Vec3d(0);
    const double pdf = probability * sample->pdf;
    const Bsdf::Value value = bsdf_.evaluate(sample->direction);
    const Vec3d arrives =
        faded(rect.radiance(), medium, glm::length(sample->place - surface_.position));
    return unless_blocked(value.reflected * arrives * (light_weight(pdf, value.pdf) / pdf),
                          shadow_ray(surface_, sample->place));
}

Vec3d PathTracer::from_point(const Vec3d& place, const Vec3d& intensity, const Refraction* medium) {
    const Vec3d way = place - surface_.position;
    const double distance = glm::length(way);
    if (!(distance > 0)) return Vec3d(0);
    const Bsdf::Value value = bsdf_.evaluate(way / distance);
    const Vec3d arrives = faded(intensity, medium, distance) / (distance * distance);
    return unless_blocked(value.reflected * arrives, shadow_ray(surface_, place));
}

Vec3d PathTracer::from_distant(const Draw& draw) {
    const auto choice = lights_->choose_distant(draw.pair(light_choice).y);
    if (!choice) return Vec3d(0);
    const Vec3d to_light = -choice->light->direction;
    const Vec3d arrives =
        Vec3d(choice->light->color) * (choice->light->power / choice->probability);
    return unless_blocked(bsdf_.evaluate(to_light).reflected * arrives,
                          leaving(surface_, to_light));
}

Vec3d PathTracer::from_sky(const Vec2d& square) {
    const SkySampler::Sample sample = lights_->sky().sample(bsdf_.normal(), square);
    if (!(sample.pdf > 0)) return Vec3d(0);
    const Bsdf::Value value = bsdf_.evaluate(sample.direction);
    const Vec3d arrives(sky_radiance(*scene_, sample.direction));
    return unless_blocked(
        value.reflected * arrives * (light_weight(sample.pdf, value.pdf) / sample.pdf),
        leaving(surface_, sample.direction));
}

Vec3d PathTracer::unless_blocked(const Vec3d& light, const Ray& shadow) {
    const bool dark = light == Vec3d(0);
    if (dark && !at_work(Part::dark_shadow_rays)) return Vec3d(0);
    const bool blocked = tracer_->occluded(RayKind::shadow, shadow);
    return dark || blocked ? Vec3d(0) : light;
}

double PathTracer::light_weight(double light_pdf, double bsdf_pdf) const {
    if (settings_.sampling == PathSampling::light || !(bsdf_pdf > 0)) return 1;
    if (!settings_.mis) return 0.5;
    const double ratio = bsdf_pdf / light_pdf;
    return 1 / (1 + ratio * ratio);
}

double PathTracer::bsdf_weight(double bsdf_pdf, double light_pdf) const {
    if (settings_.sampling == PathSampling::bsdf || !(light_pdf > 0)) return 1;
    if (settings_.sampling == PathSampling::light) return 0;
    if (!settings_.mis) return 0.5;
    const double ratio = light_pdf / bsdf_pdf;
    return 1 / (1 + ratio * ratio);
}

}  // namespace luch
