// Homework: shadow maps, step by step. This is the only file to edit; README.md (and README.bg.md)
// has the tasks. What is not written yet is done by the reference, so begin where you like.
// techniques/shadow_map/shadow_map.h says what each step is given and what it must leave behind.
#include "framework/technique/catalogue.h"
#include "framework/technique/todo.h"
#include "techniques/shadow_map/shadow_map.h"
#include "techniques/shadow_map/stress.h"

#include <algorithm>
#include <cmath>

namespace luch::homework::shadow_map {
namespace {

using namespace techniques::shadow_map;

/// t1. A direction leaves the cube through the face of its largest |component| (of equal ones the
/// first of x, y, z). Divided by that |component| its other two are the place on the face, −1..1:
/// face 2·a + s looks along axis a, against it when s is 1; x runs with the next axis (x → y → z →
/// x), y with the one after that. There are n texels from −1 to 1; a place at 1 is in the last one.
/// What is zero or not finite goes through {0, n/2, n/2}.
void texel_of(std::span<const Vec3> directions, int n, std::span<Texel> texels) {
    LUCH_TODO("shadow_map.t1");
}

/// t2. Backwards: the directions through the texels' centres, of length 1.
void direction_of(std::span<const Texel> texels, int n, std::span<Vec3> directions) {
    LUCH_TODO("shadow_map.t2");
}

/// t3. One ray through the centre of each texel (x, y) of a tile of the face, from the light:
/// tracer.closest() with RayKind::shadow and t_min = 0. Write its distance (not its depth along the
/// axis), infinity where it meets nothing. `distance` is an image of the tile only: (x, y) lies at
/// (x − tile.x0, y − tile.y0).
void render_face(const Vec3d& light, int face, int n, Tile tile, Tracer& tracer,
                 ImageView<float> distance) {
    LUCH_TODO("shadow_map.t3");
}

/// t4. The receiver's plane is seen from the light at the distance D(u, v) through the place (u, v)
/// of the face. The centre of its texel is up to half a texel, 1/n, away in u and in v, so what is
/// stored there may be nearer by (|∂D/∂u| + |∂D/∂v|)/n. That is the bias, and rounding_share of the
/// distance besides.
void bias(std::span<const Receiver> receivers, int n, std::span<float> biases) {
    LUCH_TODO("shadow_map.t4");
}

/// t5. 1 when the receiver is no farther than what its texel stores plus its bias, else 0.
void lit(const CubeMap& map, std::span<const Receiver> receivers, std::span<const float> biases,
         std::span<float> shares) {
    LUCH_TODO("shadow_map.t5");
}

/// t6. The mean of that answer over the 3 × 3 texels around the receiver's. Past an edge of the
/// face they are the neighbouring face's; past a corner there is none, and the mean is of eight.
void pcf(const CubeMap& map, std::span<const Receiver> receivers, std::span<const float> biases,
         std::span<float> shares) {
    LUCH_TODO("shadow_map.t6");
}

/// t7. n points on the light, each with 1/n of its power: in the middles of c × r equal cells
/// (regular), anywhere in each of them (jittered) or anywhere (random). r is the largest divisor of
/// n that is ≤ √n, c = n/r lie along the light's x. key.square(i) is where the i-th point is at
/// random, 0..1; lifted_off() takes a place, −½..½, to the world.
void light_points(const RectLight& light, int n, Pattern pattern, Key key,
                  std::vector<LightPoint>& points) {
    LUCH_TODO("shadow_map.t7");
}

}  // namespace

/// What the technique is made of, and what `luch check shadow_map` tries.
Steps steps() {
    return {texel_of, direction_of, render_face, bias, lit, pcf, light_points};
}

TechniqueInfo describe() {
    return {.name = "homework/shadow_map",
            .title = "shadow maps: yours",
            .topic = "5. shadow maps",
            .create = [] { return make(steps()); },
            .sweep = {"side", side_sweep, -0.5},
            .stress_cases = stress_cases};
}

}  // namespace luch::homework::shadow_map
