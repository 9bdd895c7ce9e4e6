#pragma once

#include "framework/accel/isa.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// The rows of the table of extreme cases that are about the core: rays, what they hit, and the item
// buffer. Each is a function from an effort to a tally, so that a test and a report can both run
// it.
namespace luch::stress {

/// How many rays (meshes, matrices), as a share of the row's stated number, and the instructions
/// that search.
struct Effort {
    double share = 1;
    Isa isa = Isa::plain;

    [[nodiscard]] std::uint64_t of(std::uint64_t stated) const;
};

struct Tally {
    std::uint64_t rays = 0;  ///< or pixels, matrices
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
    int number;  ///< in the table
    std::string_view name;
    std::string_view expected;
    Tally (*run)(const Effort&);
    double smoke;    ///< the share that a quick run takes
    bool every_isa;  ///< whether the processor's instructions matter
    std::string_view unit = "rays";
};

/// All of them, in the table's order.
const std::vector<Row>& rows();

// 1 and 2: rays from inside a closed mesh leave it, near to the world's origin and far away, aimed
// at nothing, at edges and at corners; alone, in packets, and through intersect_triangle() alone.
Tally random_rays_inside(const Effort& effort);
Tally rays_at_edges(const Effort& effort);
Tally rays_at_corners(const Effort& effort);
Tally rays_inside_directly(const Effort& effort);
// 3: meshes and spheres from 1e-20 to 1e20 in size are hit as in double arithmetic.
Tally meshes_of_every_size(const Effort& effort);
Tally spheres_of_every_size(const Effort& effort);
// 4: rays in the faces and edges of boxes, flat ones too, by the slab formula and in a tree.
Tally rays_in_faces_of_boxes(const Effort& effort);
Tally rays_in_faces_of_cubes(const Effort& effort);
// 5: rays that leave a surface do not meet it again, nor pass another one close by.
Tally rays_off_surfaces(const Effort& effort);
Tally rays_through_thin_gaps(const Effort& effort);
// 6 and 7: spheres far away, huge ones, and two of nearly the same size.
Tally small_and_huge_spheres(const Effort& effort);
Tally concentric_spheres(const Effort& effort);
// 9: degenerate meshes are built, shallow, and hit as brute force says, without NaN.
Tally degenerate_meshes(const Effort& effort);
// 10: numbers that are none, or extreme, in rays; the same with denormals flushed to zero.
Tally extreme_rays(const Effort& effort);
Tally rays_without_denormals(const Effort& effort);
Tally rays_along_axes(const Effort& effort);
// 11: transforms: singular ones are refused, mirrored, sheared and scaled ones (1e-8 to 1e8) agree
// with double arithmetic to 1e-5.
Tally singular_transforms(const Effort& effort);
Tally transformed_spheres(const Effort& effort);
Tally transformed_meshes(const Effort& effort);
// 14: what the item buffer is sure of, against brute force: shared edges, corners behind the eye or
// in its plane, corners ten million pixels off the frame, slivers, planes through the eye, any
// bits.
Tally items_of_patches(const Effort& effort);
Tally items_behind_the_eye(const Effort& effort);
Tally items_next_to_the_eye(const Effort& effort);
Tally items_far_off_the_frame(const Effort& effort);
Tally items_of_slivers(const Effort& effort);
Tally items_seen_from_their_edge(const Effort& effort);
Tally items_of_random_bits(const Effort& effort);
// 15: the same among shapes of every kind, against the rays' own hits.
Tally items_against_rays(const Effort& effort);

}  // namespace luch::stress
