#include "homework/vista/check/paint.h"
#include "homework/vista/mutants/mutants.h"

namespace luch::homework::vista {

using namespace techniques::vista;

std::vector<grading::Other> raster_mutants() {
    using Tie = PaintRules::Tie;
    return {
        {"no_half_pixel", "vista.t6", "pixels are looked at in their corners: add ½ to x and y",
         with(&Steps::rasterise, Painter<double, PaintRules{.centre = 0}>::rasterise)},
        {"affine_depth", "vista.t6", "z is interpolated instead of 1/z",
         with(&Steps::rasterise, Painter<double, PaintRules{.affine = true}>::rasterise)},
        {"edges_twice", "vista.t6", "a centre on an edge is painted by both neighbours",
         with(&Steps::rasterise, Painter<double, PaintRules{.tie = Tie::both}>::rasterise)},
        {"edges_never", "vista.t6", "a centre on an edge is painted by none of the neighbours",
         with(&Steps::rasterise, Painter<double, PaintRules{.tie = Tie::neither}>::rasterise)},
        {"farthest_wins", "vista.t6", "the depth comparison is the wrong way round",
         with(&Steps::rasterise, Painter<double, PaintRules{.farthest = true}>::rasterise)},
        {"never_painted_over", "vista.t6", "Hidden::painter compares depths, too",
         with(&Steps::rasterise, Painter<double, PaintRules{.always_depth = true}>::rasterise)},
        {"column_short", "vista.t6", "the last column of a tile is left out",
         with(&Steps::rasterise, Painter<double, PaintRules{.one_more = -1}>::rasterise)},
    };
}

}  // namespace luch::homework::vista
