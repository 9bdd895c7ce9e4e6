#include "scenes/generator/sixty_spheres.h"

#include "framework/math/rng.h"
#include "scenes/generator/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace luch::assets {
namespace {

constexpr int count = 60;
constexpr std::uint64_t seed = 62;

constexpr char head[] = R"(// Sixty spheres
//
// What it shows: sixty balls of many sizes above a checker floor, some lying, some hanging in the air
// before an empty sky, so that their outlines stand against other balls, the floor and nothing at all.
//
// Good for: primary visibility by rasterisation (vista). Every ball's outline is a test: a polyhedron
// inside the ball loses pixels along it, one around the ball loses none. Good for adaptive sampling
// too: round edges everywhere, flat colour between them.
//
// What a renderer may leave out: mirrors and refraction (no material asks for them), the environment
// (one colour), texture coordinates everywhere but on the floor, bumps, the lens. One point light: one
// shadow ray for each hit that faces it.
//
// Written by luch_assets (scenes/generator/sixty_spheres.cpp): change it there.

GlobalSettings {
	frameWidth       640
	frameHeight      480
	ambientLight     (0.22, 0.24, 0.28)
	backgroundColor  (0.32, 0.52, 0.80)
	maxTraceDepth    1
	wantAA           false
}

Camera camera {
	pos              (0, 38, -90)
	yaw              0
	pitch            -17
	fov              58
	aspectRatio      1.3333333
}

PointLight sun {
	pos              (-60, 90, -70)
	color            (1, 0.96, 0.88)
	power            13500
}

CheckerTexture squares {
	color1           (0.62, 0.60, 0.55)
	color2           (0.16, 0.17, 0.20)
	scaling          6
}

Lambert floor {
	texture          squares
}

Plane floor {
	y                0
	limit            48
}

Node floor {
	geometry         floor
	shader           floor
}
)";

struct Paint {
    const char* name;
    const char* colour;
    bool glossy;
};
constexpr Paint paints[] = {
    {"red", "(0.72, 0.07, 0.06)", true},     {"orange", "(0.85, 0.30, 0.04)", false},
    {"yellow", "(0.88, 0.62, 0.08)", true},  {"green", "(0.12, 0.45, 0.12)", false},
    {"teal", "(0.03, 0.40, 0.42)", true},    {"blue", "(0.07, 0.14, 0.60)", true},
    {"violet", "(0.32, 0.10, 0.45)", false}, {"white", "(0.80, 0.78, 0.74)", true},
};

bool touches(const Ball& ball, const std::vector<Ball>& others) {
    return std::any_of(others.begin(), others.end(), [&](const Ball& other) {
        const Vec3d apart = ball.centre - other.centre;
        const double room = 1.04 * (ball.radius + other.radius);
        return glm::dot(apart, apart) < room * room;
    });
}

/// The ball's place in its `attempt`-th throw, rounded as the file will hold it.
Ball thrown(int index, int attempt) {
    const Key key = Key(seed).branch(index).branch(attempt);
    const double rank = double(index) / (count - 1);
    const double radius = 6.6 - 4.6 * rank;
    const bool lies = index % 3 != 0;
    const double reach = lies ? 43 : 38;
    const double across = reach * (2 * key.uniform(0) - 1);
    const double depth = reach * (2 * key.uniform(1) - 1);
    const double height = lies ? 0 : 10 + 26 * key.uniform(2);
    const auto rounded = [](double value) { return std::round(value * 100) / 100; };
    const double r = rounded(radius);
    return {{rounded(across), r + rounded(height), rounded(depth)},
            r,
            static_cast<int>((index * 5 + index / 8) % std::size(paints))};
}

}  // namespace

std::vector<Ball> sixty_balls() {
    std::vector<Ball> balls;
    for (int index = 0; index < count; ++index) {
        int attempt = 0;
        while (attempt < 10000 && touches(thrown(index, attempt), balls)) ++attempt;
        if (attempt == 10000) throw std::logic_error("no room for a ball: make them smaller");
        balls.push_back(thrown(index, attempt));
    }
    return balls;
}

std::string sixty_spheres_scene() {
    std::string text = head;
    for (const auto& [name, colour, glossy] : paints) {
        text += fmt::format("\n{} {} {{\n\tcolor            {}\n", glossy ? "Phong" : "Lambert",
                            name, colour);
        text += glossy ? "\tspecular         0.5\n\texponent         60\n}\n" : "}\n";
    }
    int index = 0;
    for (const Ball& ball : sixty_balls()) {
        text += fmt::format(
            "\nSphere ball{0} {{\n\tO                ({1}, {2}, {3})\n\tR                {4}\n}}\n"
            "Node ball{0} {{\n\tgeometry         ball{0}\n\tshader           {5}\n}}\n",
            index++, number(ball.centre.x, 2), number(ball.centre.y, 2), number(ball.centre.z, 2),
            number(ball.radius, 2), paints[ball.colour].name);
    }
    return text;
}

}  // namespace luch::assets
