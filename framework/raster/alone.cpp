#include "framework/raster/kernels.h"

#include <algorithm>

namespace luch::raster {

bool complete(const View& view, const Box& box, bool sane, bool turned, Facet& facet, Span& span) {
    const Extent extent = extent_of(view, {Vec3d(box.lo), Vec3d(box.hi)});
    span = extent.span;
    if (span.empty()) return false;
    facet.kind = Kind::doubtful;
    if (!sane) {
        for (auto& edge : facet.edge) std::fill(edge, edge + 3, 0.0f);
    } else if (facet.rho <= most_rho) {
        facet.kind = turned ? Kind::turned : Kind::crossing;
    }
    if (facet.kind != Kind::crossing) {
        facet.doubt = extent.nearest;
        std::fill(facet.depth, facet.depth + 3, 0.0f);
        facet.rho = 0;
    }
    return true;
}

}  // namespace luch::raster
