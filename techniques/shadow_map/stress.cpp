#include "techniques/shadow_map/stress.h"

#include "framework/technique/run.h"
#include "techniques/shadow_map/shadow_map.h"

#include <fmt/format.h>

#include <numbers>

namespace luch::techniques::shadow_map {
namespace {

/// A scene in the light of one lamp, and how much of its lit points may be wrong.
struct Case {
    Scene scene;
    double acne = 0;   ///< share of the points, rays being right
    double leaks = 1;  ///< not asked
};

NodeId add(Scene& scene, Geometry geometry, const Vec3d& at) {
    scene.geometries.push_back(std::move(geometry));
    return add_node(scene, "", static_cast<GeometryId>(scene.geometries.size() - 1), 0,
                    Transform::translation(at));
}

/// Black sky, a lamp; the camera looks along +z from the origin.
Scene lit_from(const Vec3d& lamp) {
    Scene scene;
    scene.settings.frame = {80, 60};
    scene.settings.ambient_light = Rgb(0.1f);
    scene.settings.anti_aliasing = false;
    scene.materials.emplace_back(Lambert{.color = Rgb(0.7f)});
    scene.lights.emplace_back(PointLight{.position = lamp, .power = 50});
    return scene;
}

/// A room seen from its middle, with a lamp in it: its walls' edges and corners are those of the
/// lamp's cube, when it hangs in the middle.
Case room(const Vec3d& lamp, double yaw_deg, double pitch_deg) {
    Case made{lit_from(lamp)};
    add(made.scene, Cube{.side = 8}, Vec3d(0));
    made.scene.camera.yaw_deg = yaw_deg;
    made.scene.camera.pitch_deg = pitch_deg;
    made.scene.camera.fov_deg = 110;
    return made;
}

/// A floor under a camera that looks down.
Scene floor_below(const Vec3d& lamp, double height) {
    Scene scene = lit_from(lamp);
    add(scene, Cube{.side = 1000}, {0, -500, 0});
    scene.camera.position = {0, height, 0};
    scene.camera.pitch_deg = -90;
    return scene;
}

/// A box thinner than the bias of its distance on a floor, and its shadow beside it.
Case thin_box() {
    Case made{floor_below({3, 4, 0}, 6)};
    const NodeId box = add(made.scene, Cube{}, {0, 0, 0});
    made.scene.nodes[box].to_world =
        Transform::scaling({2, 0.02, 2}).then(Transform::translation({0, 0.8, 0}));
    made.scene.nodes[box].to_object = made.scene.nodes[box].to_world.inverse();
    made.acne = 0.03;  // along the shadow's edge
    made.leaks = 0.03;
    return made;
}

Case stacked() {
    Case made{floor_below({0.2, 20, 0.1}, 10)};
    for (int i = 0; i < 6; ++i) {
        add(made.scene, Cube{.side = 1.5 + 0.3 * i}, {0.4 * i - 3, 1 + 1.7 * i, 0.1 * i + 1});
    }
    made.scene.camera.position = {0, 14, -9};
    made.scene.camera.pitch_deg = -60;
    made.acne = 0.03;
    made.leaks = 0.03;
    return made;
}

Outcome picture(const TechniqueInfo& info, const Scene& scene, const Accelerator& accelerator,
                int threads) {
    const std::unique_ptr<Technique> technique = info.create();
    set_param(*technique, "judge=on");
    const Workers workers(threads);
    return run(*technique, {scene, accelerator, workers}, shot_of(scene), {}, {0, 1});
}

double sum_of(const Outcome& outcome, std::string_view name) {
    double sum = 0;
    for (const Plane2d& plane : outcome.frame.planes()) {
        if (plane.name != name) continue;
        for (const float f : std::get<Image<float>>(plane.pixels).pixels()) sum += f;
    }
    return sum;
}

/// Finite, the same on one thread and on several, and no more wrong than that.
StressResult looked_at(const TechniqueInfo& info, const Case& made) {
    const auto accelerator = build_accelerator(made.scene);
    const Outcome one = picture(info, made.scene, *accelerator, 1);
    if (!one.plan.applies) return {StressVerdict::does_not_apply, one.plan.why};
    if (one.non_finite.count > 0) {
        return {StressVerdict::fail, fmt::format("{} pixels are not finite", one.non_finite.count)};
    }
    if (picture(info, made.scene, *accelerator, 3).frame.colour != one.frame.colour) {
        return {StressVerdict::fail, "other bits on 3 threads"};
    }
    const auto pixels = static_cast<double>(one.frame.size().area());
    const double acne = sum_of(one, "false shadow") / pixels;
    const double leaks = sum_of(one, "false light") / pixels;
    StressResult result{
        acne <= made.acne && leaks <= made.leaks ? StressVerdict::pass : StressVerdict::fail,
        fmt::format("false shadow {:.2g} %, false light {:.2g} %", 100 * acne, 100 * leaks)};
    if (result.verdict == StressVerdict::pass && !one.unwritten.empty()) {
        result.verdict = StressVerdict::not_written;
    }
    return result;
}

/// The same instance is shown a scene, then another: its picture is a new instance's.
StressResult moved(const TechniqueInfo& info, const Scene& before, const Scene& after) {
    const auto one = build_accelerator(before), other = build_accelerator(after);
    const Workers workers(2);
    const std::unique_ptr<Technique> technique = info.create();
    run(*technique, {before, *one, workers}, shot_of(before), {}, {0, 1});
    const Outcome kept = run(*technique, {after, *other, workers}, shot_of(after), {}, {0, 1});
    const Outcome fresh = run(*info.create(), {after, *other, workers}, shot_of(after), {}, {0, 1});
    const bool same = kept.frame.colour == fresh.frame.colour;
    if (!same) return {StressVerdict::fail, "something of the old maps is left"};
    return {kept.unwritten.empty() ? StressVerdict::pass : StressVerdict::not_written,
            "as if it had always been there"};
}

/// A list in the making.
struct CaseList {
    TechniqueInfo info;
    bool full;
    std::vector<StressCase> cases;

