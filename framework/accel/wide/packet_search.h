#pragma once

#include "framework/accel/wide/packet.h"

// The search itself: from the root to the triangles, keeping the nearest hit of every ray.
namespace luch::wide {
namespace {

/// What the rays of a bundle met in this mesh: t is in the bundle.
struct Found {
    alignas(64) float primitive[RayPacket::capacity];  ///< the bits of the triangle's number
    alignas(64) float weight[3][RayPacket::capacity];
    unsigned improved[groups] = {};
};

/// Where a search goes on: a child of a node, and the groups that met its parent.
struct Visit {
    float near;
    std::uint32_t node;
    std::uint16_t slot, groups;
};

/// How many tests of sixteen rays a packet is worth: where triangles are smaller than pixels it
/// takes some 350; beyond this its rays have little in common.
inline constexpr std::uint64_t patience = 4096;
/// So many groups are tested ray by ray whether they meet a box: what lies between a group's rays
/// is much larger than they are where boxes are small, and a block that none of them meets costs
/// more than the test, most of all when it has to come from memory.
inline constexpr int few_groups = 4;

template <bool any>
class PacketSearch {
 public:
    /// `before` is what other nodes of the scene gave, for rays that are hit at the very same t.
    PacketSearch(const Tree& tree, NodeId node, const HitPacket* before, Bundle& bundle,
                 Found& found)
        : tree_(tree), node_(node), before_(before), bundle_(bundle), found_(found) {}

    /// Searches, but gives up (false, with what was found so far) when the rays turn out to have so
    /// little in common that one by one they cost less.
    bool run(WorkCounts& work) {
        const bool finished = search();
        work.boxes += boxes_ * node_width;
        work.primitives += primitives_;
        return finished;
    }

 private:
    bool search() {
        if (std::popcount(bundle_.wide) > groups / 2) return false;
        open(0, 0xffff);
        while (size_ > 0) {
            if (primitives_ + rays_tested_ > patience) return false;
            const Visit visit = stack_[--size_];
            if (!(visit.near <= bundle_.limit_all)) continue;
            const Node& node = tree_.nodes[visit.node];
            unsigned meeting = groups_meeting(bundle_, node, visit.slot) & visit.groups;
            const bool few = std::popcount(meeting) <= few_groups;
            for (unsigned g = few ? meeting : meeting & bundle_.wide; g != 0; g &= g - 1) {
                ++rays_tested_;
                if (!ray_meets(node, visit.slot, std::countr_zero(g))) meeting &= ~(g & -g);
            }
            if (meeting == 0) continue;
            const std::uint32_t child = node.child[visit.slot];
            if ((child & leaf_bit) == 0) {
                open(child, meeting);
            } else {
                test_block(tree_.blocks[child & ~leaf_bit], meeting);
            }
        }
        return true;
    }

    /// Pushes the children that are met, the nearest last.
    void open(std::uint32_t index, unsigned groups_met) {
        const Node& node = tree_.nodes[index];
        ++boxes_;
        alignas(32) float near[node_width];
        const int base = size_;
        for (unsigned mask = children_meeting(bundle_, node, near); mask != 0; mask &= mask - 1) {
            const int slot = std::countr_zero(mask);
            tree_.prefetch(node.child[slot]);
            int at = size_++;
            for (; at > base && stack_[at - 1].near < near[slot]; --at) {
                stack_[at] = stack_[at - 1];
            }
            stack_[at] = {near[slot], index, static_cast<std::uint16_t>(slot),
                          static_cast<std::uint16_t>(groups_met)};
        }
    }

    LUCH_INLINE void clip(const Sixteen& one, const Sixteen& other, int axis, int group,
                          Sixteen& near, Sixteen& far) const {
        if (bundle_.coherent) {
            near = max_or(bundle_.negative[axis] ? other : one, near);
            far = min_or(bundle_.negative[axis] ? one : other, far);
        } else {
            const unsigned turned = bundle_.negative_lanes[axis][group];
            near = max_or(Sixteen::select(turned, other, one), near);
            far = min_or(Sixteen::select(turned, one, other), far);
        }
    }

