#include "framework/accel/world.h"

#include "framework/accel/wide/build.h"

#include <array>

namespace luch {
namespace {

/// By how much of a node's distance a hit found in its own frame may lie outside of its world box:
/// the ray is rounded to float there (u = 2⁻²⁴, some 16 roundings), and a transform that is not a
/// uniform scale stretches that error by its condition. 2⁻¹⁹ is twice the bound.
double slack_of(const Node& node) {
    return 0x1p-19 * max_norm(node.to_world.matrix) * max_norm(node.to_object.matrix);
}

/// The largest of a packet's limits.
float largest(const float* limits) {
    std::array<float, 16> most;
    most.fill(-std::numeric_limits<float>::infinity());
    for (int i = 0; i < RayPacket::capacity; i += 16) {
        for (int k = 0; k < 16; ++k) most[k] = most[k] < limits[i + k] ? limits[i + k] : most[k];
    }
    return *std::max_element(most.begin(), most.end());
}

/// A box that holds another one grown by `padding`, relative to `centre`, in float.
Box rounded_out(const Boxd& box, const Vec3d& centre, double padding) {
    Box out;
    for (int axis = 0; axis < 3; ++axis) {
        constexpr float infinity = std::numeric_limits<float>::infinity();
        out.lo[axis] =
            std::nextafter(static_cast<float>(box.lo[axis] - centre[axis] - padding), -infinity);
        out.hi[axis] =
            std::nextafter(static_cast<float>(box.hi[axis] - centre[axis] + padding), infinity);
    }
    return out;
}

/// A ray relative to the middle, whose tests do not overflow or vanish.
bool is_tame(const ObjectRay& ray) {
    const float length = max_norm(ray.direction);
    return length > 0x1p-60f && length < 0x1p60f && max_norm(ray.origin) < 0x1p60f;
}

/// The directions of a packet's rays, for the same test of a box at once.
class PacketBounds {
 public:
    PacketBounds(const RayPacket& rays, const Vec3d& centre)
        : origin_(rays.origin - centre), t_min_(rays.t_min) {
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

    /// No ray of the packet enters the box, padded by `slack` times the farthest corner's distance,
    /// before this t; NaN when all miss it.
    [[nodiscard]] double enter(const Box& box, double slack) const {
        const Vec3d lo = Vec3d(box.lo) - origin_, hi = Vec3d(box.hi) - origin_;
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

/// A packet that meets more nodes than this goes ray by ray: turning 256 rays into a node's frame
/// costs as much as a few of them do alone.
constexpr std::size_t most_nodes = 6;
/// How many times the scene's extent a ray may start from its middle and still be near.
constexpr double near_enough = 3;

}  // namespace

World::World(const Scene& scene, Isa isa, bool skip) : kernels_(&wide::kernels(isa)) {
    // Once a geometry, not once a node: a forest's nodes share a few large meshes.
    std::vector<Boxd> of_geometry;
    for (const Geometry& geometry : scene.geometries) of_geometry.push_back(bounds_of(geometry));
    std::vector<Boxd> boxes;
    Boxd all;
    for (NodeId id = 0; id < scene.nodes.size(); ++id) {
        const Node& node = scene.nodes[id];
        const Boxd box = node.to_world.box(of_geometry[node.geometry]);
        if (box.empty()) continue;
        if (!all_finite(box.lo) || !all_finite(box.hi)) {
            unbounded_.push_back(id);
        } else {
            bounded_.push_back(id);
            boxes.push_back(box);
            all.grow(box);
        }
    }
    if (boxes.empty()) return;
    centre_ = all.centre();
    const double extent = max_norm(all.size());
    std::vector<Box> rounded;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const double slack = slack_of(scene.nodes[bounded_[i]]);
        rounded.push_back(rounded_out(boxes[i], centre_, slack * (near_enough + 1) * extent));
        slack_from_afar_ = std::max(slack_from_afar_, 2 * static_cast<float>(slack));
    }
    tree_ = wide::built(rounded, isa);
    single_ = skip && boxes.size() == 1 && unbounded_.empty();
}

std::uint64_t World::bytes() const {
    return tree_.bytes() + (bounded_.size() + unbounded_.size()) * sizeof(NodeId);
}

float World::slack_for(const Vec3d& origin) const {
    // 2⁻¹⁹ for the ray's own rounding to float.
    constexpr float rounding = 0x1p-19f;
    const bool near = max_norm(origin) <= near_enough * tree_.extent;
    return near ? rounding : rounding + slack_from_afar_;
}

void World::walk(const Ray& ray, float limit, float (*each)(void*, std::uint32_t), void* with,
                 WorkCounts& work) const {
    ++work.searches;
    for (const NodeId node : unbounded_) limit = each(with, node);
    if (limit == -std::numeric_limits<float>::infinity()) return;
    if (bounded_.empty()) return;
    const ObjectRay relative =
        object_ray({ray.origin - centre_, ray.direction, ray.t_min, ray.t_max});
    if (!is_tame(relative)) {
        for (const NodeId node : bounded_) each(with, node);
        return;
    }
    struct Leaf {
        const World* world;
        float (*each)(void*, std::uint32_t);
        void* with;
    } leaf{this, each, with};
    const auto call = [](void* context, std::uint32_t number) {
        const Leaf& of = *static_cast<const Leaf*>(context);
        return of.each(of.with, of.world->bounded_[number]);
    };
    kernels_->walk(tree_, relative, limit, slack_for(ray.origin - centre_), call, &leaf, work);
}

bool World::walk(const RayPacket& rays, const float* limits, void (*each)(void*, std::uint32_t),
                 void* with, WorkCounts& work) const {
    if (!all_finite(rays.origin)) return true;
    ++work.searches;
    for (const NodeId node : unbounded_) each(with, node);
    if (bounded_.empty()) return true;
    const PacketBounds bounds(rays, centre_);
    const float slack = slack_for(rays.origin - centre_);
    const double limit = largest(limits);
    std::vector<std::pair<double, NodeId>> met;
    std::vector<std::uint32_t> stack{0};
    while (!stack.empty()) {
        const std::uint32_t child = stack.back();
        stack.pop_back();
        const wide::Node& node = tree_.nodes[child];
        work.boxes += wide::node_width;
        for (int slot = 0; slot < wide::node_width && (node.used >> slot & 1) != 0; ++slot) {
            const double near = bounds.enter(node.box(slot), slack);
            if (!(near <= limit)) continue;
            if ((node.child[slot] & wide::leaf_bit) == 0) {
                stack.push_back(node.child[slot]);
            } else {
                met.emplace_back(near, bounded_[node.child[slot] & ~wide::leaf_bit]);
                if (met.size() > most_nodes) return false;
            }
        }
    }
    std::ranges::sort(met);
    for (const auto& [near, node] : met) {
        if (near <= largest(limits)) each(with, node);
    }
    return true;
}

}  // namespace luch
