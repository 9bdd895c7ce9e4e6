#include "techniques/shadow_map/items.h"

#include "framework/accel/node_hit.h"
#include "framework/trace/known_light.h"
#include "techniques/shadow_map/cover.h"

#include <algorithm>
#include <tuple>

namespace luch::techniques::shadow_map {
namespace {

/// Rays are turned into a mesh's frame and rounded to float there: 2⁻²⁴ of what its coordinates
/// and the light's are in it, some times over; in double for other shapes. Here with room.
constexpr double rounding_of_mesh = 0x1p-20, rounding_of_shape = 0x1p-40;

/// Turns what is relative to the light into a face's coordinates.
struct FaceFrame {
    int face;
    [[nodiscard]] Vec3d operator()(const Vec3d& v) const {
        return {v[x_axis(face)], v[y_axis(face)], sign_of(face) * v[main_axis(face)]};
    }
};

/// An item and its texel, until they are sorted.
struct Seen {
    std::uint32_t texel;
    Item item;
};

/// Fills one face.
class FaceBuilder {
 public:
    FaceBuilder(const Scene& scene, const Vec3d& light, int face, int n, const Tile& window)
        : scene_(&scene), light_(light), to_face_{face}, n_(n) {
        out_.window = window;
    }

    /// A node that is seen through some texels.
    void add(NodeId id, const Tile& seen) {
        const Node& node = scene_->nodes[id];
        const Geometry& geometry = scene_->geometries[node.geometry];
        const auto* mesh = std::get_if<Mesh>(&geometry);
        if (mesh != nullptr && pays(*mesh, seen)) return add(id, node, *mesh);
        const bool tested = mesh == nullptr && !std::holds_alternative<Heightfield>(geometry) &&
                            !std::holds_alternative<Csg>(geometry);
        add_box(id, node, bounds_of(geometry), tested ? 0 : Item::not_tested);
    }

    /// Sorts what was seen: by texel, then from near to far.
    ItemFace finished() {
        const std::size_t texels = out_.window.area();
        std::vector<std::uint32_t> end(texels + 1, 0);
        for (const Seen& seen : seen_) ++end[seen.texel + 1];
        for (std::size_t texel = 0; texel < texels; ++texel) end[texel + 1] += end[texel];
        std::vector<Item> sorted(seen_.size());
        std::vector<std::uint32_t> next(end.begin(), end.end() - 1);
        for (const Seen& seen : seen_) sorted[next[seen.texel]++] = seen.item;
        out_.first.reserve(texels + 1);
        for (std::size_t texel = 0; texel < texels; ++texel) {
            out_.first.push_back(static_cast<std::uint32_t>(out_.items.size()));
            keep({sorted.data() + end[texel], end[texel + 1] - end[texel]});
        }
        out_.first.push_back(static_cast<std::uint32_t>(out_.items.size()));
        out_.items.shrink_to_fit();
        return std::move(out_);
    }

 private:
    /// The nearest of a texel's items, each once; if some are left out, where they begin.
    void keep(std::span<Item> items) {
        const auto order = [](const Item& item) {
            return std::tuple(item.nearest, item.node, item.primitive);
        };
        std::ranges::sort(items, {}, order);
        std::size_t kept = 0;
        for (const Item& item : items) {
            if (kept > 0 && order(out_.items.back()) == order(item)) continue;
            out_.items.push_back(item);
            if (++kept <= most_items) continue;
            out_.items.back().node = no_node;
            break;
        }
    }

    /// Triangles that are much smaller than texels cost more than they tell: their mesh is then one
    /// item, its box.
    static bool pays(const Mesh& mesh, const Tile& seen) {
        constexpr std::size_t triangles_a_texel = 4;
        return mesh.triangles.size() <= triangles_a_texel * std::max<std::size_t>(seen.area(), 64);
    }

    void add(NodeId id, const Node& node, const Mesh& mesh) {
        Boxd all;
        std::vector<Vec3d> corners;
        for (const Vec3& p : mesh.positions) {
            all.grow(Vec3d(p));
            corners.push_back(seen_from_light(node, Vec3d(p)));
        }
        const double pad = pad_of(node, all, rounding_of_mesh);
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            const auto& [a, b, c] = mesh.triangles[i].position;
            const Vec3d polygon[3] = {corners[a], corners[b], corners[c]};
            const Box box = mesh.box(i);
            const auto nearest = [&] { return nearest_of(node, {Vec3d(box.lo), Vec3d(box.hi)}); };
            add_polygon({0, id, i}, polygon, pad, nearest);
        }
    }