    /// Whether any ray of a group meets a child's box before its limit, by the one slab formula.
    bool ray_meets(const Node& node, int slot, int group) const {
        const int at = group * groups;
        Sixteen near(bundle_.t_min), far(infinite);
        for (int axis = 0; axis < 3; ++axis) {
            const Sixteen inverse = Sixteen::load(bundle_.inverse[axis] + at);
            const float lo = node.bounds[2 * axis][slot] - bundle_.origin[axis];
            const float hi = node.bounds[2 * axis + 1][slot] - bundle_.origin[axis];
            clip(Sixteen(lo) * inverse, Sixteen(hi) * inverse, axis, group, near, far);
        }
        far = min_or(max_or(far * Sixteen(far_padding), far), Sixteen::load(bundle_.t + at));
        return (near <= far) != 0;
    }

    void test_block(const Block& block, unsigned groups_met) {
        Facets facets;
        look_at(bundle_, block, facets);
        unsigned improved = 0;
        for (unsigned rest = facets.alive; rest != 0; rest &= rest - 1) {
            const int k = std::countr_zero(rest);
            if (k > 0 && block.id[k] == block.id[k - 1]) break;  // the block ended before
            const unsigned inside = groups_inside(bundle_, facets, k) & groups_met;
            for (unsigned g = inside; g != 0; g &= g - 1) {
                const int group = std::countr_zero(g);
                ++primitives_;
                if (test_group(block, facets, k, group)) improved |= 1u << group;
            }
        }
        if (improved == 0) return;
        for (; improved != 0; improved &= improved - 1) {
            bundle_.update_limit(std::countr_zero(improved));
        }
        bundle_.update_limits();
    }

    /// Triangle k against the sixteen rays of a group; true when any of them improved.
    LUCH_INLINE bool test_group(const Block& block, const Facets& f, int k, int group) {
        const int at = group * groups;
        const Three<Sixteen> d{Sixteen::load(bundle_.direction[0] + at),
                               Sixteen::load(bundle_.direction[1] + at),
                               Sixteen::load(bundle_.direction[2] + at)};
        const auto value = [&](const float(*n)[block_width]) {
            return Sixteen(n[0][k]) * d.x + Sixteen(n[1][k]) * d.y + Sixteen(n[2][k]) * d.z;
        };
        const Sixteen w[3] = {value(f.edge[0]), value(f.edge[1]), value(f.edge[2])};
        const Sixteen bound(f.ray_bound[k]), minus_bound(-f.ray_bound[k]);
        const Sixteen least = min_or(w[0], min_or(w[1], w[2]));
        const Sixteen most = max_or(w[0], max_or(w[1], w[2]));
        const unsigned maybe = ~((least < minus_bound) & (bound < most)) & 0xffff;
        if (maybe == 0) return false;
        const unsigned positive = bound < least;
        const unsigned certain = positive | (most < minus_bound);
        const unsigned wanted = tree_.cull_backfaces ? maybe & ~positive : maybe;
        return finish(block, f, k, group, wanted, certain, value(f.normal), w);
    }

