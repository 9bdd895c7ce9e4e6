#include "framework/baseline/stages.h"

#include "framework/scene/census.h"

#include <algorithm>

namespace luch {
namespace {

/// What the rules look at.
struct View {
    const Scene& scene;
    const Shot& shot;
    Census has;
};

/// Which techniques a part belongs to.
enum Of : unsigned { classic = 1, path = 2, both = classic | path };

/// When a part is needed, and the reason to give.
struct Rule {
    Part part;
    Of of;
    bool (*needed)(const View&);
    std::string_view because;      ///< it is needed
    std::string_view because_not;  ///< it is left out
    Stage::Kind kind = Stage::exact;
};

bool has_picture_of_sky(const View& view) {
    return view.scene.environment &&
           std::holds_alternative<CubemapEnvironment>(*view.scene.environment);
}

bool goes_on(const View& view) {
    return view.scene.settings.max_depth > 0;
}

constexpr Rule rules[]{
    {Part::texture_coordinates, both,
     [](const View& v) { return v.has.textured + v.has.bumps > 0; },
     "a material or a bump has a texture", "nothing has a texture"},
    {Part::bump, both, [](const View& v) { return v.has.bumps > 0; }, "a node has a bump",
     "no node has a bump"},
    {Part::smooth_normals, both, [](const View& v) { return v.has.smooth > 0; },
     "a shape has normals at its corners", "every shape is flat between its corners, or exact"},
    {Part::transforms, both, [](const View& v) { return v.has.moved > 0; },
     "a node stands elsewhere than its geometry says", "every node stands where its geometry says"},
    {Part::scene_tree, both, [](const View& v) { return v.has.nodes > 1; },
     "there are several nodes to choose from", "there is no choice of nodes"},
    {Part::solids, both, [](const View& v) { return v.has.solids > 0; }, "a node is a CSG solid",
     "no node is a CSG solid"},
    {Part::heightfields, both, [](const View& v) { return v.has.heightfields > 0; },
     "a node is a heightfield", "no node is a heightfield"},
    {Part::visible_lights, both, [](const View& v) { return v.has.glowing > 0; },
     "a light can be seen", "no light can be seen"},
    {Part::direct_light, classic, [](const View& v) { return v.has.lights() > 0 && v.has.lit > 0; },
     "there are lights, and things that they shine on",
     "there are no lights, or nothing that they shine on"},
    {Part::light_samples, classic, [](const View& v) { return v.has.area_lights > 0; },
     "a light has an area", "every light shines from one point: no random numbers"},
    {Part::shared_shadows, classic,
     [](const View& v) { return v.has.standing_lights > 0 && v.has.lit > 0; },
     "a light stands in one place: a tile's shadow rays go in packets",
     "no light stands in one place"},
    {Part::dark_shadow_rays, both, [](const View&) { return false; }, "",
     "where n·l ≤ 0 or a light is black, what is in between does not matter"},
    {Part::mirrors, classic, [](const View& v) { return v.has.mirrors > 0 && goes_on(v); },
     "a material reflects", "no material reflects, or the depth is 0"},
    {Part::clear_things, classic, [](const View& v) { return v.has.clear > 0 && goes_on(v); },
     "a material refracts", "no material refracts, or the depth is 0"},
    {Part::layers, classic, [](const View& v) { return v.has.layered > 0; },
     "a material has layers", "no material has layers"},
    {Part::black_branches, classic, [](const View&) { return false; }, "",
     "what a black mirror, clear thing or layer shows does not matter"},
    {Part::environment, classic, [](const View& v) { return v.scene.environment.has_value(); },
     "the scene has an environment", "the sky is the background's colour"},
    {Part::placed_lights, path,
     [](const View& v) { return v.has.standing_lights + v.has.area_lights > 0; },
     "the scene has lights that have a place", "the scene has no lights that have a place"},
    {Part::distant_lights, path, [](const View& v) { return v.has.distant_lights > 0; },
     "the scene has directional lights", "the scene has no directional lights"},
    {Part::sky, path,
     [](const View& v) {
         return has_picture_of_sky(v) || sky_radiance(v.scene, {0, 1, 0}) != Rgb(0);
     },
     "the scene has light from its sky", "the scene has no light from its sky"},
    {Part::lens, both, [](const View& v) { return v.shot.camera.has_lens(); },
     "the camera has a thin lens (dof)",
     "the camera is a pinhole: all rays leave from one point of the lens"},
    {Part::anti_aliasing, classic,
     [](const View& v) { return may_antialias(v.shot) && v.scene.settings.anti_aliasing; },
     "the scene asks for it (wantAA): pixels where no edge is seen take no more samples",
     "samples or a lens are given, or the scene does not ask for it (wantAA)", Stage::heuristic},
};

std::vector<Stage> stages_of(Of technique, const Scene& scene, const Shot& shot) {
    const View view{scene, shot, census_of(scene)};
    std::vector<Stage> stages;
    for (const Rule& rule : rules) {
        if ((rule.of & technique) == 0) continue;
        const bool needed = rule.needed(view);
        stages.push_back({std::string(name_of(rule.part).name), needed, rule.kind,
                          std::string(needed ? rule.because : rule.because_not)});
    }
    return stages;
}

}  // namespace

std::vector<Stage> classic_stages(const Scene& scene, const Shot& shot) {
    return stages_of(classic, scene, shot);
}

std::vector<Stage> path_stages(const Scene& scene, const Shot& shot) {
    return stages_of(path, scene, shot);
}

Needs needs_of(const Plan& plan) {
    Needs needs;
    for (std::size_t i = 0; i < part_names.size(); ++i) {
        const auto stage = std::ranges::find(plan.stages, part_names[i].name, &Stage::name);
        if (stage != plan.stages.end()) needs[static_cast<Part>(i)] = stage->needed;
    }
    return needs;
}

bool may_antialias(const Shot& shot) {
    return shot.spp == 0 && !shot.camera.has_lens();
}

}  // namespace luch
