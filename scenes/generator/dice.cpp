#include "scenes/generator/dice.h"

#include "framework/math/vec.h"
#include "scenes/generator/text.h"

#include <fmt/format.h>

#include <vector>

namespace luch::assets {
namespace {

constexpr char head[] = R"(// Three dice
//
// What it shows: constructive solid geometry. A die is a cube, cut by a ball that takes the corners
// off, less twenty-one small balls that leave the pips: CSGInter, then CSGDiff. The paint in the pips
// is a solid of its own: what the pips took out of the body, less slightly smaller balls, which
// leaves a thin shell in every pip. The three dice share all their geometry.
//
// Good for: solids that meet each other everywhere, entering and leaving. The red die is clear: a ray
// through it must know at every surface, also in a pip, whether it goes in or out (Snell's law), and
// how long it was inside (Beer's law: the thick of the die is deeper red than its rim).
//
// What a renderer may leave out: the lens, bumps, glossy reflection; texture coordinates of everything
// but the table. Not the sky: the clear die and the polish reflect it.
//
// The edge of a die is 2. Written by luch_assets (scenes/generator/dice.cpp): change it there.

GlobalSettings {
	frameWidth       640
	frameHeight      480
	ambientLight     (0.16, 0.15, 0.15)
	maxTraceDepth    9
	wantAA           true
}

Camera camera {
	pos              (0.2, 5.6, -10)
	yaw              -1
	pitch            -27
	fov              49
	aspectRatio      1.3333333
}

RectLight lamp {
	color            (1, 0.94, 0.84)
	power            150
	xSubd            4
	ySubd            4
	scale            (4, 1, 4)
	rotate           (0, 0, -35)
	translate        (-7, 10, -3)
}

PointLight window {
	pos              (9, 8, -7)
	color            (0.70, 0.82, 1)
	power            34
}

CubemapEnvironment sky {
	folder           "sky"
	assumedGamma     2.2
}

// ---- materials

BitmapTexture boards {
	file             "boards.bmp"
	scaling          9
	assumedGamma     2.2
}

Lambert wood {
	texture          boards
}

Phong ivory {
	color            (0.84, 0.79, 0.66)
	specular         0.35
	exponent         70
}

Phong ebony {
	color            (0.035, 0.035, 0.045)
	specular         0.6
	exponent         90
}

Lambert ink {
	color            (0.02, 0.02, 0.03)
}

Lambert chalk {
	color            (0.85, 0.85, 0.80)
}

Reflection mirror {
	reflColor        (1, 1, 1)
}

Refraction clear_red {
	refrColor        (1, 1, 1)
	ior              1.5
	insideColor      (0.95, 0.12, 0.10)
	absorption       0.75
}

Fresnel polish {
	ior              1.5
}

Layered ivory_polished {
	layer ivory      (1, 1, 1)
	layer mirror     (1, 1, 1) polish
}

Layered ebony_polished {
	layer ebony      (1, 1, 1)
	layer mirror     (1, 1, 1) polish
}

Layered glass {
	layer clear_red  (1, 1, 1)
	layer mirror     (1, 1, 1) polish
}

// ---- the table

Plane table {
	y                0
	limit            60
}

Node table {
	geometry         table
	shader           wood
}

// ---- the die

Cube cube {
	side             2
}

Sphere corners {
	R                1.42
}

CSGInter body {
	left             cube
	right            corners
}
)";

/// Where the pips' balls are: a little above the six faces, opposite faces together seven.
std::vector<Vec3d> pip_centres() {
    constexpr double out = 1.07, side = 0.46;
    struct Face {
        Vec3d up, right, over;
        int count;
    };
    const Face faces[] = {
        {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}, 5},  {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}, 2},
        {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 3}, {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, 4},
        {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1},  {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}, 6},
    };
    std::vector<Vec3d> centres;
    for (const auto& [up, right, over, count] : faces) {
        const auto add = [&, up = up, right = right, over = over](double x, double y) {
            centres.push_back(out * up + side * (x * right + y * over));
        };
        if (count % 2 == 1) add(0, 0);
        if (count > 1) {
            add(-1, -1);
            add(1, 1);
        }
        if (count > 3) {
            add(-1, 1);
            add(1, -1);
        }
        if (count > 5) {
            add(-1, 0);
            add(1, 0);
        }
    }
    return centres;
}

/// A ball for every pip, and their union, as a chain.
std::string pips(std::string_view name, double radius) {
    std::string text;
    const std::vector<Vec3d> centres = pip_centres();
    for (std::size_t i = 0; i < centres.size(); ++i) {
        const Vec3d& c = centres[i];
        text += fmt::format(
            "\nSphere {}_ball{} {{\n\tO                ({}, {}, {})\n"
            "\tR                {}\n}}\n",
            name, i, number(c.x, 3), number(c.y, 3), number(c.z, 3), number(radius, 3));
        if (i == 0) continue;
        const bool last = i + 1 == centres.size();
        text += fmt::format(
            "\nCSGUnion {} {{\n\tleft             {}\n"
            "\tright            {}_ball{}\n}}\n",
            last ? std::string(name) : fmt::format("{}_to{}", name, i),
            i == 1 ? fmt::format("{}_ball0", name) : fmt::format("{}_to{}", name, i - 1), name, i);
    }
    return text;
}

constexpr char solids[] = R"(
CSGDiff die {
	left             body
	right            pips
}

CSGInter pip_fill {
	left             body
	right            pips
}

CSGDiff pip_paint {
	left             pip_fill
	right            inner_pips
}
)";

/// A die with its paint, in one place.
std::string die(std::string_view name, std::string_view shader, std::string_view paint,
                std::string_view lines) {
    return fmt::format(
        "\nNode {} {{\n\tgeometry         die\n\tshader           {}\n{}}}\n"
        "\nNode {}_pips {{\n\tgeometry         pip_paint\n"
        "\tshader           {}\n{}}}\n",
        name, shader, lines, name, paint, lines);
}

}  // namespace

std::string dice_scene() {
    return head + pips("pips", 0.23) + pips("inner_pips", 0.222) + solids +
           die("ivory_die", "ivory_polished", "ink",
               "\trotate           (28, 0, 0)\n\ttranslate        (-2.1, 1, 0.6)\n") +
           die("red_die", "glass", "chalk",
               "\trotate           (-24, 90, 0)\n\ttranslate        (0.9, 1, -1.2)\n") +
           die("black_die", "ebony_polished", "chalk",
               "\trotate           (52, 0, 90)\n\ttranslate        (2.3, 1, 2.6)\n");
}

}  // namespace luch::assets
