#pragma once

#include "framework/image/image.h"
#include "framework/math/rng.h"
#include "framework/scene/scene.h"
#include "framework/technique/technique.h"

#include <limits>
#include <memory>
#include <span>

// Ambient occlusion in screen space: how much of the light from all around gets to a point, found
// in the picture's own depths. README.md has the idea, the formulas and where it fails.
namespace luch::techniques::ssao {

/// What the passes know of every pixel, in camera space: x right, y up, z forward, world units, the
/// eye at 0.
struct GBuffer {
    ImageView<const Vec3> position;  ///< (0, 0, ∞) where nothing is seen
    ImageView<const Vec3> normal;    ///< unit length; (0, 0, 0) where nothing is seen
};

/// Whether a position is that of something seen.
[[nodiscard]] inline bool is_seen(const Vec3& position) {
    return position.z < std::numeric_limits<float>::infinity();
}

enum class Axis { x, y };

/// How the occlusion is smoothed.
struct Blur {
    float sigma_px = 1.5f;
    int reach_px = 4;
    /// World units: how far from the plane of a pixel another may lie that still counts. Infinity:
    /// all count alike, and shadows bleed over edges.
    float tolerance = std::numeric_limits<float>::infinity();
};

/// bitmask: sectors of slices of the hemisphere are closed, one by one, by what the picture shows
/// (Therrien, Levesque and Gilet, "Screen Space Indirect Lighting with Visibility Bitmask", 2023).
/// gtao: each slice is closed below its horizon (Jiménez et al., "Practical Realtime Strategies for
/// Accurate Indirect Occlusion", 2016). classic: points of the hemisphere, as the lecture has them
/// (Mittring, "Finding Next Gen: CryEngine 2", 2007). rays: the truth, by rays of the same length.
enum class Mode { bitmask, gtao, classic, rays };

enum class Smoothing { edges, gaussian, off };
enum class Normals { surface, picture };
enum class Show { picture, visibility };

/// What a user may set.
struct Params {
    int mode = 0;            ///< an index: Mode
    int samples = 0;         ///< a pixel; 0: 18 (bitmask, gtao), 32 (classic), 256 (rays)
    double radius = 0;       ///< world units; what is farther does not occlude; 0: by the scene
    double thickness = 0.7;  ///< bitmask: of what is seen, along the view ray, in radii
    bool fade = false;       ///< gtao: what is far occludes less, as published
    bool half = false;       ///< half of the frame's resolution, then upsampled
    int smoothing = 0;       ///< an index: Smoothing
    int normals = 0;         ///< an index: Normals: of the surfaces, or found in the picture
    int show = 0;            ///< an index: Show
};

/// The lecture's steps; a homework replaces one after the other. A step reads what it likes and
/// writes only the pixels of its tile of its last argument; any tiling gives the same bits.
struct Steps {
    /// Where pixel centres are in camera space, z being their depths along the view axis. The
    /// screen is perspective. A depth that is not finite and > 0 is nothing seen: (0, 0, ∞).
    void (*positions)(ImageView<const float> z, const Screen& screen, Tile tile,
                      ImageView<Vec3> position);

    /// Unit normals of the surface through the positions, towards the eye: the cross product of a
    /// difference along x and one along y, each taken on the side that belongs to the same surface.
    /// Where an axis has no neighbour that is seen, the direction to the eye. (0, 0, 0) where
    /// nothing is seen.
    void (*normals)(ImageView<const Vec3> position, Tile tile, ImageView<Vec3> normal);

    /// Points in the unit half-ball around +z: their directions have the density cos/π, their
    /// distances from 0 lie in (0, 1]. Other keys give others.
    void (*kernel)(Key key, std::span<Vec3> points);

    /// The share 0..1 of a pixel's points that are hidden. The kernel is turned around the normal
    /// by one of 16 angles, another for each pixel of 4 × 4, and scaled by Params::radius (> 0). A
    /// point is hidden when the surface seen in its pixel is nearer (in z), no farther than the
    /// radius from the pixel's own position (range check), and higher above its tangent plane than
    /// least_sine of their distance. Points beyond the frame or behind the eye count neither way.
    /// 0 where nothing is seen, no point counts, or the radius spans less than a pixel. A normal
    /// that faces away is turned just so far that the surface is seen edge on.
    void (*occlusion)(const GBuffer& seen, const Screen& screen, std::span<const Vec3> kernel,
                      const Params& params, Key key, Tile tile, ImageView<float> occluded);

    /// The mean along one axis with the weights exp(−i²/2σ²)·max(0, 1 − e/tolerance), |i| ≤
    /// reach_px, e the distance of the other position from the pixel's tangent plane; divided by
    /// their sum. What is not seen, or not finite, does not count; such a pixel itself is copied.
    void (*blur)(ImageView<const float> in, const GBuffer& seen, const Blur& blur, Axis axis,
                 Tile tile, ImageView<float> out);

    /// From half resolution: pixel (i, j) of `coarse` is pixel (2i, 2j) of `fine`. The mean of the
    /// one, two or four nearest with the weights max(0, 1 − e/tolerance), e as for `blur`; where
    /// they are all 0, the one with the smallest e. What is not seen does not count; 0 where
    /// nothing does.
    void (*upsample)(ImageView<const float> in, const GBuffer& coarse, const GBuffer& fine,
                     float tolerance, Tile tile, ImageView<float> out);

    /// The light that arrives of the ambient light: a material's albedo is multiplied later.
    void (*apply)(ImageView<const float> visibility, const Rgb& ambient, Tile tile,
                  ImageView<Rgb> light);
};

/// What is seen lower above the tangent plane does not occlude: roundings and pixels' sizes.
inline constexpr float least_sine = 0.01f;

/// The steps as the lecture has them.
Steps reference();

/// The technique, made of these steps; each one's holes are filled by the reference.
std::unique_ptr<Technique> make(const Steps& steps,
                                const Params& params = {.mode = 2, .normals = 1});

/// Its parameter to walk along.
extern const std::span<const double> samples_to_walk;

}  // namespace luch::techniques::ssao
