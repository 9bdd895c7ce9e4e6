#pragma once

#include "scenes/generator/bezier.h"

#include <string_view>
#include <vector>

namespace luch::assets {

/// Patches side by side: `across` of them close a ring in u, `along` rings follow one another in v,
/// the last row of each being the first of the next. The patch (ring, place) is
/// patches[ring · across + place].
struct Sheet {
    std::string_view name;
    int across;
    int along;
    std::vector<Patch> patches;
    bool starts_in_point = false;  ///< the first row of the first ring is one point
    bool ends_in_point = false;    ///< the last row of the last ring is one point
};

/// The Utah teapot (Martin Newell, The Utilization of Procedure Models in Digital Image Synthesis,
/// PhD thesis, University of Utah, 1975), with the bottom that F. C. Crow (The Origins of the
/// Teapot, IEEE CG&A 7(1), 1987) gave it: 32 patches in the four sheets body, lid, handle and
/// spout. Their own coordinates, but y up: x points along the spout, y runs from 0 to 3.15.
///
/// The published list has 306 points. Most are turns and mirror images of one another; here stand
/// only the profiles and half rings that they come from.
std::vector<Sheet> newell_teapot();

}  // namespace luch::assets