    void add_box(NodeId id, const Node& node, const Boxd& box, std::uint32_t primitive) {
        if (box.empty()) return;
        const Item item{0, id, primitive};
        if (!all_finite(box.lo) || !all_finite(box.hi)) {
            out_.everywhere.push_back(item);
            return;
        }
        std::array<Vec3d, 8> corners;
        for (unsigned i = 0; i < 8; ++i) {
            const Vec3d corner{i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y,
                               i & 4 ? box.hi.z : box.lo.z};
            corners[i] = seen_from_light(node, corner);
        }
        const double pad = pad_of(node, box, rounding_of_shape);
        const auto nearest = [&] { return nearest_of(node, box); };
        for (const auto& [a, b, c, d] : {std::array{0, 2, 6, 4},
                                         {1, 3, 7, 5},
                                         {0, 1, 5, 4},
                                         {2, 3, 7, 6},
                                         {0, 1, 3, 2},
                                         {4, 5, 7, 6}}) {
            const auto at = [&](int i) { return corners[static_cast<std::size_t>(i)]; };
            const Vec3d polygon[4] = {at(a), at(b), at(c), at(d)};
            add_polygon(item, polygon, pad, nearest);
        }
    }

    [[nodiscard]] Vec3d seen_from_light(const Node& node, const Vec3d& local) const {
        return to_face_(node.to_world.point(local) - light_);
    }

    /// What rounding may do, in world units along each axis: to a ray in the node's coordinates,
    /// of which none is larger than the light's or the box's there, and to corners in the world.
    [[nodiscard]] double pad_of(const Node& node, const Boxd& box, double rounding) const {
        const Vec3d eye = node.to_object.point(light_);
        const Vec3d most = glm::max(glm::abs(eye), glm::max(glm::abs(box.lo), glm::abs(box.hi)));
        const Transform turn{node.to_world.matrix, Vec3d(0)};
        return rounding * max_norm(turn.box({-most, most}).hi) +
               0x1p-44 * (max_norm(light_) + max_norm(node.to_world.offset));
    }

    /// A depth along the face's axis that no t of a hit within a local box falls short of: t is
    /// clamped to the box in its own coordinates.
    [[nodiscard]] double nearest_of(const Node& node, const Boxd& box) const {
        double nearest = std::numeric_limits<double>::infinity();
        for (unsigned i = 0; i < 8; ++i) {
            const Vec3d corner{i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y,
                               i & 4 ? box.hi.z : box.lo.z};
            nearest = std::min(nearest, seen_from_light(node, corner).z);
        }
        return nearest;
    }

    template <class Nearest>
    void add_polygon(Item item, FacePolygon polygon, double pad, Nearest&& nearest) {
        if (!cover(polygon, pad, n_, out_.window, runs_)) {
            if (out_.everywhere.empty() || out_.everywhere.back().node != item.node ||
                out_.everywhere.back().primitive != item.primitive) {
                out_.everywhere.push_back(item);
            }
            return;
        }
        if (runs_.empty()) return;
        item.nearest = static_cast<float>(std::max(nearest() - 2 * pad, 0.0) * (1 - 0x1p-16));
        for (const Run& run : runs_) {
            const auto row = static_cast<std::uint32_t>(run.y - out_.window.y0) *
                             static_cast<std::uint32_t>(out_.window.width());
            for (int x = run.x0; x < run.x1; ++x) {
                seen_.push_back({row + static_cast<std::uint32_t>(x - out_.window.x0), item});
            }
        }
    }

