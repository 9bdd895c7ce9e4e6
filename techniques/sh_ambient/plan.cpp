#include "techniques/sh_ambient/plan.h"

#include "framework/baseline/stages.h"
#include "framework/scene/census.h"
#include "techniques/sh_ambient/ringing.h"

#include <fmt/format.h>

#include <algorithm>

namespace luch::techniques::sh_ambient {
namespace {

bool by_rays(Mode mode) {
    return mode == Mode::probes || mode == Mode::traced;
}

/// Whether any surface glows by itself, lamps' faces aside.
bool glows(const Scene& scene) {
    return std::ranges::any_of(scene.materials, [](const Material& material) {
        const auto* glowing = std::get_if<Const>(&material);
        return glowing != nullptr && glowing->color != Rgb(0);
    });
}

Stage ambient_stage(const Scene& scene, Mode mode, const SkyLight& sky) {
    const std::string name(stage::ambient);
    if (census_of(scene).lit == 0) return {name, false, Stage::exact, "nothing asks for it"};
    const bool inside = by_rays(mode) && (!scene.lights.empty() || glows(scene));
    if (sky.black() && !inside) {
        return {name, false, Stage::exact,
                by_rays(mode) ? "there is no light at all" : "the sky is black"};
    }
    return {name, true, Stage::exact,
            inside ? "the sky, or surfaces, shine on other surfaces" : "the sky shines"};
}

/// Terms of one degree of the sky.
Stage terms_stage(std::string_view name, double strength) {
    if (strength == 0) {
        return {std::string(name), false, Stage::exact, "the sky has none: it is of one colour"};
    }
    if (strength <= weak_terms) {
        return {std::string(name), false, Stage::bounded,
                "they change irradiance by at most the bound, relative to its mean",
                static_cast<float>(weak_terms)};
    }
    return {std::string(name), true, Stage::exact,
            fmt::format("they change irradiance by up to {:.3g} of its mean", strength)};
}

Stage ringing_stage(const SkyLight& sky, const Params& params, int degree) {
    const std::string name(stage::ringing);
    if (Ringing(params.ringing) == Ringing::off) {
        return {name, false, Stage::exact, "off: points with irradiance below 0 are counted"};
    }
    if (Ringing(params.ringing) == Ringing::scaled) {
        return {name, true, Stage::exact,
                fmt::format("linear terms are scaled by {:.4f}", ringing_scale)};
    }
    const double scale = least_scaling(tamed(sky.light, degree, Ringing::off));
    if (scale == 1) return {name, false, Stage::exact, "irradiance is nowhere below 0"};
    return {name, true, Stage::exact,
            fmt::format("linear terms are scaled by {:.4f}: no irradiance is below 0", scale)};
}

void add_sky_stages(Plan& plan, const Params& params, const SkyLight& sky) {
    plan.stages.push_back({std::string(stage::projection), !sky.black(), Stage::exact,
                           sky.black() ? "the sky is black" : "nine coefficients of the sky"});
    plan.stages.push_back(
        {std::string(stage::wild), sky.wild > 0, Stage::exact,
         sky.wild > 0 ? "texels that are not finite send nothing" : "every texel is finite"});
    if (params.degree >= 1) plan.stages.push_back(terms_stage(stage::linear, sky.strength[1]));
    if (params.degree >= 2) plan.stages.push_back(terms_stage(stage::quadratic, sky.strength[2]));
    plan.stages.push_back(ringing_stage(sky, params, degree_left(plan, params)));
}

void add_probe_stages(Plan& plan, const Params& params) {
    const bool any = plan.needed(stage::ambient);
    const std::string why = any ? "light is looked up in a grid" : "there is no ambient light";
    plan.stages.push_back({std::string(stage::probes), any, Stage::exact, why});
    if (Leaks(params.leaks) == Leaks::distances) {
        plan.stages.push_back({std::string(stage::distances), any, Stage::exact,
                               any ? "probes behind walls count less" : why});
    }
    plan.stages.push_back({std::string(stage::ringing), any && params.ringing != 0, Stage::exact,
                           any ? "each probe's own" : why});
}

}  // namespace

Plan plan_of(const Scene& scene, const Shot& shot, const Params& params, const SkyLight& sky) {
    const auto mode = Mode(params.mode);
    Plan plan{true, "", classic_stages(scene, shot)};
    plan.stages.push_back(ambient_stage(scene, mode, sky));
    const bool any = plan.needed(stage::ambient);
    plan.why = !any            ? "no ambient light: the lights' own"
               : by_rays(mode) ? "ambient light comes from the sky and from surfaces"
                               : "ambient light comes from the sky, with nothing in its way";
    if (mode == Mode::environment) add_sky_stages(plan, params, sky);
    if (mode == Mode::probes) add_probe_stages(plan, params);
    return plan;
}

int degree_left(const Plan& plan, const Params& params) {
    const auto needed = [&](std::string_view name) {
        const auto stage = std::ranges::find(plan.stages, name, &Stage::name);
        return stage != plan.stages.end() && stage->needed;
    };
    if (params.degree >= 2 && needed(stage::quadratic)) return 2;
    return params.degree >= 1 && needed(stage::linear) ? 1 : 0;
}

}  // namespace luch::techniques::sh_ambient
