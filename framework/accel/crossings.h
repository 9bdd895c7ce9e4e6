#pragma once

#include "framework/accel/hit.h"

#include <array>
#include <cstddef>
#include <memory_resource>
#include <vector>

namespace luch {

/// A place where a ray passes through the surface of a part of a solid.
struct Crossing {
    float t, u, v;            ///< as in a Hit
    std::uint32_t part;       ///< index into Csg::parts
    std::uint32_t primitive;  ///< of the part's own geometry

    [[nodiscard]] bool operator<(const Crossing& other) const {
        if (t != other.t) return t < other.t;
        if (part != other.part) return part < other.part;
        return primitive < other.primitive;
    }
};

/// All crossings of one ray ahead of its t_min, t_max or not. The first 128 need no memory from the
/// heap.
class Crossings {
 public:
    explicit Crossings(const Ray& ray) : t_min_(least_t(ray.t_min)) { found_.reserve(128); }
    Crossings(const Crossings&) = delete;
    Crossings& operator=(const Crossings&) = delete;

    /// What is added from now on belongs to this part.
    void begin(std::uint32_t part) { part_ = part; }
    /// Keeps the crossing if its t, as the float that it will be, counts.
    void add(double t, std::uint32_t primitive) { add({static_cast<float>(t), 0, 0}, primitive); }
    void add(const TriangleHit& at, std::uint32_t primitive) {
        if (at.t > t_min_ && at.t < std::numeric_limits<float>::infinity()) {
            found_.push_back({at.t, at.u, at.v, part_, primitive});
        }
    }

    [[nodiscard]] std::pmr::vector<Crossing>& found() { return found_; }

 private:
    alignas(Crossing) std::array<std::byte, 128 * sizeof(Crossing)> first_;
    std::pmr::monotonic_buffer_resource memory_{first_.data(), first_.size()};
    std::pmr::vector<Crossing> found_{&memory_};
    float t_min_;
    std::uint32_t part_ = 0;
};

/// Whether a ray passes through a triangle of a closed surface, for counting: an edge or a corner
/// that it meets exactly belongs to one side of it, the same for all triangles there, as if the ray
/// had been tilted by an infinitesimal angle (Edelsbrunner, Mücke, "Simulation of Simplicity",
/// 1990). So inside and outside alternate where intersect_triangle() finds both neighbours. A
/// crossing is always a hit of intersect_triangle(), and has its t, u, v. Backfaces are never
/// culled.
bool cross_triangle(const ObjectRay& ray, const Vec3& p0, const Vec3& p1, const Vec3& p2,
                    TriangleHit& hit);

/// The sign of (a × b) · d, exactly; where that is 0, of (a × b) · (d + tiny tilt). 0 only where a
/// and b are parallel.
int tilted_edge_sign(const Vec3& a, const Vec3& b, const Vec3& d);

}  // namespace luch
