#include "techniques/vista/stand_ins.h"

#include "techniques/vista/plan.h"
#include "techniques/vista/vista.h"

#include <numbers>

namespace luch::techniques::vista {
namespace {

/// A hull while it is made, in coordinates of its own: the shape's middle is the origin, its
/// largest half extent 1.
struct HullFrame {
    Vec3d middle;
    double size;
    Vec3d eye;  ///< where the eye is
    double slack;

    HullFrame(const Node& node, const Screen& screen, const Vec3d& middle_of, double size_of)
        : middle(middle_of),
          size(size_of),
          eye((node.to_object.point(screen.eye()) - middle_of) / size_of),
          slack(0x1p-16 + 0x1p-19 * max_norm(eye)) {
        // What may cancel when the eye is brought here, in double, far from the world's origin.
        const double cancelled = 3 * max_norm(node.to_object.matrix) * max_norm(screen.eye()) +
                                 max_norm(node.to_object.offset) + max_norm(middle_of);
        slack += 0x1p-44 * cancelled / size_of;
    }
};

/// Triangles whose corners turn outwards, around the origin.
Mesh convex_mesh(const std::vector<Tri>& triangles) {
    Mesh mesh;
    mesh.cull_backfaces = true;
    for (const Tri& triangle : triangles) {
        std::array<Vec3d, 3> p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = triangle.corners[k].p;
        if (glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), p[0] + p[1] + p[2]) < 0) {
            std::swap(p[1], p[2]);
        }
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const Vec3d& corner : p) mesh.positions.emplace_back(corner);
        mesh.triangles.push_back({{first, first + 1, first + 2}, {}, {}});
    }
    return mesh;
}

/// The corners of a box around the origin.
Mesh box_mesh(const Vec3d& half) {
    std::vector<Tri> triangles;
    tessellate(Cube{.side = 2}, 0, triangles);
    for (Tri& triangle : triangles) {
        for (Corner& corner : triangle.corners) corner.p *= half;
    }
    return convex_mesh(triangles);
}

/// Segments for which the polyhedron around a sphere sticks out by less than a pixel: r · π²/n² ≤
/// 1, in steps of eight, so that spheres may share one.
int segments_for(float radius_px) {
    const double n = std::numbers::pi * std::sqrt(radius_px);
    return static_cast<int>(std::clamp(8 * std::ceil(n / 8), 8.0, 64.0));
}

/// Pixels that may see something of a box; all of them where the eye is beside it.
Tile extent_of(const Boxd& box, const Transform& to_world, const Screen& screen) {
    const Size size = screen.size();
    Bounds<Vec2d> seen;
    for (unsigned i = 0; i < 8; ++i) {
        const Vec3d corner{i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y,
                           i & 4 ? box.hi.z : box.lo.z};
        const Vec3d view = screen.to_view(to_world.point(corner));
        const std::optional<Vec2d> px = screen.project(view);
        if (!px || !(view.z > 0x1p-10 * max_norm(view))) return {0, 0, size.width, size.height};
        seen.lo = glm::min(seen.lo, *px);
        seen.hi = glm::max(seen.hi, *px);
    }
    const auto within = [](double px, int most) {
        return static_cast<int>(std::clamp(px, 0.0, double(most)));
    };
    return {within(seen.lo.x - 1, size.width), within(seen.lo.y - 1, size.height),
            within(seen.hi.x + 2, size.width), within(seen.hi.y + 2, size.height)};
}

class Maker {
 public:
    Maker(const Scene& scene, const Screen& screen, int segments, bool wanted)
        : scene_(scene), screen_(screen), segments_(segments), wanted_(wanted) {}

    Hulls made() {
        for (NodeId id = 0; id < scene_.nodes.size(); ++id) {
            const Geometry& geometry = scene_.geometries[scene_.nodes[id].geometry];
            if (std::holds_alternative<Mesh>(geometry)) continue;
            const auto* sphere = std::get_if<Sphere>(&geometry);
            const Boxd box = bounds_of(geometry);
            if (sphere == nullptr && box.empty()) continue;
            const bool has_hull = wanted_ && (sphere != nullptr ? add(id, *sphere) : add(id, box));
            if (!has_hull) hulls_.boundless.push_back(id);
        }
        return std::move(hulls_);
    }

 private:
    /// How far outside of a hull the eye must be.
    static constexpr double margin = 1 + 0x1p-10;

    bool add(NodeId id, const Sphere& sphere) {
        const HullFrame frame(scene_.nodes[id], screen_, sphere.centre, sphere.radius);
        const int n =
            segments_ != 0 ? segments_ : segments_for(radius_px(scene_, scene_.nodes[id], screen_));
        const double scale = circumscribed(n) * (1 + frame.slack);
        if (!(sphere.radius > 0) || !(glm::length(frame.eye) > scale * margin)) return false;
        return place(id, frame, polyhedron(n), Vec3d(1), scale, n);
    }

    bool add(NodeId id, const Boxd& box) {
        if (!all_finite(box.lo) || !all_finite(box.hi)) return false;
        const double size = max_norm(box.size()) / 2;
        if (!(size > 0)) return false;
        const HullFrame frame(scene_.nodes[id], screen_, box.centre(), size);
        const Vec3d half = box.size() / (2 * size) + frame.slack;
        bool outside = false;
        for (int axis = 0; axis < 3; ++axis) {
            outside |= std::abs(frame.eye[axis]) > half[axis] * margin;
        }
        if (!outside) return false;
        hulls_.scene.geometries.emplace_back(box_mesh(half));
        return place(id, frame, last_geometry(), half, 1, 0);
    }

    /// `half`: of a box around the hull, in its coordinates.
    bool place(NodeId id, const HullFrame& frame, GeometryId geometry, const Vec3d& half,
               double scale, int n) {
        const double size = frame.size * scale;
        const Transform to_frame{glm::dmat3(1 / size), -frame.middle / size};
        Node& hull = hulls_.scene.nodes.emplace_back();
        hull.geometry = geometry;
        hull.to_object = scene_.nodes[id].to_object.then(to_frame);
        hulls_.node_of.push_back(id);
        hulls_.segments.push_back(static_cast<std::uint8_t>(n));
        const Vec3d reach = half * size;
        hulls_.extents.push_back(extent_of({frame.middle - reach, frame.middle + reach},
                                           scene_.nodes[id].to_world, screen_));
        return true;
    }

    [[nodiscard]] GeometryId last_geometry() const {
        return static_cast<GeometryId>(hulls_.scene.geometries.size() - 1);
    }

    /// One for all spheres of so many segments.
    GeometryId polyhedron(int n) {
        GeometryId& known = polyhedra_[static_cast<std::size_t>(n)];
        if (known == none) {
            std::vector<Tri> triangles;
            tessellate(Sphere{.radius = 1}, n, triangles);
            hulls_.scene.geometries.emplace_back(convex_mesh(triangles));
            known = last_geometry();
        }
        return known;
    }

    static constexpr GeometryId none = ~GeometryId{0};
    const Scene& scene_;
    const Screen& screen_;
    int segments_;
    bool wanted_;
    std::vector<GeometryId> polyhedra_ = std::vector<GeometryId>(most_segments + 2, none);
    Hulls hulls_;
};

}  // namespace

double circumscribed(int n) {
    const int bands = n / 2;
    return 1 / (std::cos(std::numbers::pi / n) * std::cos(std::numbers::pi / (2 * bands)));
}

Hulls hulls_of(const Scene& scene, const Screen& screen, int segments, bool wanted) {
    return Maker(scene, screen, segments, wanted).made();
}

}  // namespace luch::techniques::vista