    void look(std::string name, std::string expected, std::function<Case()> make_it) {
        cases.push_back({16, std::move(name), std::move(expected),
                         [info = info, full = full, make_it = std::move(make_it)] {
                             Case made = make_it();
                             if (full) made.scene.settings.frame = {640, 480};
                             return looked_at(info, made);
                         }});
    }
    void move(std::string name, std::function<void(Scene&)> change) {
        cases.push_back({16, std::move(name), "no trace of where it was",
                         [info = info, change = std::move(change)] {
                             const Scene before = stacked().scene;
                             Scene after = before;
                             change(after);
                             return moved(info, before, after);
                         }});
    }
};

void add_rooms(CaseList& list) {
    const std::string no_acne = "no false shadow";
    for (const double yaw : {45.0, 135.0, 225.0, 315.0}) {
        list.look(fmt::format("a lamp's edges and corners, towards {:.0f}°", yaw), no_acne,
                  [yaw] { return room(Vec3d(0), yaw, 35); });
        // In a texel across a corner of the room the centre may see the nearer wall.
        list.look(fmt::format("a lamp off the middle, towards {:.0f}°", yaw),
                  "false shadow ≤ 0.1 %", [yaw] {
                      Case made = room({3.99, -2, 1}, yaw, -35);
                      made.acne = 0.001;
                      return made;
                  });
    }
    list.look("straight up from the lamp", no_acne, [] { return room({0, -3, 0}, 0, 90); });
    list.look("straight down from the lamp", no_acne, [] { return room({0, 3, 0}, 0, -90); });
    list.look("a lamp on a wall", "finite, threads agree", [] {
        Case made = room({4, 0, 0}, 90, 0);
        made.acne = 1;
        return made;
    });
}

void add_floors(CaseList& list) {
    list.look("a lamp in a closed box", "no light gets out", [] {
        Case made{floor_below({0, 2, 0}, 12)};
        add(made.scene, Cube{.side = 1}, {0, 2, 0});
        made.leaks = 0;
        return made;
    });
    list.look("a lamp where a floor is", "finite, threads agree", [] {
        Case made{floor_below({0, 0, 0}, 6)};
        made.acne = 1;
        return made;
    });
    for (const double height : {5.0, 0.5, 0.05}) {
        list.look(fmt::format("a floor lit from {} above, up to {:.1f}° off", height,
                              std::atan(7 / height) * 180 / std::numbers::pi),
                  "false shadow ≤ 0.1 %", [height] {
                      Case made{floor_below({0, height, 0}, 9)};
                      add(made.scene, Sphere{}, {0, 40, 0});
                      made.acne = 0.001;
                      return made;
                  });
    }
    list.look("a thin box over a floor", "its shadow, right but for its edge", thin_box);
    list.look("six boxes behind one another", "their shadows, right but for edges", stacked);
}

}  // namespace

std::vector<StressCase> stress_cases(const TechniqueInfo& info, bool full) {
    CaseList list{info, full, {}};
    add_rooms(list);
    add_floors(list);
    list.move("a box that moves", [](Scene& scene) {
        Node& box = scene.nodes[3];
        box.to_world = Transform::translation({2, 3, -1}).then(box.to_world);
        box.to_object = box.to_world.inverse();
    });
    list.move("a lamp that moves", [](Scene& scene) {
        std::get<PointLight>(scene.lights[0]).position = {-4, 18, 3};
    });
    return list.cases;
}

}  // namespace luch::techniques::shadow_map
