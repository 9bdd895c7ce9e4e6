#pragma once

#include "framework/image/image.h"
#include "framework/math/rng.h"
#include "framework/scene/light.h"
#include "framework/technique/technique.h"
#include "framework/trace/tracer.h"

#include <array>
#include <limits>
#include <memory>
#include <span>
#include <vector>

// Shadow maps (Williams, "Casting Curved Shadows on Curved Surfaces", SIGGRAPH 1978) of distance,
// on the faces of a cube around each light. README.md has the idea, the formulas and where it
// fails.
namespace luch::techniques::shadow_map {

/// A texel of a cube map. Face 2·a + s looks along axis a (0: x, 1: y, 2: z), against it when s is
/// 1. On a face, x runs with the axis after a and y with the one after that (x → y → z → x), from
/// −1 to 1 across the n texels; no face is mirrored.
struct Texel {
    int face = 0;
    int x = 0, y = 0;
    bool operator==(const Texel&) const = default;
};

inline constexpr int faces_of_cube = 6;

/// The part of a face that is stored: nothing receives light through the rest.
struct Face {
    Tile window;            ///< its texels
    Image<float> distance;  ///< of texel (x, y) at (x − window.x0, y − window.y0)
};

/// The distance from a light to the nearest surface, in n × n texels a face.
struct CubeMap {
    int n = 0;
    std::array<Face, faces_of_cube> faces;

    /// What is stored; infinity where there is no surface, and where nothing is stored.
    [[nodiscard]] float at(const Texel& texel) const {
        const auto& [window, distance] = faces[static_cast<std::size_t>(texel.face)];
        const bool stored = texel.x >= window.x0 && texel.x < window.x1 && texel.y >= window.y0 &&
                            texel.y < window.y1;
        return stored ? distance(texel.x - window.x0, texel.y - window.y0)
                      : std::numeric_limits<float>::infinity();
    }
};

/// A point of a surface, as a light sees it.
struct Receiver {
    Vec3 from_light{
        0};          ///< from the light to the point, in world units; its length is the distance
    Vec3 normal{0};  ///< geometric, of unit length, on either side of the surface
};

/// Where the points of a light with an area lie: in the middles of equal cells, one anywhere in
/// each cell, or anywhere.
enum class Pattern { regular, jittered, random };

/// A point light that stands for a part of a light with an area.
struct LightPoint {
    Vec3d position{0};  ///< lifted off the light's own visible face
    float share = 1;    ///< of the light's power
};

/// The lecture's steps; a homework replaces one after the other. A step reads what it likes and
/// writes only what is named as its result; any tiling gives the same bits.
struct Steps {
    /// The texel that a direction (of any length) goes through: the face of its largest |component|
    /// (of equal ones the first), and on it x = ⌊(u + 1)/2 · n⌋, where u is the face's x component
    /// divided by that largest |component|, kept within 0..n − 1; y likewise. A direction that is
    /// zero, or not finite, goes through {0, n/2, n/2}.
    void (*texel_of)(std::span<const Vec3> directions, int n, std::span<Texel> texels);

    /// The unit directions through the centres of texels: on a face, u = (2x + 1)/n − 1.
    void (*direction_of)(std::span<const Texel> texels, int n, std::span<Vec3> directions);

    /// A tile of a face of n × n texels: how far the nearest surface is from the light through the
    /// centre of texel (x, y), in world units, into distance(x − tile.x0, y − tile.y0); infinity
    /// where there is none. `distance` is as large as the tile. The rays are shadow rays
    /// (RayKind::shadow), one a texel, start in the light, and have t_min = 0.
    void (*render_face)(const Vec3d& light, int face, int n, Tile tile, Tracer& tracer,
                        ImageView<float> distance);