    const Scene* scene_;
    Vec3d light_;
    FaceFrame to_face_;
    int n_;
    ItemFace out_;
    std::vector<Seen> seen_;
    std::vector<Run> runs_;
};

/// Whether an item is met by a ray, as everybody else finds it.
bool is_met(const Item& item, const Scene& scene, const Ray& ray) {
    const Node& node = scene.nodes[item.node];
    const Ray in_its = to_object(ray, node);
    if (const auto* mesh = std::get_if<Mesh>(&scene.geometries[node.geometry])) {
        TriangleHit hit;
        return intersect_triangle(object_ray(in_its), mesh->corner(item.primitive, 0),
                                  mesh->corner(item.primitive, 1), mesh->corner(item.primitive, 2),
                                  mesh->cull_backfaces, hit);
    }
    Hit best = no_hit_before(ray);
    WorkCounts not_counted;
    const auto no_meshes = [](GeometryId, const Mesh&, const ObjectRay&, Crossings&) {};
    improve_with_shape(scene, node.geometry, in_its, item.node, best, not_counted, no_meshes);
    return static_cast<bool>(best);
}

/// 1: met by none of them, 0: by one; unknown.
float share_by(std::span<const Item> items, double depth, const Scene& scene, const Ray& shadow,
               Counts& counts, NodeId own) {
    float share = 1;
    for (const Item& item : items) {
        if (item.nearest > depth) break;
        if (item.node == no_node) return ShadowSource::unknown;
        if (item.node == own) continue;
        if (item.primitive == Item::not_tested) {
            share = ShadowSource::unknown;
            continue;
        }
        ++counts.object_tests;
        if (is_met(item, scene, shadow)) return 0;
    }
    return share;
}

}  // namespace

std::uint64_t Items::bytes() const {
    std::uint64_t bytes = 0;
    for (const ItemFace& face : faces) {
        bytes += (face.everywhere.size() + face.items.size()) * sizeof(Item) +
                 face.first.size() * sizeof(std::uint32_t);
    }
    return bytes;
}

ItemFace items_of(const Scene& scene, const Content& content, const Vec3d& light, int face, int n,
                  const Tile& window) {
    FaceBuilder builder(scene, light, face, n, window);
    for (NodeId id = 0; id < scene.nodes.size(); ++id) {
        const Boxd& box = content.things()[id].box;
        if (box.empty()) continue;
        const Boxd relative{box.lo - light, box.hi - light};
        const Tile seen = common(window_of(relative, face, n, 1), window);
        if (seen != Tile{}) builder.add(id, seen);
    }
    return builder.finished();
}

float share_by_items(const Items& items, const Scene& scene, const Ray& shadow, Counts& counts,
                     NodeId own) {
    const Vec3d& d = shadow.direction;
    if (!is_sound(shadow) || d == Vec3d(0)) return ShadowSource::unknown;
    const int face = face_of(d);
    const double depth = std::abs(d[main_axis(face)]);
    const auto cell = [&](int axis) {
        const double place = (d[axis] / depth + 1) / 2 * items.n;
        return std::clamp(static_cast<int>(place), 0, items.n - 1);
    };
    const int x = cell(x_axis(face)), y = cell(y_axis(face));
    const ItemFace& at = items.faces[static_cast<std::size_t>(face)];
    const Tile& window = at.window;
    if (x < window.x0 || x >= window.x1 || y < window.y0 || y >= window.y1) {
        return ShadowSource::unknown;
    }
    const float near = share_by(at.everywhere, depth, scene, shadow, counts, own);
    if (near == 0) return 0;
    const std::size_t texel =
        static_cast<std::size_t>(y - window.y0) * static_cast<std::size_t>(window.width()) +
        static_cast<std::size_t>(x - window.x0);
    const std::uint32_t first = at.first[texel], end = at.first[texel + 1];
    const float share =
        share_by({at.items.data() + first, end - first}, depth, scene, shadow, counts, own);
    return share == 0 ? 0 : std::min(near, share);
}

NodeId own_convex(const Scene& scene, const Surface& surface, const Ray& shadow) {
    const Geometry& geometry = scene.geometries[scene.nodes[surface.node].geometry];
    if (!std::holds_alternative<Sphere>(geometry) && !std::holds_alternative<Cube>(geometry)) {
        return no_node;
    }
    const double length = glm::length(shadow.direction);
    const double lift = surface.error + surface.error_per_distance * length;
    const double height = -glm::dot(surface.geometric_normal, shadow.direction);
    return surface.front && lift < 0x1p-28 * height ? surface.node : no_node;
}

}  // namespace luch::techniques::shadow_map
