// Homework: ambient occlusion in screen space, step by step. This is the only file to edit;
// README.md (and README.bg.md) has the tasks. What is not written yet is done by the reference, so
// begin where you like. techniques/ssao/ssao.h says what each step is given and what it must leave
// behind.
#include "framework/technique/catalogue.h"
#include "framework/technique/todo.h"
#include "techniques/ssao/ssao.h"
#include "techniques/ssao/stress.h"
#include "techniques/ssao/view.h"

namespace luch::homework::ssao {
namespace {

using namespace techniques::ssao;

/// t1. Camera space: x right, y up, z forward. screen.across() and screen.upwards() say where a
/// point of the frame lies on the plane at distance 1; z is a depth along the view axis, not along
/// the ray. Pixels are seen through their centres. Nothing seen (a depth that is not finite, or not
/// > 0): (0, 0, ∞).
void positions(ImageView<const float> z, const Screen& screen, Tile tile,
               ImageView<Vec3> position) {
    LUCH_TODO("ssao.t1");
}

/// t2. The cross product of a step along x and a step along y, of unit length and towards the eye
/// (which is at 0). A step goes to a neighbour that is seen, and that lies on the same surface:
/// across an edge it would make a normal of neither. One axis without any neighbour: the direction
/// to the eye. Nothing seen: (0, 0, 0).
void normals(ImageView<const Vec3> position, Tile tile, ImageView<Vec3> normal) {
    LUCH_TODO("ssao.t2");
}

/// t3. Points in the half-ball around +z: directions with the density cos/π (a point of the disc,
/// lifted to the half-sphere), distances from 0 in (0, 1]. The same key gives the same points,
/// another key others. key.uniform(i) is a random number of [0, 1), for every i another.
void kernel(Key key, std::span<Vec3> points) {
    LUCH_TODO("ssao.t3");
}

/// t4. The share of the kernel's points that are hidden: put around the normal, turned about it by
/// one of 16 angles (another for each pixel of 4 × 4, and others with another key), scaled by
/// params.radius. A point is hidden by the surface seen in the pixel that it falls on, if that is
/// nearer in z, not farther than the radius from *this* pixel's position, and higher above its
/// tangent plane than least_sine of that distance. A point off the frame does not count at all.
void occlusion(const GBuffer& seen, const Screen& screen, std::span<const Vec3> kernel,
               const Params& params, Key key, Tile tile, ImageView<float> occluded) {
    LUCH_TODO("ssao.t4");
}

/// t5. Along one axis, the mean of the neighbours with the weights exp(−i²/2σ²)·max(0, 1 −
/// e/tolerance), |i| ≤ reach_px; e is how far the neighbour's position lies from *this* pixel's
/// tangent plane. What is not seen, or not finite, does not count, and stays as it is.
void blur(ImageView<const float> in, const GBuffer& seen, const Blur& blur, Axis axis, Tile tile,
          ImageView<float> out) {
    LUCH_TODO("ssao.t5");
}

/// t6. Pixel (i, j) of the small picture stands at pixel (2i, 2j) of the large one. Between them,
/// the mean of the two or four nearest that are seen, with the weights max(0, 1 − e/tolerance);
/// where these are all 0, the one with the smallest e.
void upsample(ImageView<const float> in, const GBuffer& coarse, const GBuffer& fine,
              float tolerance, Tile tile, ImageView<float> out) {
    LUCH_TODO("ssao.t6");
}

/// t7. What arrives of the ambient light where a share of it is visible.
void apply(ImageView<const float> visibility, const Rgb& ambient, Tile tile, ImageView<Rgb> light) {
    LUCH_TODO("ssao.t7");
}

}  // namespace

/// What the technique is made of, and what `luch check ssao` tries.
Steps steps() {
    return {positions, normals, kernel, occlusion, blur, upsample, apply};
}

TechniqueInfo describe() {
    return {.name = "homework/ssao",
            .title = "ambient occlusion in screen space: yours",
            .topic = "6. ambient light",
            .create = [] { return make(steps()); },
            .sweep = {"samples", samples_to_walk},
            .approximates = false,
            .truth = "mode=rays",
            .stress_cases = stress_cases};
}

}  // namespace luch::homework::ssao
