#include "framework/accel/accelerator.h"

#include "framework/accel/bvh.h"
#include "framework/accel/csg_hit.h"
#include "framework/accel/embree.h"
#include "framework/accel/embree_mesh.h"
#include "framework/accel/mesh_bvh.h"
#include "framework/accel/node_hit.h"
#include "framework/accel/shapes.h"
#include "framework/base/error.h"
#include "framework/base/text.h"

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
/// distance; NaN when it misses. `inverses` is 1 / direction.
double enter_world_box(const Boxd& box, double slack, const Ray& ray, const Vec3d& inverses) {
    const Vec3d lo = box.lo - ray.origin, hi = box.hi - ray.origin;
    const double padding = slack * std::max(max_norm(lo), max_norm(hi));
    double near = ray.t_min, far = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double inverse = inverses[axis];
        const double one = (lo[axis] - padding) * inverse, other = (hi[axis] + padding) * inverse;
        // Comparisons with NaN (a ray in the face of a box) are false and keep the old bound.
        const double first = std::signbit(inverse) ? other : one;
        const double last = std::signbit(inverse) ? one : other;
        if (first > near) near = first;
        if (last < far) far = last;
    }
    return near <= far ? near : std::numeric_limits<double>::quiet_NaN();
}

/// The limit of a ray that looks for nothing, or that is blocked.
constexpr float nothing = -std::numeric_limits<float>::infinity();

/// The directions of a packet's rays, for the same test of a box at once.
class PacketBounds {
 public:
    explicit PacketBounds(const RayPacket& rays) : origin_(rays.origin), t_min_(rays.t_min) {
        const double* directions[3] = {rays.x, rays.y, rays.z};
        for (int axis = 0; axis < 3; ++axis) {
            double lo = std::numeric_limits<double>::infinity(), hi = -lo;
            for (int i = 0; i < rays.count; ++i) {
                lo = std::min(lo, directions[axis][i]);
                hi = std::max(hi, directions[axis][i]);
            }
            lo_[axis] = lo;
            hi_[axis] = hi;
        }
    }

    /// No ray of the packet enters the padded box before this t; NaN when all miss it.
    [[nodiscard]] double enter(const Boxd& box, double slack) const {
        const Vec3d lo = box.lo - origin_, hi = box.hi - origin_;
        const double padding = slack * std::max(max_norm(lo), max_norm(hi));
        double near = t_min_, far = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 3; ++axis) {
            const bool positive = lo_[axis] > 0;
            if (!positive && !(hi_[axis] < 0)) continue;  // some ray may run along the box
            const double first = positive ? lo[axis] - padding : hi[axis] + padding;
            const double last = positive ? hi[axis] + padding : lo[axis] - padding;
            near = std::max(near, std::min(first / lo_[axis], first / hi_[axis]));
            far = std::min(far, std::max(last / lo_[axis], last / hi_[axis]));
        }
        // The divisions are rounded; slack covers far more than that on the way in and out.
        return near <= far ? near : std::numeric_limits<double>::quiet_NaN();
    }

 private:
    Vec3d origin_;
    double t_min_;
    double lo_[3], hi_[3];
};

/// What the rays of a packet look for at first: hits before their t_max, when there can be any.
void set_limits(const RayPacket& rays, float* limits) {
    for (int i = 0; i < rays.count; ++i) {
        const float t_max = rays.t_max[i];
        limits[i] = t_max > rays.t_min ? t_max : nothing;
    }
    std::fill(limits + rays.count, limits + RayPacket::capacity, nothing);
}

/// The largest of a packet's limits.
float largest(const float* limits) {
    std::array<float, 16> most;
    most.fill(nothing);
    for (int i = 0; i < RayPacket::capacity; i += 16) {
        for (int k = 0; k < 16; ++k) most[k] = most[k] < limits[i + k] ? limits[i + k] : most[k];
    }
    return *std::max_element(most.begin(), most.end());
}

/// Index searches the triangles of a mesh: MeshBvh, or EmbreeMesh.
template <class Index>
class BvhAccelerator final : public Accelerator {
 public:
    BvhAccelerator(const Scene& scene, Isa isa) : scene_(&scene), meshes_(scene.geometries.size()) {
        for (std::size_t i = 0; i < meshes_.size(); ++i) {
            if (const auto* mesh = std::get_if<Mesh>(&scene.geometries[i]))
                meshes_[i].emplace(*mesh, isa);
        }
        sort_nodes();
    }

    Hit closest(const Ray& ray, WorkCounts& work) const override {
        Hit best = no_hit_before(ray);
        search(ray, false, best, work);
        if (!best) best = {};
        return best;
    }

    Hit closest_in(NodeId node, const Ray& ray, WorkCounts& work) const override {
        if (!is_sound(ray)) return {};
        Hit best = no_hit_before(ray);
        improve_with_node(node, ray, false, best, work);
        return best ? best : Hit{};
    }

    bool occluded(const Ray& ray, WorkCounts& work) const override {
        Hit best = no_hit_before(ray);
        search(ray, true, best, work);
        return static_cast<bool>(best);
    }

