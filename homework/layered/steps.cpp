// Homework: depth of field from layers, step by step. This is the only file to edit; README.md (and
// README.bg.md) has the tasks. What is not written yet is done by the reference, so begin where you
// like. techniques/layered/layered.h says what each step is given and what it must leave behind.
#include "framework/technique/catalogue.h"
#include "framework/technique/todo.h"
#include "techniques/layered/layered.h"
#include "techniques/layered/stress.h"

namespace luch::homework::layered {
namespace {

using namespace techniques::layered;

/// t1. Blur grows with |1/z − 1/z_f|, so layers that are equally thick in 1/z are equally thick in
/// blur. Find the nearest and the farthest depth (only depths > 0 count; an infinite one has
/// 1/z = 0), divide the way between their inverses into k equal parts, and write the k − 1 depths
/// between the parts, from near to far. Infinity for all of them when no depth counts.
void cut(std::span<const float> depths, int k, std::span<float> cuts) {
    LUCH_TODO("layered.t1");
}

/// t2. A point at depth z is seen through the whole lens as a disc with the diameter
/// 2·radius·|z − z_f|/(z·z_f)·px_per_unit pixels, z_f = focal_distance. What is the limit at
/// z = ∞? At most largest_px, which is also the answer for z ≤ 0.
void coc(ImageView<const float> z, const Lens& lens, Tile tile, ImageView<float> px) {
    LUCH_TODO("layered.t2");
}

/// t3. Along one axis, every pixel becomes the mean of its neighbours with the weights
/// exp(−i²/2σ²), i = −R…R, R = ⌈3σ⌉. Near a border some neighbours are not there: divide by the
/// weights of those that are. σ ≤ 0 copies. A pixel that is not finite stays as it is, and nobody
/// else gets anything of it.
void gaussian(ImageView<const Rgba> in, float sigma, Axis axis, Tile tile, ImageView<Rgba> out) {
    LUCH_TODO("layered.t3");
}

/// t4. Pixel q hands out its colour evenly: 1/n(q) of it to each of the n(q) pixels whose centres
/// are at most coc(q)/2 from its own (q itself is one of them; n counts those beyond the border,
/// too). Pixel p collects from all q whose discs reach it, and divides by the sum of the 1/n(q).
/// What is not finite stays as it is and is not handed out.
void disc(ImageView<const Rgba> in, ImageView<const float> coc, Tile tile, ImageView<Rgba> out) {
    LUCH_TODO("layered.t4");
}

/// t5. Colours are premultiplied: light times coverage. back ← front + (1 − front.a)·back, all
/// four channels. What is behind full coverage must not matter, were it infinite.
void over(ImageView<const Rgba> front, Tile tile, ImageView<Rgba> back) {
    LUCH_TODO("layered.t5");
}

}  // namespace

/// What the technique is made of, and what `luch check layered` tries.
Steps steps() {
    return {cut, coc, gaussian, disc, over};
}

TechniqueInfo describe() {
    return {.name = "homework/layered",
            .title = "depth of field from layers: yours",
            .topic = "4. layers and depth of field",
            .create = [] { return make(steps()); },
            .sweep = {"layers", layers_sweep},
            .whole_lens = true,
            .stress_cases = stress_cases};
}

}  // namespace luch::homework::layered
