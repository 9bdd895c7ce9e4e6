#include "framework/accel/accelerator.h"

#include "framework/accel/csg_hit.h"
#include "framework/accel/mesh_bvh.h"
#include "framework/accel/node_hit.h"
#include "framework/accel/shapes.h"

#include <optional>

namespace luch {
namespace {

/// By how much of a node's distance a hit found in its own frame may lie outside of its world box:
/// the ray is rounded to float there (u = 2⁻²⁴, some 16 roundings), and a transform that is not a
/// uniform scale stretches that error by its condition. 2⁻¹⁹ is twice the bound.
double slack_of(const Node& node) {
    return 0x1p-19 * max_norm(node.to_world.matrix) * max_norm(node.to_object.matrix);
}

/// The t at which a ray enters a box that is padded by `slack` times the farthest corner's
/// distance; NaN when it misses.
double enter_world_box(const Boxd& box, double slack, const Ray& ray) {
    const Vec3d lo = box.lo - ray.origin, hi = box.hi - ray.origin;
    const double padding = slack * std::max(max_norm(lo), max_norm(hi));
    double near = ray.t_min, far = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double inverse = 1 / ray.direction[axis];
        const double one = (lo[axis] - padding) * inverse, other = (hi[axis] + padding) * inverse;
        // Comparisons with NaN (a ray in the face of a box) are false and keep the old bound.
        const double first = std::signbit(inverse) ? other : one;
        const double last = std::signbit(inverse) ? one : other;
        if (first > near) near = first;
        if (last < far) far = last;
    }
    return near <= far ? near : std::numeric_limits<double>::quiet_NaN();
}

class BvhAccelerator final : public Accelerator {
 public:
    explicit BvhAccelerator(const Scene& scene) : scene_(&scene), meshes_(scene.geometries.size()) {
        for (std::size_t i = 0; i < meshes_.size(); ++i) {
            if (const auto* mesh = std::get_if<Mesh>(&scene.geometries[i]))
                meshes_[i].emplace(*mesh);
        }
        sort_nodes();
    }

    Hit closest(const Ray& ray, WorkCounts& work) const override {
        const Hit best = search(ray, false, work);
        return best ? best : Hit{};
    }

    Hit closest_in(NodeId node, const Ray& ray, WorkCounts& work) const override {
        if (!is_sound(ray)) return {};
        Hit best = no_hit_before(ray);
        improve_with_node(node, ray, false, best, work);
        return best ? best : Hit{};
    }

    bool occluded(const Ray& ray, WorkCounts& work) const override {
        return static_cast<bool>(search(ray, true, work));
    }

    std::uint64_t bytes() const override {
        std::uint64_t sum = world_.bytes() + slack_.size() * sizeof(double);
        for (const auto& mesh : meshes_) sum += mesh ? mesh->bytes() : 0;
        return sum;
    }

 private:
    /// Unbounded nodes into a list of their own, the others into the world's BVH.
    void sort_nodes() {
        // Once a geometry, not once a node: a forest's nodes share a few large meshes.
        std::vector<Boxd> of_geometry;
        for (const Geometry& geometry : scene_->geometries) {
            of_geometry.push_back(bounds_of(geometry));
        }
        std::vector<Boxd> boxes;
        for (NodeId id = 0; id < scene_->nodes.size(); ++id) {
            const Node& node = scene_->nodes[id];
            const Boxd box = node.to_world.box(of_geometry[node.geometry]);
            if (box.empty()) continue;
            if (!all_finite(box.lo) || !all_finite(box.hi)) {
                unbounded_.push_back(id);
            } else {
                bounded_.push_back(id);
                boxes.push_back(box);
            }
        }
        world_ = Bvh<Boxd>(boxes);
        slack_.resize(world_.nodes().size());
        for (std::size_t i = slack_.size(); i-- > 0;) {
            const auto& node = world_.nodes()[i];
            if (node.count == 0) slack_[i] = std::max(slack_[node.first], slack_[node.first + 1]);
            for (std::uint32_t k = 0; k < node.count; ++k) {
                const NodeId id = bounded_[world_.order()[node.first + k]];
                slack_[i] = std::max(slack_[i], slack_of(scene_->nodes[id]));
            }
        }
    }

    Hit search(const Ray& ray, bool any, WorkCounts& work) const {
        if (!is_sound(ray)) return {};
        Hit best = no_hit_before(ray);
        for (const NodeId node : unbounded_) {
            if (improve_with_node(node, ray, any, best, work) && any) return best;
        }
        world_.walk(
            [&](std::uint32_t index) {
                ++work.boxes;
                return enter_world_box(world_.nodes()[index].box, slack_[index], ray);
            },
            [&] { return static_cast<double>(best.t); },
            [&](const Bvh<Boxd>::Node& leaf) {
                for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
                    const NodeId node = bounded_[world_.order()[i]];
                    if (improve_with_node(node, ray, any, best, work) && any) return true;
                }
                return false;
            });
        return best;
    }

    bool improve_with_node(NodeId id, const Ray& ray, bool any, Hit& best, WorkCounts& work) const {
        const Node& node = scene_->nodes[id];
        const Ray object = to_object(ray, node);
        const Hit before = best;
        if (const auto& mesh = meshes_[node.geometry]) {
            mesh->closest(object_ray(object), id, any, best, work);
        } else {
            const auto in_mesh = [&](GeometryId geometry, const Mesh&, const ObjectRay& in_frame,
                                     Crossings& crossings) {
                meshes_[geometry]->find_crossings(in_frame, crossings, work);
            };
            improve_with_shape(*scene_, node.geometry, object, id, best, work, in_mesh);
        }
        return !(best == before);
    }

    const Scene* scene_;
    std::vector<std::optional<MeshBvh>> meshes_;  ///< by geometry
    std::vector<NodeId> unbounded_, bounded_;
    Bvh<Boxd> world_;            ///< over bounded_
    std::vector<double> slack_;  ///< by node of world_
};

}  // namespace

std::unique_ptr<Accelerator> build_accelerator(const Scene& scene) {
    return std::make_unique<BvhAccelerator>(scene);
}

}  // namespace luch