    void closest(const RayPacket& rays, HitPacket& hits, WorkCounts& work) const override {
        set_limits(rays, hits.t);
        std::fill(hits.u, hits.u + RayPacket::capacity, 0.0f);
        std::fill(hits.v, hits.v + RayPacket::capacity, 0.0f);
        std::fill(hits.node, hits.node + RayPacket::capacity, no_node);
        std::fill(hits.primitive, hits.primitive + RayPacket::capacity, 0u);
        const auto visit = [&](NodeId id) {
            if (const auto& mesh = meshes_[scene_->nodes[id].geometry]) {
                mesh->closest(rays, scene_->nodes[id], id, hits, work);
                return;
            }
            for (int i = 0; i < rays.count; ++i) {
                if (hits.t[i] == nothing || !is_sound(rays.ray(i))) continue;
                Hit best = hits.hit(i);
                if (improve_with_node(id, rays.ray(i), false, best, work)) hits.set(i, best);
            }
        };
        each_node(rays, hits.t, visit, work);
        for (int i = 0; i < rays.count; ++i) {
            const float t = hits.t[i];
            hits.t[i] = hits.node[i] == no_node ? std::numeric_limits<float>::infinity() : t;
        }
    }

    void occluded(const RayPacket& rays, std::span<std::uint8_t> blocked,
                  WorkCounts& work) const override {
        alignas(64) float limits[RayPacket::capacity];
        set_limits(rays, limits);
        const auto visit = [&](NodeId id) {
            if (const auto& mesh = meshes_[scene_->nodes[id].geometry]) {
                mesh->occluded(rays, scene_->nodes[id], limits, work);
                return;
            }
            for (int i = 0; i < rays.count; ++i) {
                const Ray ray = rays.ray(i);
                if (limits[i] == nothing || !is_sound(ray)) continue;
                Hit best = no_hit_before(ray);
                if (improve_with_node(id, ray, true, best, work)) limits[i] = nothing;
            }
        };
        each_node(rays, limits, visit, work);
        for (int i = 0; i < rays.count; ++i) {
            blocked[i] = limits[i] == nothing && rays.t_max[i] > rays.t_min ? 1 : 0;
        }
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

    /// Improves `best`, or finds anything at all.
    void search(const Ray& ray, bool any, Hit& best, WorkCounts& work) const {
        if (!is_sound(ray)) return;
        for (const NodeId node : unbounded_) {
            if (improve_with_node(node, ray, any, best, work) && any) return;
        }
        if (bounded_.size() == 1) {  // its own tree says no as quickly as its box
            improve_with_node(bounded_[0], ray, any, best, work);
            return;
        }
        const Vec3d inverses = 1.0 / ray.direction;
        world_.walk(
            [&](std::uint32_t index) {
                ++work.boxes;
                return enter_world_box(world_.nodes()[index].box, slack_[index], ray, inverses);
            },
            [&] { return static_cast<double>(best.t); },
            [&](const Bvh<Boxd>::Node& leaf) {
                for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
                    const NodeId node = bounded_[world_.order()[i]];
                    if (improve_with_node(node, ray, any, best, work) && any) return true;
                }
                return false;
            });
    }

    /// Calls visit(node) for every node that some ray of the packet may meet before its limit.
    template <class Visit>
    void each_node(const RayPacket& rays, const float* limits, Visit&& visit,
                   WorkCounts& work) const {
        if (!all_finite(rays.origin)) return;
        for (const NodeId node : unbounded_) visit(node);
        const PacketBounds bounds(rays);
        double limit = largest(limits);
        world_.walk(
            [&](std::uint32_t index) {
                ++work.boxes;
                return bounds.enter(world_.nodes()[index].box, slack_[index]);
            },
            [&] { return limit; },
            [&](const Bvh<Boxd>::Node& leaf) {
                for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
                    visit(bounded_[world_.order()[i]]);
                }
                limit = largest(limits);
                return false;
            });
    }

    bool improve_with_node(NodeId id, const Ray& ray, bool any, Hit& best, WorkCounts& work) const {
        const Node& node = scene_->nodes[id];
        const Ray object = to_object(ray, node);
        if (const auto& mesh = meshes_[node.geometry]) {
            if (!any) return mesh->closest(object_ray(object), id, best, work);
            if (!mesh->occluded(object_ray(object), work)) return false;
            best.node = id;
            return true;
        }
        const Hit before = best;
        const auto in_mesh = [&](GeometryId geometry, const Mesh&, const ObjectRay& in_frame,
                                 Crossings& crossings) {
            meshes_[geometry]->find_crossings(in_frame, crossings, work);
        };
        improve_with_shape(*scene_, node.geometry, object, id, best, work, in_mesh);
        return !(best == before);
    }

    const Scene* scene_;
    std::vector<std::optional<Index>> meshes_;  ///< by geometry
    std::vector<NodeId> unbounded_, bounded_;
    Bvh<Boxd> world_;            ///< over bounded_
    std::vector<double> slack_;  ///< by node of world_
};

}  // namespace

std::unique_ptr<Accelerator> build_accelerator(const Scene& scene, Isa isa, Backend backend) {
    if (backend == Backend::luch) return std::make_unique<BvhAccelerator<MeshBvh>>(scene, isa);
    return std::make_unique<BvhAccelerator<EmbreeMesh>>(scene, isa);
}

Backend parsed_backend(std::string_view text) {
    constexpr std::string_view names[] = {"luch", "embree"};
    const auto* name = std::ranges::find(names, text);
    if (name == std::end(names)) {
        throw Error("--backend " + std::string(text) + ": " + did_you_mean(text, names));
    }
    if (*name == "luch") return Backend::luch;
    if (!has_embree()) {
        throw Error(
            "--backend embree: this build has no Embree; install libembree-dev and "
            "configure again, or leave the option out");
    }
    return Backend::embree;
}

}  // namespace luch
