#pragma once

#include "framework/measure/bench_rays.h"

#include <cstdint>
#include <string>
#include <vector>

namespace luch {

/// What `luch bench raster` is asked for.
struct RasterBench {
    bool embree = false;
    int threads = 1;
    Size size{1920, 1080};
    int rounds = 7;  ///< how often each contender runs, in turn with the others
    Isa isa = Isa::plain;
};

/// A way to find what every pixel shows: "ids" and "ids+resolve" are the item buffer's (the latter
/// gives all hits, ambiguous pixels traced), "packets" luch's rays, the rest Embree's modes. With
/// "frame: " rays are made tile by tile and hits are not kept, as in a renderer; else all rays were
/// made before, as Embree's were.
struct RasterModeSpeed {
    std::string backend, mode;
    double mpixels_per_s = 0;
};

struct RasterSpeed {
    std::string mesh;
    std::uint64_t triangles = 0;
    std::vector<RasterModeSpeed> modes;
    std::uint64_t pixels = 0;
    std::uint64_t covered = 0;    ///< pixels that show the mesh
    std::uint64_t ambiguous = 0;  ///< pixels that had to be traced
    std::uint64_t mismatches =
        0;  ///< pixels whose node, primitive, t, u or v differ from the ray's

    /// As a multiple of Embree's best mode; of luch's packets where there is no Embree.
    [[nodiscard]] double ratio_of(const RasterModeSpeed& mode) const;
};

/// Races the item buffer against primary rays over one mesh. All rays are made before. `view` is in
/// the mesh's own frame.
RasterSpeed raced(const std::string& name, const Mesh& mesh, const BenchView& view,
                  const RasterBench& bench);

}  // namespace luch