    /// By how much a distance through a texel's centre may fall short of that of a receiver in the
    /// texel, on the same plane: ½h(|∂D/∂u| + |∂D/∂v|), where h = 2/n, u and v are coordinates on
    /// the face of the cube, −1..1, and the gradient of the plane's distance D(u, v) is taken at
    /// the receiver; and rounding_share of the distance. Infinite where the receiver's plane goes
    /// through the light; 0 where the receiver is in the light.
    void (*bias)(std::span<const Receiver> receivers, int n, std::span<float> biases);

    /// 1 where light arrives, else 0: a receiver is lit when its distance is ≤ what is stored in
    /// its texel plus its bias. One in the light (distance 0) is lit.
    void (*lit)(const CubeMap& map, std::span<const Receiver> receivers,
                std::span<const float> biases, std::span<float> shares);

    /// Percentage-closer filtering (Reeves, Salesin and Cook, "Rendering Antialiased Shadows with
    /// Depth Maps", SIGGRAPH 1987): the mean of that comparison over the 3 × 3 texels around the
    /// receiver's. Past an edge of the face they go on in the neighbouring face's rim, in the same
    /// row. Past a corner, where three faces meet, there is no ninth texel: the mean is of the
    /// eight. The bias must be that of pcf_width texels.
    void (*pcf)(const CubeMap& map, std::span<const Receiver> receivers,
                std::span<const float> biases, std::span<float> shares);

    /// `n` point lights in the place of a light with an area, of equal power: on a grid of c × r
    /// equal cells (regular, jittered), where r is the largest divisor of n that is ≤ √n and c =
    /// n/r; row by row, c of them along the light's x, r along its z. Random numbers: jittered and
    /// random take key.square(i) for the i-th point. Positions are lifted by lifted_off(). `points`
    /// is replaced.
    void (*light_points)(const RectLight& light, int n, Pattern pattern, Key key,
                         std::vector<LightPoint>& points);
};

/// The steps as the lecture has them.
Steps reference();

/// Of a distance, what rounding takes: in the ray to the texel's centre, and in the receiver.
inline constexpr float rounding_share = 0x1p-18f;

/// pcf() looks at texels whose centres are up to 1½ texels away along each axis: three times as far
/// as lit(); past an edge of the cube rows lean by another half. So its bias is that of lit() so
/// many times.
inline constexpr float pcf_width = 4;

/// A point of a light's square, −½..½ along x and z, in world space, and off its visible face by
/// more than rounding.
Vec3d lifted_off(const RectLight& light, double x, double z);

/// classic: the map's answer is taken, by lit() or pcf(). pcss: the width of the penumbra is found
/// first (Fernando 2005). vsm, msm: blurred moments (Donnelly and Lauritzen 2006; Peters and Klein
/// 2015). heuristic: shadow rays only where the neighbourhood disagrees. exact: an item buffer that
/// misses nothing, and shadow rays where it does not know.
enum class Mode { classic, pcss, vsm, msm, heuristic, exact };

enum class Layout { cube, sphere };

/// What a user may set.
struct Params {
    int mode = 0;        ///< an index: Mode
    int side = 512;      ///< texels along an edge of a face; the points of a light share them
    bool pcf = true;     ///< classic: the mean of 3 × 3 comparisons, or one
    int layout = 0;      ///< classic: an index: Layout
    double bias = 1.01;  ///< times the bias that geometry asks for
    bool offset = true;  ///< classic: an offset along the normal in its place, at grazing angles
    bool fit = true;  ///< a far light's faces are cut to what receives its light, and divided finer
    int points = 16;  ///< point lights that stand for a light with an area
    int pattern = 1;  ///< an index: Pattern
    int memory = 128;     ///< MB of maps; the lights beyond that are left to rays
    bool judge = false;   ///< planes of what is wrong, by a shadow ray for every answer
    bool unwrap = false;  ///< the frame shows the first light's faces
};

/// The technique, made of these steps; each one's holes are filled by the reference.
std::unique_ptr<Technique> make(const Steps& steps, Mode mode = Mode::classic);

/// Its parameter to walk along: the side.
extern const std::span<const double> side_sweep;

}  // namespace luch::techniques::shadow_map
