#pragma once

#include "framework/accel/isa.h"
#include "framework/scene/geometry.h"

#include <string>
#include <vector>

namespace luch {

/// What `luch bench rays` is asked for.
struct RayBench {
    std::vector<std::string> backends{"luch"};  ///< "luch", "embree"
    std::vector<std::string> kinds{"primary", "shadow", "diffuse"};
    int threads = 1;
    int side = 1024;  ///< rays of a kind: side², in tiles of 16 × 16
    int rounds = 7;   ///< how often each back end runs, in turn with the others
    Isa isa = Isa::plain;
    double scale = 1;  ///< the mesh's size; a power of two, so that all see the same floats
};

/// A back end's way to shoot one kind of ray.
struct RayModeSpeed {
    std::string mode;  ///< "single", "packet", "packet8", …
    double mrays_per_s = 0;
    double boxes = 0, primitives = 0;  ///< tests a ray, where it is known (luch's own)
};

struct RayKindSpeed {
    std::string kind, backend;
    std::vector<RayModeSpeed> modes;
    /// Rays that one of luch and this back end (Embree: in its robust mode) hits and the other does
    /// not, although what is right is in no doubt; and those where it is, see bench_judge.h.
    std::uint64_t rays = 0, hit_mismatches = 0, hit_doubts = 0;
    /// The share of the rays that both hit where they meet the same triangle. Those where they do
    /// not and only one triangle can be right: prim_mismatches.
    double prim_agreement = 1;
    std::uint64_t prim_mismatches = 0;

    [[nodiscard]] const RayModeSpeed& best() const;
    [[nodiscard]] double speed_of(const std::string& mode) const;  ///< 0 when there is none
};

struct MeshSpeed {
    std::string mesh;
    std::uint64_t triangles = 0;
    std::vector<double> build_cpu_ms;  ///< by back end, median
    std::vector<RayKindSpeed> kinds;
};

/// Where the camera and the light of the benchmark stand, in the mesh's coordinates.
struct BenchView {
    Vec3d eye, at, light;
};

/// Races the back ends over one mesh. All rays are made before; only shooting them is timed.
/// `view` is in the mesh's own frame.
MeshSpeed raced(const std::string& name, const Mesh& mesh, const BenchView& view,
                const RayBench& bench);

}  // namespace luch
