#include "scenes/generator/many_lights.h"

#include "scenes/generator/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace luch::assets {
namespace {

constexpr int count = 1000, hues = 36;
constexpr double height = 1.1;

constexpr char head[] = R"(// Many lights
//
// What it shows: a thousand lanterns on a dark square, laid out as the seeds of a sunflower lie, around
// a white ball; each is a point light in a colour of the rainbow. White pillars stand among them and
// have a thousand shadows each.
//
// Good for: whatever chooses among lights: a technique that shoots a shadow ray to each of them for
// every pixel (the classic one does) shows what that costs: 10³ shadow rays a pixel, nearly all of the
// frame's time. Good for seeing bias, too: a light that is left out leaves a hole in the pattern.
//
// What a renderer may leave out: textures, mirrors, refraction, bumps, the environment (black), and
// nearly all lights at nearly every point, if it knows which.
//
// Written by luch_assets (scenes/generator/many_lights.cpp): change it there.

GlobalSettings {
	frameWidth       320
	frameHeight      240
	ambientLight     (0.01, 0.01, 0.02)
	backgroundColor  (0.004, 0.006, 0.016)
	maxTraceDepth    1
	wantAA           false
}

Camera camera {
	pos              (0, 21, -52)
	yaw              0
	pitch            -20
	fov              66
	aspectRatio      1.3333333
}

Lambert stone {
	color            (0.42, 0.42, 0.44)
}
Lambert white {
	color            (0.85, 0.85, 0.85)
}

Plane square {
	y                0
	limit            70
}
Node square {
	geometry         square
	shader           stone
}

Sphere ball {
	O                (0, 6, 0)
	R                6
}
Node ball {
	geometry         ball
	shader           white
}

Cube pillar {
	side             1
}
Sphere lantern {
	R                0.3
}

)";

struct Colour {
    double r, g, b;
};

/// The rainbow, once around, of full saturation: each channel is a raised cosine.
Colour rainbow(int hue) {
    const auto channel = [&](double shift) {
        const double wave =
            0.5 + 0.5 * std::cos(2 * std::numbers::pi * (static_cast<double>(hue) / hues - shift));
        return 0.06 + 0.94 * wave * wave;
    };
    return {channel(0), channel(1.0 / 3), channel(2.0 / 3)};
}

std::string colour_text(const Colour& c) {
    return fmt::format("({}, {}, {})", number(c.r, 3), number(c.g, 3), number(c.b, 3));
}

}  // namespace

std::string many_lights_scene() {
    std::string text = head;
    for (int hue = 0; hue < hues; ++hue) {
        text += fmt::format("Const glow{} {{\n\tcolor            {}\n}}\n", hue,
                            colour_text(rainbow(hue)));
    }
    for (int i = 0; i < 10; ++i) {
        const double turn = 2 * std::numbers::pi * (i + 0.5) / 10;
        text += fmt::format(
            "Node pillar{} {{\n\tgeometry         pillar\n\tshader           white\n"
            "\tscale            (2, 9, 2)\n\trotate           ({}, 0, 0)\n"
            "\ttranslate        ({}, 4.5, {})\n}}\n",
            i, 36 * i, number(22 * std::cos(turn), 2), number(22 * std::sin(turn), 2));
    }
    // H. Vogel, A better way to construct the sunflower head (1979): the golden angle, and the
    // square root of the number as the distance.
    const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
    for (int i = 0; i < count; ++i) {
        const double turn = golden * (i + 24), distance = 1.45 * std::sqrt(i + 24.0);
        const std::string x = number(distance * std::cos(turn), 2);
        const std::string z = number(distance * std::sin(turn), 2);
        const double around = turn / (2 * std::numbers::pi) + distance / 60;
        const int hue = static_cast<int>((around - std::floor(around)) * hues) % hues;
        text += fmt::format(
            "PointLight {{\n\tpos              ({0}, {1}, {2})\n\tcolor            {3}\n"
            "\tpower            0.9\n}}\n"
            "Node {{\n\tgeometry         lantern\n\tshader           glow{4}\n"
            "\ttranslate        ({0}, {5}, {2})\n}}\n",
            x, number(height, 2), z, colour_text(rainbow(hue)), hue, number(height + 0.36, 2));
    }
    return text;
}

}  // namespace luch::assets