    LUCH_INLINE bool finish(const Block& block, const Facets& f, int k, int group, unsigned maybe,
                            unsigned certain, const Sixteen& along, const Sixteen (&w)[3]) {
        const int at = group * groups;
        certain &= Sixteen(f.slope_bound[k]) < abs(along);
        if ((f.above_certain >> k & 1) == 0) certain = 0;
        Sixteen near(-infinite), far(infinite);
        for (int axis = 0; axis < 3; ++axis) {
            const Sixteen inverse = Sixteen::load(bundle_.inverse[axis] + at);
            const Sixteen one = Sixteen(f.lo[axis][k]) * inverse;
            const Sixteen other = Sixteen(f.hi[axis][k]) * inverse;
            clip(one, other, axis, group, near, far);
        }
        far = max_or(far * Sixteen(far_padding), far);
        const Sixteen t = min_or(far, max_or(near, Sixteen(f.above[k]) / along));
        const Sixteen before = Sixteen::load(bundle_.t + at);
        const unsigned hit = maybe & certain & (near <= far) & (Sixteen(bundle_.t_min) < t);
        unsigned closer = hit & (t < before);
        const unsigned ties = hit & ~closer & (t <= before);
        if (ties != 0) closer |= won_ties(ties, block.id[k], at);
        if (closer != 0) keep(closer, block.id[k], at, t, w);
        const unsigned doubtful = maybe & ~certain & (Sixteen(-infinite) < before);
        if (doubtful != 0) closer |= take_exactly(block, k, at, doubtful, w);
        found_.improved[group] |= closer;
        return closer != 0;
    }

    [[nodiscard]] Hit best(int lane) const {
        if ((found_.improved[lane / groups] >> (lane % groups) & 1) != 0) {
            return {.t = bundle_.t[lane],
                    .node = node_,
                    .primitive = std::bit_cast<std::uint32_t>(found_.primitive[lane])};
        }
        return {.t = bundle_.t[lane],
                .node = before_ != nullptr ? before_->node[lane] : no_node,
                .primitive = before_ != nullptr ? before_->primitive[lane] : 0};
    }

    /// Lanes whose hit at the same t comes first by node and triangle. At t_max nothing is a hit.
    [[gnu::noinline]] unsigned won_ties(unsigned ties, std::uint32_t id, int at) const {
        unsigned won = 0;
        for (; ties != 0; ties &= ties - 1) {
            const int lane = at + std::countr_zero(ties);
            const Hit old = best(lane);
            const Hit hit{.t = old.t, .node = node_, .primitive = id};
            if (old && nearer(hit, old)) won |= ties & -ties;
        }
        return won;
    }

    LUCH_INLINE void keep(unsigned closer, std::uint32_t id, int at, const Sixteen& t,
                          const Sixteen (&w)[3]) {
        const auto put = [&](float* to, const Sixteen& value) {
            Sixteen::select(closer, value, Sixteen::load(to + at)).store(to + at);
        };
        if (any) return put(bundle_.t, Sixteen(-infinite));
        put(bundle_.t, t);
        put(found_.primitive, Sixteen(std::bit_cast<float>(id)));
        for (int k = 0; k < 3; ++k) put(found_.weight[k], w[k]);
    }

    [[gnu::noinline]] unsigned take_exactly(const Block& block, int k, int at, unsigned doubtful,
                                            const Sixteen (&w)[3]) {
        unsigned closer = 0;
        for (; doubtful != 0; doubtful &= doubtful - 1) {
            const int lane = at + std::countr_zero(doubtful);
            const Hit old = best(lane);
            TriangleHit hit;
            // Whether t equals t_max is told by best(): there is no hit yet.
            const ObjectRay ray = bundle_.ray(lane, infinite);
            if (!intersect_triangle(ray, block.point(0, k), block.point(1, k), block.point(2, k),
                                    tree_.cull_backfaces, hit)) {
                continue;
            }
            if (!(old ? nearer({.t = hit.t, .node = node_, .primitive = block.id[k]}, old)
                      : hit.t < old.t)) {
                continue;
            }
            const unsigned bit = doubtful & -doubtful;
            closer |= bit;
            keep(bit, block.id[k], at, Sixteen(hit.t), w);
        }
        return closer;
    }

    const Tree& tree_;
    NodeId node_;
    const HitPacket* before_;
    Bundle& bundle_;
    Found& found_;
    Visit stack_[max_depth * (node_width - 1) + node_width];
    int size_ = 0;
    std::uint64_t boxes_ = 0, primitives_ = 0, rays_tested_ = 0;
};

}  // namespace
}  // namespace luch::wide
