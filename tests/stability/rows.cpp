#include "tests/stability/rows.h"

#include <algorithm>
#include <cmath>

namespace luch::stability {

std::uint64_t Effort::of(std::uint64_t stated) const {
    return std::max<std::uint64_t>(64, std::llround(share * static_cast<double>(stated)));
}

const std::vector<Row>& rows() {
    static const std::vector<Row> all{
        {"1RandomRaysInsideAClosedMesh", random_rays_inside, 0.01, true},
        {"1And2InsideAClosedMeshDirectly", rays_inside_directly, 0.02, false},
        {"2RaysAtEdges", rays_at_edges, 0.05, true},
        {"2RaysAtCorners", rays_at_corners, 0.05, true},
        {"3MeshesOfEverySize", meshes_of_every_size, 0.05, true},
        {"3SpheresOfEverySize", spheres_of_every_size, 0.05, false},
        {"4RaysInFacesOfBoxes", rays_in_faces_of_boxes, 0.2, false},
        {"4RaysInFacesOfCubes", rays_in_faces_of_cubes, 0.05, true},
        {"5RaysOffSurfaces", rays_off_surfaces, 0.01, true},
        {"5RaysThroughThinGaps", rays_through_thin_gaps, 0.02, true},
        {"6SmallAndHugeSpheres", small_and_huge_spheres, 0.1, false},
        {"7ConcentricSpheres", concentric_spheres, 0.1, false},
        {"9DegenerateMeshes", degenerate_meshes, 0.02, true},
        {"10ExtremeRays", extreme_rays, 0.05, true},
        {"10RaysWithoutDenormals", rays_without_denormals, 0.005, true},
        {"10RaysAlongAxes", rays_along_axes, 0.05, true},
    };
    return all;
}

}  // namespace luch::stability
