#include "scenes/generator/toys.h"

#include "scenes/generator/noise.h"
#include "scenes/generator/solids.h"
#include "scenes/generator/textures.h"

#include <cmath>
#include <numbers>

namespace luch::assets {
namespace {

constexpr double quarter = std::numbers::pi / 2;

int add_mesh(Model& model, std::vector<Part> parts) {
    model.meshes.push_back(std::move(parts));
    return static_cast<int>(model.meshes.size()) - 1;
}

/// Adds a joint below another; −1: the root.
int add_joint(Model& model, int parent, Joint joint) {
    const int index = static_cast<int>(model.joints.size());
    model.joints.push_back(std::move(joint));
    if (parent >= 0) model.joints[parent].children.push_back(index);
    return index;
}

/// Rows of stones with dark joints; tiles without a seam.
IndexedImage stones(Size size) {
    constexpr int rows = 8, columns = 6;
    constexpr Byte3 stops[] = {{70, 64, 60}, {150, 138, 124}, {196, 184, 166}, {226, 218, 204}};
    return painted(size, stops, [](double x, double y) {
        const int row = static_cast<int>(y * rows);
        const double across = x * columns + 0.5 * (row % 2);
        const double in_x = across - std::floor(across), in_y = y * rows - row;
        const double edge = std::min({in_x, 1 - in_x, in_y * 0.75, (1 - in_y) * 0.75});
        const int stone = static_cast<int>(across) % columns;
        const double tone = Noise(91).at((stone + 0.5) / columns, (row + 0.5) / rows, 13, 17);
        const double grain = Noise(92).fractal(x, y, 12, 12, 3);
        return edge < 0.05 ? 0.05 : 0.35 + 0.4 * tone + 0.25 * grain;
    });
}

/// Cream with two red bands, for wagons.
IndexedImage bands(Size size) {
    constexpr Byte3 stops[] = {{150, 22, 18}, {176, 34, 26}, {240, 226, 190}, {250, 240, 214}};
    return painted(size, stops, [](double x, double y) {
        const bool red = (y > 0.12 && y < 0.3) || (y > 0.72 && y < 0.86);
        const double grain = 0.12 * Noise(95).fractal(x, y, 4, 24, 2);
        return (red ? 0.1 : 0.8) + grain;
    });
}

std::vector<Part> tower() {
    Part wall{.paint = 0}, foot{.paint = 2}, door{.paint = 3};
    add_frustum(wall, 1.25, 0.85, 0.3, 4, 40, 2);
    add_frustum(foot, 1.6, 1.45, 0, 0.3, 40);
    add_box(door, {0, 0.85, 1.12}, {0.3, 0.55, 0.12});
    return {wall, foot, door};
}

std::vector<Part> cap() {
    Part roof{.paint = 4}, knob{.paint = 3};
    add_frustum(roof, 1.05, 0.12, 0, 1.1, 40);
    add_lathe(knob, {{0, 1.05, 0, -1}, {0.14, 1.19, 1, 0}, {0, 1.33, 0, 1}}, 16);
    return {roof, knob};
}

/// A sail points up from the axle, with its boards in front of the beam.
std::vector<Part> sail() {
    Part beam{.paint = 3}, boards{.paint = 1};
    add_box(beam, {0, 1.15, 0}, {0.05, 1.15, 0.05});
    for (int i = 0; i < 9; ++i) add_box(boards, {0.28, 0.55 + 0.2 * i, 0.06}, {0.27, 0.085, 0.02});
    return {beam, boards};
}

std::vector<Part> wheel() {
    Part rim{.paint = 3}, hub{.paint = 4};
    add_frustum(rim, 0.32, 0.32, -0.07, 0.07, 28);
    add_frustum(hub, 0.12, 0.1, -0.1, 0.12, 16);
    return {rim, hub};
}

std::vector<Part> locomotive() {
    Part body{.paint = 0}, cabin{.paint = 1}, roof{.paint = 4};
    add_box(body, {0, 0.45, 0}, {1.25, 0.14, 0.52});
    add_box(cabin, {-0.8, 1.1, 0}, {0.42, 0.52, 0.5});
    add_box(roof, {-0.8, 1.68, 0}, {0.55, 0.06, 0.6});
    return {body, cabin, roof};
}

/// Along y; its joint lays it down.
std::vector<Part> boiler() {
    Part drum{.paint = 2}, front{.paint = 3};
    add_frustum(drum, 0.45, 0.45, 0, 1.55, 36);
    add_frustum(front, 0.36, 0.3, 1.55, 1.66, 36);
    return {drum, front};
}

std::vector<Part> chimney() {
    Part pipe{.paint = 3}, dome{.paint = 4};
    add_frustum(pipe, 0.13, 0.22, 0, 0.6, 24);
    add_lathe(dome, {{0.2, 0, 1, 0}, {0.2, 0.14, 1, 0.3}, {0.14, 0.26, 0.7, 0.7}, {0, 0.31, 0, 1}},
              24);
    for (Vec3d& p : dome.points) p.x -= 0.62;
    return {pipe, dome};
}

std::vector<Part> wagon() {
    Part floor{.paint = 0}, box{.paint = 1};
    add_box(floor, {0, 0.45, 0}, {0.95, 0.12, 0.5});
    add_box(box, {0, 0.92, 0}, {0.88, 0.36, 0.46});
    return {floor, box};
}

/// A vehicle's axles, each with two wheels that are turned on end.
void add_wheels(Model& model, int vehicle, int mesh, double from, double to, int count) {
    for (int i = 0; i < count; ++i) {
        const double x = from + (to - from) * i / (count - 1);
        const int axle = add_joint(model, vehicle, {.translation = {x, 0.32, 0}});
        for (const double side : {-1.0, 1.0}) {
            add_joint(model, axle,
                      {.mesh = mesh,
                       .translation = {0, 0, 0.52 * side},
                       .axis = {1, 0, 0},
                       .angle = quarter * side});
        }
    }
}

}  // namespace

Model toy_windmill() {
    Model model;
    model.pictures = {{"stones", stones({128, 128})}, {"planks", boards({64, 64})}};
    model.paints = {{Vec3d(1), 0},
                    {Vec3d(1), 1},
                    {{0.32, 0.30, 0.28}},
                    {{0.20, 0.09, 0.04}},
                    {{0.55, 0.06, 0.04}}};
    const int root = add_joint(model, -1, {.mesh = add_mesh(model, tower())});
    const int top = add_joint(model, root,
                              {.mesh = add_mesh(model, cap()),
                               .translation = {0, 4, 0},
                               .axis = {0, 1, 0},
                               .angle = 0.35});
    const int axle =
        add_joint(model, top, {.translation = {0, 0.35, 1.05}, .axis = {0, 0, 1}, .angle = 0.4});
    const int mesh = add_mesh(model, sail());
    for (int i = 0; i < 4; ++i) {
        add_joint(model, axle, {.mesh = mesh, .axis = {0, 0, 1}, .angle = quarter * i});
    }
    return model;
}

Model toy_train() {
    Model model;
    model.pictures = {{"wood", boards({64, 64})}, {"bands", bands({64, 64})}};
    model.paints = {{Vec3d(1), 0},
                    {Vec3d(1), 1},
                    {{0.04, 0.16, 0.30}},
                    {{0.05, 0.05, 0.06}},
                    {{0.70, 0.45, 0.06}},
                    // The same picture for the wagons, in a colour of their own.
                    {{0.35, 0.75, 0.40}, 1}};
    const int train = add_joint(model, -1, {});
    const int engine = add_joint(model, train, {.mesh = add_mesh(model, locomotive())});
    add_joint(model, engine,
              {.mesh = add_mesh(model, boiler()),
               .translation = {-0.4, 1.0, 0},
               .axis = {0, 0, 1},
               .angle = -quarter});
    add_joint(model, engine, {.mesh = add_mesh(model, chimney()), .translation = {0.8, 1.4, 0}});
    const int rolling = add_mesh(model, wheel());
    add_wheels(model, engine, rolling, -0.85, 0.85, 3);
    std::vector<Part> green = wagon();
    green[1].paint = 5;
    const int cars[] = {add_mesh(model, wagon()), add_mesh(model, green)};
    for (int i = 0; i < 2; ++i) {
        const int car =
            add_joint(model, train, {.mesh = cars[i], .translation = {-2.45 - 2.15 * i, 0, 0}});
        add_wheels(model, car, rolling, -0.55, 0.55, 2);
    }
    return model;
}

}  // namespace luch::assets
