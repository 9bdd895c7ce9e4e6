#include "framework/stress/rays/rows.h"

#include <algorithm>
#include <cmath>

namespace luch::stress {

std::uint64_t Effort::of(std::uint64_t stated) const {
    return std::max<std::uint64_t>(64, std::llround(share * static_cast<double>(stated)));
}

const std::vector<Row>& rows() {
    static const std::vector<Row> all{
        {1, "random rays inside a closed mesh", "no miss", random_rays_inside, 0.01, true},
        {1, "rays inside a closed mesh directly", "no miss", rays_inside_directly, 0.02, false},
        {2, "rays at edges", "no miss", rays_at_edges, 0.05, true},
        {2, "rays at corners", "no miss", rays_at_corners, 0.05, true},
        {3, "meshes of every size", "as in double", meshes_of_every_size, 0.05, true},
        {3, "spheres of every size", "as in double", spheres_of_every_size, 0.05, false},
        {4, "rays in faces of boxes", "no miss", rays_in_faces_of_boxes, 0.2, false},
        {4, "rays in faces of cubes", "no miss", rays_in_faces_of_cubes, 0.05, true},
        {5, "rays off surfaces", "no self-hit", rays_off_surfaces, 0.01, true},
        {5, "rays through thin gaps", "no leak", rays_through_thin_gaps, 0.02, true},
        {6, "small and huge spheres", "t to 1e-6, R = 1e12: 1e-4", small_and_huge_spheres, 0.1,
         false},
        {7, "concentric spheres", "the right one", concentric_spheres, 0.1, false},
        {9, "degenerate meshes", "shallow, brute force's hits", degenerate_meshes, 0.02, true},
        {10, "extreme rays", "a miss, or brute force's hit", extreme_rays, 0.05, true},
        {10, "rays without denormals", "the same ids", rays_without_denormals, 0.005, true},
        {10, "rays along axes", "brute force's hits", rays_along_axes, 0.05, true},
        {11, "singular transforms", "refused", singular_transforms, 0.02, false, "matrices"},
        {11, "transformed spheres", "t to 1e-5", transformed_spheres, 0.02, false},
        {11, "transformed meshes", "t to 1e-5", transformed_meshes, 0.02, true},
#ifdef LUCH_ITEM_BUFFER
        {14, "items of patches with shared edges", "exact ids", items_of_patches, 0.25, true,
         "pixels"},
        {14, "items behind the eye", "exact ids", items_behind_the_eye, 0.05, true, "pixels"},
        {14, "items next to the eye", "exact ids", items_next_to_the_eye, 0.05, true, "pixels"},
        {14, "items far off the frame", "exact ids", items_far_off_the_frame, 0.05, true, "pixels"},
        {14, "items of slivers", "exact ids", items_of_slivers, 0.05, true, "pixels"},
        {14, "items seen from their edge", "exact ids", items_seen_from_their_edge, 0.05, true,
         "pixels"},
        {14, "items of random bits", "exact ids", items_of_random_bits, 0.05, true, "pixels"},
        {15, "items against rays", "exact ids", items_against_rays, 0.05, true, "pixels"},
#endif
    };
    return all;
}

}  // namespace luch::stress
