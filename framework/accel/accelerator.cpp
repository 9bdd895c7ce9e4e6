#include "framework/accel/accelerator.h"

#include "framework/accel/csg_hit.h"
#include "framework/accel/embree.h"
#include "framework/accel/embree_mesh.h"
#include "framework/accel/mesh_bvh.h"
#include "framework/accel/node_hit.h"
#include "framework/accel/shape_packets.h"
#include "framework/accel/shapes.h"
#include "framework/accel/world.h"
#include "framework/base/error.h"
#include "framework/base/text.h"
#include "framework/scene/census.h"

#include <optional>

namespace luch {
namespace {

/// The limit of a ray that looks for nothing, or that is blocked.
constexpr float infinite = std::numeric_limits<float>::infinity(), nothing = -infinite;

/// What the rays of a packet look for at first: hits before their t_max, when there can be any.
void set_limits(const RayPacket& rays, float* limits) {
    for (int i = 0; i < rays.count; ++i) {
        const float t_max = rays.t_max[i];
        limits[i] = t_max > rays.t_min ? t_max : nothing;
    }
    std::fill(limits + rays.count, limits + RayPacket::capacity, nothing);
}

/// No hits yet.
void start(const RayPacket& rays, HitPacket& hits) {
    set_limits(rays, hits.t);
    std::fill(hits.u, hits.u + RayPacket::capacity, 0.0f);
    std::fill(hits.v, hits.v + RayPacket::capacity, 0.0f);
    std::fill(hits.node, hits.node + RayPacket::capacity, no_node);
    std::fill(hits.primitive, hits.primitive + RayPacket::capacity, 0u);
}

/// Improves the hits of a packet, by nearer(), with what it met of a node.
void keep_nearer(const wide::ShapeHits& met, int count, NodeId node, HitPacket& hits) {
    for (int i = 0; i < count; ++i) {
        const float t = met.t[i], best = hits.t[i];
        const std::uint32_t primitive = hits.primitive[i], face = met.face[i];
        const NodeId other = hits.node[i];
        const bool lower = (node < other) | ((node == other) & (face < primitive));
        const bool better = (t < infinite) & ((t < best) | ((t == best) & lower));
        hits.t[i] = better ? t : best;
        hits.u[i] = better ? 0 : hits.u[i];
        hits.v[i] = better ? 0 : hits.v[i];
        hits.node[i] = better ? node : other;
        hits.primitive[i] = better ? face : primitive;
    }
}

/// Index searches the triangles of a mesh: MeshBvh, or EmbreeMesh.
template <class Index>
class BvhAccelerator final : public Accelerator {
 public:
    BvhAccelerator(const Scene& scene, Isa isa, bool skip)
        : scene_(&scene),
          meshes_(scene.geometries.size()),
          kernels_(&wide::kernels(isa)),
          world_(scene, isa, skip),
          moved_(!skip || census_of(scene).moved > 0) {
        for (std::size_t i = 0; i < meshes_.size(); ++i) {
            if (const auto* mesh = std::get_if<Mesh>(&scene.geometries[i]))
                meshes_[i].emplace(*mesh, isa);
        }
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

    void improve(NodeId node, const RayPacket& rays, HitPacket& hits,
                 WorkCounts& work) const override {
        HitPacket found;
        start(rays, found);
        improve_with_node(node, rays, found, work);
        for (int i = 0; i < rays.count; ++i) {
            const Hit hit = found.hit(i);
            if (hit && nearer(hit, hits.hit(i))) hits.set(i, hit);
        }
    }

    void closest(const RayPacket& rays, HitPacket& hits, WorkCounts& work) const override {
        start(rays, hits);
        auto visit = [&](NodeId id) { improve_with_node(id, rays, hits, work); };
        const bool finished = world_.visit(rays, hits.t, visit, work);
        for (int i = 0; i < rays.count; ++i) {
            if (!finished && hits.t[i] != nothing) {
                Hit best = hits.hit(i);
                search(rays.ray(i), false, best, work);
                hits.set(i, best);
            }
            const float t = hits.t[i];
            hits.t[i] = hits.node[i] == no_node ? infinite : t;
        }
    }

    void occluded(const RayPacket& rays, std::span<std::uint8_t> blocked,
                  WorkCounts& work) const override {
        alignas(64) float limits[RayPacket::capacity];
        set_limits(rays, limits);
        auto visit = [&](NodeId id) {
            if (const auto& mesh = meshes_[scene_->nodes[id].geometry]) {
                mesh->occluded(rays, scene_->nodes[id], limits, work);
                return;
            }
            wide::ShapeHits met;
            if (meets(id, rays, limits, met, work)) {
                for (int i = 0; i < rays.count; ++i) {
                    limits[i] = met.t[i] < infinite ? nothing : limits[i];
                }
                return;
            }
            for (int i = 0; i < rays.count; ++i) {
                const Ray ray = rays.ray(i);
                if (limits[i] == nothing || !is_sound(ray)) continue;
                Hit best = no_hit_before(ray);
                if (improve_with_node(id, ray, true, best, work)) limits[i] = nothing;
            }
        };
        const bool finished = world_.visit(rays, limits, visit, work);
        for (int i = 0; i < rays.count; ++i) {
            if (!finished && limits[i] != nothing) {
                Hit best = no_hit_before(rays.ray(i));
                search(rays.ray(i), true, best, work);
                if (best) limits[i] = nothing;
            }
            blocked[i] = limits[i] == nothing && rays.t_max[i] > rays.t_min ? 1 : 0;
        }
    }

    std::uint64_t bytes() const override {
        std::uint64_t sum = world_.bytes();
        for (const auto& mesh : meshes_) sum += mesh ? mesh->bytes() : 0;
        return sum;
    }

 private:
    /// Improves `best`, or finds anything at all.
    void search(const Ray& ray, bool any, Hit& best, WorkCounts& work) const {
        if (!is_sound(ray)) return;
        auto visit = [&](NodeId node) {
            const bool improved = improve_with_node(node, ray, any, best, work);
            return any && improved ? nothing : best.t;
        };
        world_.visit(ray, best.t, visit, work);
    }

    /// A whole packet with a plane, sphere or cube; false for other nodes.
    bool meets(NodeId id, const RayPacket& rays, const float* limits, wide::ShapeHits& met,
               WorkCounts& work) const {
        const Node& node = scene_->nodes[id];
        const Transform* const to_object = moved_ ? &node.to_object : nullptr;
        if (!meet(scene_->geometries[node.geometry], to_object, rays, *kernels_, met)) return false;
        for (int i = 0; i < rays.count; ++i) work.primitives += limits[i] != nothing ? 1 : 0;
        return true;
    }

    void improve_with_node(NodeId id, const RayPacket& rays, HitPacket& hits,
                           WorkCounts& work) const {
        const Node& node = scene_->nodes[id];
        if (const auto& mesh = meshes_[node.geometry]) {
            mesh->closest(rays, node, id, hits, work);
            return;
        }
        wide::ShapeHits met;
        if (meets(id, rays, hits.t, met, work)) {
            keep_nearer(met, rays.count, id, hits);
            return;
        }
        for (int i = 0; i < rays.count; ++i) {
            if (hits.t[i] == nothing || !is_sound(rays.ray(i))) continue;
            Hit best = hits.hit(i);
            if (improve_with_node(id, rays.ray(i), false, best, work)) hits.set(i, best);
        }
    }

    bool improve_with_node(NodeId id, const Ray& ray, bool any, Hit& best, WorkCounts& work) const {
        const Node& node = scene_->nodes[id];
        const Ray object = moved_ ? to_object(ray, node) : ray;
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
    const wide::Kernels* kernels_;
    World world_;
    bool moved_;  ///< some node stands elsewhere than its geometry says
};

}  // namespace

std::unique_ptr<Accelerator> build_accelerator(const Scene& scene, Isa isa, Backend backend,
                                               bool skip) {
    if (backend == Backend::luch) {
        return std::make_unique<BvhAccelerator<MeshBvh>>(scene, isa, skip);
    }
    return std::make_unique<BvhAccelerator<EmbreeMesh>>(scene, isa, skip);
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
