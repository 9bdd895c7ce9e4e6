#include "scenes/generator/forest.h"

#include "framework/math/rng.h"
#include "scenes/generator/noise.h"
#include "scenes/generator/text.h"
#include "scenes/generator/trees.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luch::assets {
namespace {

constexpr char head[] = R"(// The forest
//
// What it shows: a valley with nine thousand trees, bushes and rocks, of ten kinds. Each kind
// is one mesh (.glb, without a shader here, so the files' own colours are drawn); a Node is no more
// than a name of a mesh and a transform. About 110,000 triangles in memory stand for more than
// 10⁸ in the picture.
//
// Good for: acceleration structures on two levels; memory (a copy of every tree would need a hundred
// times as much); details far below the size of a pixel, for anti-aliasing.
//
// What a renderer may leave out: textures but for the grass, mirrors, refraction, bumps, the lens. One
// sun, far away: one shadow ray for each hit that faces it.
//
// Units: metres. Written by luch_assets (scenes/generator/forest.cpp): change it there.

GlobalSettings {
	frameWidth       640
	frameHeight      480
	ambientLight     (0.34, 0.42, 0.55)
	backgroundColor  (0.60, 0.74, 0.90)
	maxTraceDepth    1
	wantAA           true
}

Camera camera {
	pos              (2, 12, -27)
	yaw              0
	pitch            -7
	fov              60
	aspectRatio      1.3333333
}

PointLight sun {
	pos              (-2600, 2400, -900)
	color            (1, 0.93, 0.80)
	power            22000000
}

)";

/// A kind of plant: its mesh, and how many of a hundred places are its.
struct Kind {
    const char* name;
    int share;
    double least, most;  ///< scale
};
constexpr Kind kinds[] = {
    {"fir1", 20, 0.7, 1.3}, {"fir2", 20, 0.6, 1.2}, {"fir3", 19, 0.8, 1.5}, {"oak1", 12, 0.8, 1.4},
    {"oak2", 13, 0.7, 1.3}, {"bush1", 5, 0.7, 1.6}, {"bush2", 5, 0.7, 1.6}, {"rock1", 2, 0.5, 1.8},
    {"rock2", 2, 0.4, 1.4}, {"rock3", 2, 0.8, 2.6},
};
constexpr double depth = 800, half_width = 460, near_edge = -60;

/// The ground's height, in the scene's coordinates: a valley that rises to hills far away.
double height_at(double x, double z) {
    const double u = x / 1000 + 0.5, v = z / 1000 + 0.1;
    const double hills = Noise(201).fractal(u, v, 7, 7, 4) - 0.5;
    const double far = std::clamp(z / depth, 0.0, 1.0);
    const double beside = std::clamp(std::abs(x - 40 * std::sin(z / 130)) / 260, 0.0, 1.0);
    return 10 * hills + 85 * far * far * (0.5 + 1.1 * hills + 0.5 * far) +
           26 * beside * beside * far;
}

/// How thickly trees stand, 0..1: a glade before the eye and a brook's bank along the valley.
double density_at(double x, double z) {
    const double bank = std::abs(x - 40 * std::sin(z / 130));
    const double open = std::clamp((bank - 5) / 8, 0.0, 1.0);
    const double glade = std::clamp((std::hypot(x, z + 6) - 15) / 9, 0.0, 1.0);
    const double clearing = Noise(203).fractal(x / 1000 + 0.5, z / 1000 + 0.1, 12, 12, 2);
    return std::min(open, glade) * std::clamp(6 * clearing - 1.5, 0.0, 1.0);
}

/// Grass, in a picture that repeats; one joint, so it needs no more than the trees do.
Model ground() {
    constexpr int columns = 92, rows = 86;
    constexpr double metres_a_picture = 14;
    constexpr Byte3 stops[] = {{58, 74, 34}, {86, 104, 46}, {112, 126, 58}, {142, 142, 78}};
    Part part;
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            const double x = half_width * (2.0 * i / columns - 1);
            const double z = near_edge + (depth - near_edge) * j / rows;
            part.points.emplace_back(x, height_at(x, z), -z);  // glTF's z points to the viewer
            part.uvs.emplace_back(x / metres_a_picture, z / metres_a_picture);
        }
    }
    for (std::uint32_t j = 0; j < rows; ++j) {
        for (std::uint32_t i = 0; i < columns; ++i) {
            const std::uint32_t a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1,
                                d = c + 1;
            part.triangles.push_back({a, b, d});
            part.triangles.push_back({a, d, c});
        }
    }
    const IndexedImage grass = painted({128, 128}, stops, [](double x, double y) {
        return 0.75 * Noise(205).fractal(x, y, 16, 16, 3) + 0.25 * Noise(206).at(x, y, 3, 3);
    });
    return {.meshes = {{part}},
            .paints = {{Vec3d(1), 0}},
            .pictures = {{"grass", grass}},
            .joints = {{.mesh = 0}}};
}

const Kind& kind_of(const Key& key) {
    int place = static_cast<int>(key.bits(5) % 100);
    for (const Kind& kind : kinds) {
        if ((place -= kind.share) < 0) return kind;
    }
    return kinds[0];
}

/// One in a cell of a lattice, moved within it; nothing outside of what the camera sees.
std::string nodes() {
    constexpr double cell = 6.3;
    std::string text;
    for (int row = 0; near_edge / 2 + row * cell < depth - 10; ++row) {
        for (int column = -72; column < 72; ++column) {
            const Key key = Key(77).branch(row).branch(static_cast<std::uint64_t>(column + 1000));
            const double x = (column + key.uniform(0)) * cell;
            const double z = near_edge / 2 + (row + key.uniform(1)) * cell;
            if (std::abs(x) > 34 + 0.62 * std::max(z, 0.0) || std::abs(x) > half_width - 5)
                continue;
            if (key.uniform(2) > density_at(x, z)) continue;
            const Kind& kind = kind_of(key);
            const double scale = kind.least + (kind.most - kind.least) * key.uniform(3);
            text += fmt::format(
                "Node {{\ngeometry {}\nscale {}\nrotate {} 0 0\ntranslate {} {} {}\n}}\n",
                kind.name, fmt::format("{0} {0} {0}", number(scale, 2)),
                number(360 * key.uniform(4), 0), number(x, 1), number(height_at(x, z) - 0.1, 1),
                number(z, 1));
        }
    }
    return text;
}

}  // namespace

std::vector<Asset> forest_files() {
    std::vector<Asset> files{{"forest/ground.glb", glb_bytes(ground(), true)}};
    const auto add = [&](const std::string& name, const Model& model) {
        files.push_back({"forest/" + name + ".glb", glb_bytes(model, true)});
    };
    for (int i = 1; i <= 3; ++i) add(fmt::format("fir{}", i), fir(i));
    for (int i = 1; i <= 2; ++i) add(fmt::format("oak{}", i), broadleaf(i));
    for (int i = 1; i <= 2; ++i) add(fmt::format("bush{}", i), bush(i));
    for (int i = 1; i <= 3; ++i) add(fmt::format("rock{}", i), rock(i));

    std::string text = head;
    text +=
        "Mesh ground {\n\tfile             \"ground.glb\"\n\tautoSmooth       on\n}\nNode ground "
        "{\n\tgeometry         ground\n}\n\n";
    for (const Kind& kind : kinds) {
        text += fmt::format("Mesh {0} {{\n\tfile             \"{0}.glb\"\n}}\n", kind.name);
    }
    files.push_back({"forest/forest.scene", text + "\n" + nodes()});
    return files;
}

}  // namespace luch::assets
