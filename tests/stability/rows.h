#pragma once

#include "framework/accel/isa.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// The rows of the stability table that are about rays and what they hit. Each is a function from an
// effort to counts, so that a test and a report can both run it.
namespace luch::stability {

/// How many rays, as a share of the row's stated number, and the instructions that search.
struct Effort {
    double share = 1;
    Isa isa = Isa::plain;

    [[nodiscard]] std::uint64_t of(std::uint64_t stated) const;
};

struct Counts {
    std::uint64_t rays = 0;
    std::uint64_t failures = 0;
    std::string first;  ///< what the first failure was

    /// One more ray; `what()` tells of it when it fails.
    template <class What>
    void judge(bool good, What&& what) {
        ++rays;
        if (good) return;
        if (failures++ == 0) first = what();
    }
};

struct Row {
    std::string_view name;
    Counts (*run)(const Effort&);
    double smoke;    ///< the share that a quick run takes
    bool every_isa;  ///< whether the processor's instructions matter
};

/// All of them, in the table's order.
const std::vector<Row>& rows();

// 1 and 2: rays from inside a closed mesh leave it, near to the world's origin and far away, aimed
// at nothing, at edges and at corners; alone, in packets, and through intersect_triangle() alone.
Counts random_rays_inside(const Effort& effort);
Counts rays_at_edges(const Effort& effort);
Counts rays_at_corners(const Effort& effort);
Counts rays_inside_directly(const Effort& effort);
// 3: meshes and spheres from 1e-20 to 1e20 in size are hit as in double arithmetic.
Counts meshes_of_every_size(const Effort& effort);
Counts spheres_of_every_size(const Effort& effort);
// 4: rays in the faces and edges of boxes, flat ones too, by the slab formula and in a tree.
Counts rays_in_faces_of_boxes(const Effort& effort);
Counts rays_in_faces_of_cubes(const Effort& effort);
// 5: rays that leave a surface do not meet it again, nor pass another one close by.
Counts rays_off_surfaces(const Effort& effort);
Counts rays_through_thin_gaps(const Effort& effort);
// 6 and 7: spheres far away, huge ones, and two of nearly the same size.
Counts small_and_huge_spheres(const Effort& effort);
Counts concentric_spheres(const Effort& effort);
// 9: degenerate meshes are built, shallow, and hit as brute force says, without NaN.
Counts degenerate_meshes(const Effort& effort);
// 10: numbers that are none, or extreme, in rays; the same with denormals flushed to zero.
Counts extreme_rays(const Effort& effort);
Counts rays_without_denormals(const Effort& effort);
Counts rays_along_axes(const Effort& effort);

}  // namespace luch::stability
