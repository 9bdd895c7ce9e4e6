#include "framework/stress/made/everything.h"
#include "framework/stress/made/meshes.h"
#include "framework/stress/subject.h"
#include "framework/stress/things.h"

#include <fmt/format.h>

namespace luch::stress {
namespace {

const Rgb paint(0.75f, 0.5f, 0.25f), sky(0.25f, 0.5f, 0.75f);

/// Things that shine in one colour under a sky of another, in no light.
Scene painted(const Camera& camera) {
    Scene scene;
    scene.settings = {.frame = {33, 25}, .ambient_light = Rgb(0), .background = sky};
    scene.settings.anti_aliasing = false;
    scene.camera = camera;
    return scene;
}

Scene painted(Thing thing, const Camera& camera) {
    Scene scene = painted(camera);
    add(scene, thing, Const{.color = paint});
    return scene;
}

Camera at(const Vec3d& place, double yaw_deg = 0, double pitch_deg = 0, double fov_deg = 90) {
    Camera camera;
    camera.position = place;
    camera.yaw_deg = yaw_deg;
    camera.pitch_deg = pitch_deg;
    camera.fov_deg = fov_deg;
    return camera;
}

Scene painted_floor(const Camera& camera) {
    Scene scene = painted(camera);
    add(scene, Plane{.y = 0}, Const{.color = paint});
    return scene;
}

Camera of_kind(Projection projection, double fov_deg, double width) {
    Camera camera = at({0, 0, 0}, 20, 10, fov_deg);
    camera.projection = projection;
    camera.width = width;
    return camera;
}

void add_inside(CaseList& list) {
    for (const Thing thing : closed_things) {
        list.look(
            13, fmt::format("the camera inside {}", to_string(thing)), "its colour everywhere",
            [thing] {
                return painted(thing, at({0.1, 0.05, -0.2}, 30, 20));
            },
            all_of(paint));
    }
}

void add_on_surface(CaseList& list) {
    struct Place {
        Thing thing;
        Vec3d at;
        double pitch_deg;
    };
    // Looking in along the normal; corners of the mesh and of the sphere's poles are exact.
    for (const Place& place :
         {Place{Thing::sphere, {0, 1, 0}, -90}, Place{Thing::cube, {0, 0.75, 0}, -90},
          Place{Thing::ball, {0, 1, 0}, -90}, Place{Thing::solid, {0, 0.75, 0}, -90}}) {
        const std::string name = fmt::format("the camera on {}, looking ", to_string(place.thing));
        list.look(
            13, name + "in", "its colour everywhere",
            [place] { return painted(place.thing, at(place.at, 0, place.pitch_deg, 60)); },
            all_of(paint));
        list.look(
            13, name + "out", "the sky everywhere",
            [place] { return painted(place.thing, at(place.at, 0, -place.pitch_deg, 60)); },
            all_of(sky));
    }
    list.look(
        13, "the camera in a plane", "the sky everywhere",
        [] {
            return painted_floor(at({3, 0, -2}));
        },
        all_of(sky));
    list.look(
        13, "the camera in a square, looking up", "the sky everywhere",
        [] {
            return painted(Thing::square, at({0.25, 0, 0.5}, 0, 90));
        },
        all_of(sky));
}

void add_directions(CaseList& list) {
    for (const double fov_deg : {0.0001, 1e-3, 179.0}) {
        list.look(
            13, fmt::format("a field of view of {}°, inside a sphere", fov_deg),
            "its colour everywhere",
            [fov_deg] {
                return painted(Thing::sphere, at({0, 0, 0}, 40, 30, fov_deg));
            },
            all_of(paint));
        list.look(13, fmt::format("a field of view of {}°", fov_deg), "finite", [fov_deg] {
            Scene scene = bit_of_everything();
            scene.camera.fov_deg = fov_deg;
            return scene;
        });
    }
    // So far away that the frame lies in the mesh, and at 0.001° would not.
    list.look(
        13, "a field of view of 0.0001° of a mesh", "its colour everywhere",
        [] {
            return painted(Thing::ball, at({0, 0, -5e5}, 0, 0, 0.0001));
        },
        all_of(paint));
    for (const double roll_deg : {0.0, 45.0}) {
        for (const double pitch_deg : {-90.0, 90.0}) {
            list.look(
                13, fmt::format("pitch {}°, roll {}°, over a floor", pitch_deg, roll_deg),
                pitch_deg < 0 ? "the floor everywhere" : "the sky everywhere",
                [=] {
                    Camera camera = at({1, 2, 3}, 77, pitch_deg);
                    camera.roll_deg = roll_deg;
                    return painted_floor(camera);
                },
                all_of(pitch_deg < 0 ? paint : sky));
        }
    }
    list.look(13, "pitch −90° over everything", "finite", [] {
        Scene scene = bit_of_everything();
        scene.camera.pitch_deg = -90;
        return scene;
    });
}

void add_projections(CaseList& list) {
    list.look(
        13, "a spherical camera in a sphere", "its colour everywhere",
        [] { return painted(Thing::sphere, of_kind(Projection::spherical, 90, 10)); },
        all_of(paint));
    for (const double width : {1e-6, 1e6}) {
        const Rgb colour = width < 1 ? paint : sky;
        list.look(
            13, fmt::format("an orthographic camera {:g} wide, in a sphere", width),
            width < 1 ? "its colour everywhere" : "the sky but in one pixel",
            [width] {
                return painted(Thing::sphere, of_kind(Projection::orthographic, 90, width));
            },
            [colour, width](const Sight& sight) {
                const Image<Rgb> plain(sight.shot.size, colour);
                const std::size_t off =
                    unlike(plain.view(), sight.colour(), 1e-5, sight.subject.info->resolution);
                return judged(off <= (width < 1 ? 0u : 1u), fmt::format("{} pixels differ", off));
            });
    }
    list.look(
        13, "a fisheye of 360° in a sphere", "its colour, black corners",
        [] { return painted(Thing::sphere, of_kind(Projection::fisheye, 360, 10)); },
        [](const Sight& sight) {
            const Rgb corner = sight.colour()(0, 0), middle = sight.colour()(16, 12);
            const float allowed = std::max(1e-5f, sight.subject.info->resolution);
            const bool right = corner == Rgb(0) && max_norm(middle - paint) < allowed;
            return judged(right, fmt::format("corner {:g}, middle {:g}", corner.x, middle.x));
        });
}

void add_closed_meshes(CaseList& list) {
    for (const Vec3d& by : {Vec3d(0), Vec3d(148376, 1234, -223423)}) {
        for (const double yaw_deg : {0.0, 135.0}) {
            list.look(
                1, fmt::format("inside a closed mesh at {:g}, yaw {}°", by.x, yaw_deg),
                "no pixel of sky",
                [=] {
                    Scene scene = painted(at(by + Vec3d(0.1, 0.2, -0.1), yaw_deg, 10, 120));
                    scene.settings.frame = {96, 72};
                    add(scene, uv_sphere(24, 40, 1), Const{.color = paint},
                        Transform::translation(by));
                    return scene;
                },
                all_of(paint));
        }
    }
}

void add_close_and_far_spheres(CaseList& list) {
    for (const double radius : {1e6, 1e12}) {
        list.look(
            6, fmt::format("a ground sphere of radius {:g}", radius), "the ground below",
            [radius] {
                Scene scene = painted(at({0, 1, 0}, 0, -60, 60));
                add(scene, Sphere{.centre = {0, -radius, 0}, .radius = radius},
                    Const{.color = paint});
                // Below the ground: seen when its distance is wrong.
                add(scene, Cube{.centre = {0, -15, 0}, .side = 20}, Const{.color = sky});
                return scene;
            },
            all_of(paint));
    }
    list.look(
        7, "two spheres, 4e-5 apart", "the outer one",
        [] {
            Scene scene = painted(at({0, 0, -3}, 0, 0, 20));
            add(scene, Sphere{.radius = 1}, Const{.color = sky});
            add(scene, Sphere{.radius = 1 + 4e-5}, Const{.color = paint});
            return scene;
        },
        all_of(paint));
}

void add_degenerate_meshes(CaseList& list) {
    list.look(
        9, "ten thousand triangles in one place", "their colour",
        [] {
            Mesh mesh = triangle({-50, -50, 4}, {50, -50, 4}, {0, 90, 4});
            mesh.triangles.resize(10'000, mesh.triangles[0]);
            Scene scene = painted(at({0, 0, 0}));
            scene.settings.frame = {12, 9};
            add(scene, mesh, Const{.color = paint});
            return scene;
        },
        all_of(paint));
    list.look(9, "collinear triangles", "the sky, or their colour", [] {
        Mesh mesh = triangle_soup(200, 1, Key(72));
        for (std::size_t i = 0; i + 2 < mesh.positions.size(); i += 3) {
            mesh.positions[i + 2] = 0.5f * (mesh.positions[i] + mesh.positions[i + 1]);
        }
        Scene scene = painted(at({0, 0, -3}));
        add(scene, mesh, Lambert{.color = paint});
        return scene;
    });
    list.look(9, "corners that are NaN and infinite", "finite", [] {
        Mesh mesh = triangle_soup(200, 1, Key(73));
        for (std::size_t i = 0; i < mesh.positions.size(); i += 7) {
            mesh.positions[i].x = std::numeric_limits<float>::quiet_NaN();
            mesh.positions[i / 2].y = std::numeric_limits<float>::infinity();
        }
        Scene scene = painted(at({0, 0, -3}));
        scene.lights.emplace_back(PointLight{.position = {0, 4, -4}, .power = 20});
        add(scene, mesh, Lambert{.color = paint});
        return scene;
    });
}

}  // namespace

void add_cameras(CaseList& list) {
    add_inside(list);
    add_on_surface(list);
    add_directions(list);
    add_projections(list);
}

void add_closed_things(CaseList& list) {
    add_closed_meshes(list);
    add_close_and_far_spheres(list);
    add_degenerate_meshes(list);
}

}  // namespace luch::stress
