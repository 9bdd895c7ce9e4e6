#pragma once

#include "framework/image/image.h"
#include "framework/scene/scene.h"
#include "framework/technique/technique.h"

#include <glm/vec4.hpp>

#include <memory>
#include <span>

// Depth of field from sharp layers (Potmesil and Chakravarty, "A Lens and Aperture Camera Model for
// Synthetic Image Generation", 1981, and what came after). README.md has the idea, the formulas and
// where it fails.
namespace luch::techniques::layered {

/// Premultiplied: light times coverage in r, g, b; coverage, 0..1, in a.
using Rgba = glm::vec4;

/// The scene's thin lens, as a picture of some size sees it.
struct Lens {
    double radius = 0;          ///< world units; 0: a pinhole
    double focal_distance = 1;  ///< of the plane in focus, along the view axis
    /// Pixels that a unit across the view axis spans at distance 1: height/(2m).
    double px_per_unit = 1;
    /// No circle of confusion is larger: this one covers the picture from wherever it is.
    float largest_px = 1;
};
Lens lens_of(const Camera& camera, Size size);

/// The radius in pixels of the circle of confusion, with a sign: negative behind the plane of
/// focus. A point at depth z that the middle of the lens sees at pixel p is seen at p − c·u from
/// the point u of the lens's unit disc, where p is held fixed in the plane of focus.
double signed_radius_px(double z, const Lens& lens);

enum class Axis { x, y };

/// The lecture's steps; a homework replaces one after the other. A step reads what it likes and
/// writes only what is named as its result; any tiling gives the same bits.
struct Steps {
    /// k layers of equal thickness in 1/z, in which circles of confusion grow evenly: the k − 1
    /// depths between them, from near to far. Depths that are not > 0 do not count; infinite ones
    /// do. All cuts are infinite where no depth counts.
    void (*cut)(std::span<const float> depths, int k, std::span<float> cuts);

    /// Diameters of circles of confusion, of points at depth z (along the view axis):
    /// (5/fNumber)·|z − z_f|/(z·z_f)·height/(2m), at most Lens::largest_px, which z ≤ 0 gets too.
    void (*coc)(ImageView<const float> z, const Lens& lens, Tile tile, ImageView<float> px);

    /// Blur along one axis: weights exp(−i²/2σ²) for |i| ≤ 3σ, divided by their sum over the pixels
    /// that are in the picture. σ ≤ 0 copies. A pixel that is not finite stays as it is and is not
    /// spread.
    void (*gaussian)(ImageView<const Rgba> in, float sigma, Axis axis, Tile tile,
                     ImageView<Rgba> out);

    /// Each pixel is spread evenly over the pixels whose centres lie in the disc of diameter coc
    /// around its own; what a pixel receives is divided by the sum of the weights it is received
    /// with, so a constant picture stays constant, at the borders too. coc ≤ 1 copies. A pixel that
    /// is not finite stays as it is and is not spread.
    void (*disc)(ImageView<const Rgba> in, ImageView<const float> coc, Tile tile,
                 ImageView<Rgba> out);

    /// Puts a layer over what is behind it: back ← front + (1 − front.a)·back.
    void (*over)(ImageView<const Rgba> front, Tile tile, ImageView<Rgba> back);
};

/// The steps as the lecture has them.
Steps reference();

/// lens: every lens sample finds its way through the layers, in the picture (Lee, Eisemann and
/// Seidel, "Depth-of-Field Rendering with Multiview Synthesis", 2009). discs: every layer is
/// blurred by discs and they are composited. classic: the lecture's cheap case, two layers, a
/// sharp foreground over a background with a gaussian blur.
enum class Mode { lens, discs, classic };

/// What a user may set.
struct Params {
    int mode = 0;      ///< an index: Mode
    int layers = 0;    ///< K; 0: 64 (lens) or 8 (discs); classic: always two
    int samples = 48;  ///< lens: points of the lens a pixel; they cost no rays
    int detail = 2;    ///< lens: sharp samples a pixel along each axis
};

/// K goes to here.
inline constexpr int most_layers = 200;
/// The layers that a mode has with these parameters.
int layer_count(const Params& params);

/// The technique, made of these steps; each one's holes are filled by the reference.
std::unique_ptr<Technique> make(const Steps& steps, Mode mode = Mode::discs);

/// Its parameter to walk along: K.
extern const std::span<const double> layers_sweep;

}  // namespace luch::techniques::layered
