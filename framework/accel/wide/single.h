#pragma once

#include "framework/accel/accelerator.h"
#include "framework/accel/wide/lanes.h"
#include "framework/accel/wide/tree.h"

#include <bit>

// One ray through the tree, eight boxes or four triangles at a time. Only kernel files include
// this; nothing here has linkage.
namespace luch::wide {
namespace {

using Four = Lanes<block_width>;
using Eight = Lanes<node_width>;

template <class T>
LUCH_INLINE Three<T> all(const Vec3& v) {
    return {T(v.x), T(v.y), T(v.z)};
}

/// What one search found so far, and how far it still looks.
struct Search {
    Hit& best;
    float weights[3];  ///< the edge values of best, once it is of this search
};

/// A ray against the four triangles of a block.
class BlockTest {
 public:
    BlockTest(const ObjectRay& ray, NodeId node, bool cull_backfaces)
        : ray_(ray), node_(node), cull_(cull_backfaces), sum_(sum_of_sizes(ray.direction)) {}

    /// Improves the search; true when it did.
    [[gnu::noinline]] bool operator()(const Block& block, Search& search) const {
        const Edges e(block, all<Four>(ray_.origin), all<Four>(ray_.direction));
        const Four size = size_of(e.a[0], Four::load(block.edge));
        const Four bound = sign_bound(size, Four::load(block.edge), Four(sum_));
        const Four least = min_or(e.w[0], min_or(e.w[1], e.w[2]));
        const Four most = max_or(e.w[0], max_or(e.w[1], e.w[2]));
        const Four minus_bound = Four(0.0f) - bound;
        const unsigned maybe = ~((least < minus_bound) & (bound < most)) & 0xfu;
        if (maybe == 0) return false;
        const unsigned positive = bound < least;
        const unsigned certain = positive | (most < minus_bound);
        return finish(block, e, maybe, certain, cull_ ? positive : 0u, search);
    }

 private:
    /// Corners relative to the origin, and the values of the edges opposite to them.
    struct Edges {
        Three<Four> a[3];
        Four w[3];

        LUCH_INLINE Edges(const Block& block, const Three<Four>& origin,
                          const Three<Four>& direction) {
            for (int k = 0; k < 3; ++k) a[k] = minus(corner(block, k), origin);
            w[0] = dot(cross(a[1], minus(a[2], a[1])), direction);
            w[1] = dot(cross(a[2], minus(a[0], a[2])), direction);
            w[2] = dot(cross(a[0], minus(a[1], a[0])), direction);
        }
    };

    LUCH_INLINE static Three<Four> corner(const Block& block, int k) {
        return {Four::load(block.corner[3 * k]), Four::load(block.corner[3 * k + 1]),
                Four::load(block.corner[3 * k + 2])};
    }

    /// The distance of those that the edges let through.
    LUCH_INLINE bool finish(const Block& block, const Edges& e, unsigned maybe, unsigned certain,
                            unsigned culled, Search& search) const {
        const Three<Four> p0 = corner(block, 0);
        const Three<Four> edge1 = minus(corner(block, 1), p0), edge2 = minus(corner(block, 2), p0);
        const Three<Four> normal = cross(edge1, edge2);
        const Four above = dot(normal, e.a[0]), along = dot(normal, all<Four>(ray_.direction));
        const Four size = Four::load(block.edge);
        certain &= (sign_bound(size, size, sum_of_sizes(e.a[0])) < abs(above)) &
                   (sign_bound(size, size, Four(sum_)) < abs(along));
        const Three<Four> lo = lower(e.a[0], lower(e.a[1], e.a[2]));
        const Three<Four> hi = upper(e.a[0], upper(e.a[1], e.a[2]));
        Four near(-std::numeric_limits<float>::infinity());
        Four far(std::numeric_limits<float>::infinity());
        clip(lo.x, hi.x, ray_.direction.x, ray_.inverse.x, near, far);
        clip(lo.y, hi.y, ray_.direction.y, ray_.inverse.y, near, far);
        clip(lo.z, hi.z, ray_.direction.z, ray_.inverse.z, near, far);
        far = max_or(far * Four(far_padding), far);
        const Four t = min_or(far, max_or(near, above / along));
        const unsigned hit = maybe & certain & ~culled & (near <= far) & (Four(ray_.t_min) < t) &
                             (t < Four(ray_.t_max)) & (t <= Four(search.best.t));
        const unsigned doubtful = maybe & ~certain;
        if ((hit | doubtful) == 0) return false;
        Lines lines;
        t.store(lines.t);
        for (int k = 0; k < 3; ++k) e.w[k].store(lines.w[k]);
        return take(block, hit, doubtful, lines, search);
    }

    /// Distances and edge values of the four, for picking one.
    struct Lines {
        alignas(16) float t[block_width];
        alignas(16) float w[3][block_width];
    };

    LUCH_INLINE static void clip(const Four& lo, const Four& hi, float direction, float inverse,
                                 Four& near, Four& far) {
        const bool negative = std::signbit(direction);
        near = max_or((negative ? hi : lo) * Four(inverse), near);
        far = min_or((negative ? lo : hi) * Four(inverse), far);
    }

    bool take(const Block& block, unsigned hit, unsigned doubtful, const Lines& lines,
              Search& search) const {
        bool improved = false;
        for (; hit != 0; hit &= hit - 1) {
            const int lane = std::countr_zero(hit);
            improved |= keep(block, lane, lines.t[lane], lines, search);
        }
        for (; doubtful != 0; doubtful &= doubtful - 1) {
            const int lane = std::countr_zero(doubtful);
            TriangleHit found;
            if (!intersect_triangle(ray_, block.point(0, lane), block.point(1, lane),
                                    block.point(2, lane), cull_, found)) {
                continue;
            }
            improved |= keep(block, lane, found.t, lines, search);
        }
        return improved;
    }

    bool keep(const Block& block, int lane, float t, const Lines& lines, Search& search) const {
        const Hit hit{.t = t, .node = node_, .primitive = block.id[lane]};
        if (!nearer(hit, search.best)) return false;
        search.best = hit;
        for (int k = 0; k < 3; ++k) search.weights[k] = lines.w[k][lane];
        return true;
    }

    const ObjectRay& ray_;
    NodeId node_;
    bool cull_;
    float sum_;
};

/// A ray against the eight boxes of a node. A side at b gives t = b · i − o · i instead of the slab
/// formula's (b − o) · i, which takes half of the operations; with r = Σ|o| + max |b| the two
/// and the formula's padding differ by less than 16u · r · |i|, so both sides are moved by that. An
/// inverse that is infinite is cut to 2⁴⁰ / Σ|d|: a hit has t ≤ 3r / Σ|d|, and the far side, moved
/// by 2²⁰ · r / Σ|d|, comes after it.
class NodeTest {
 public:
    NodeTest(const ObjectRay& ray, float extent, float relative_slack = 0x1p-20f)
        : t_min_(ray.t_min) {
        Vec3 inverse = ray.inverse;
        if (!(sum_of_sizes(inverse) < infinite)) {
            const float steepest = 0x1p40f / sum_of_sizes(ray.direction);
            inverse = glm::clamp(inverse, -steepest, steepest);
        }
        const float reach = relative_slack * (sum_of_sizes(ray.origin) + extent);
        for (int axis = 0; axis < 3; ++axis) {
            const float start = ray.origin[axis] * inverse[axis];
            const float slack = reach * std::abs(inverse[axis]);
            inverse_[axis] = Eight(inverse[axis]);
            near_shift_[axis] = Eight(start + slack);
            far_shift_[axis] = Eight(start - slack);
            near_[axis] = side_bytes * (std::bit_cast<std::uint32_t>(ray.direction[axis]) >> 31) +
                          2 * side_bytes * axis;
        }
    }

    /// A bit for every child that the ray may meet before `limit`, and where it enters them. Where
    /// a side gives NaN another may be lost with it, which keeps more.
    LUCH_INLINE unsigned operator()(const Node& node, float limit, Eight& in) const {
        const char* bounds = reinterpret_cast<const char*>(node.bounds);
        const auto side = [&](std::uint32_t at) {
            return Eight::load(reinterpret_cast<const float*>(bounds + at));
        };
        const auto near = [&](int axis) {
            return times_minus(side(near_[axis]), inverse_[axis], near_shift_[axis]);
        };
        const auto far = [&](int axis) {
            return times_minus(side(near_[axis] ^ side_bytes), inverse_[axis], far_shift_[axis]);
        };
        in = max_or(max_or(near(0), near(1)), max_or(near(2), t_min_));
        const Eight out = min_or(min_or(far(0), far(1)), min_or(far(2), Eight(limit)));
        return (in <= out) & node.used;
    }

 private:
    Eight inverse_[3], near_shift_[3], far_shift_[3];
    Eight t_min_;
    static constexpr std::uint32_t side_bytes = sizeof Node::bounds[0];
    std::uint32_t near_[3];  ///< where in a node the sides are that the ray enters through
};

/// A child to be visited later, and where the ray enters it.
struct Entry {
    float near;
    std::uint32_t child;
};

/// Pushes all children but the nearest, the farther deeper; returns the nearest. Branches that the
/// processor guesses right let it go on before it knows the order, so this sorts by branches.
LUCH_INLINE std::uint32_t push_sorted(const Node& node, unsigned mask, const Eight& in,
                                      Entry*& top) {
    const std::uint32_t only = node.child[std::countr_zero(mask)];
    if ((mask & (mask - 1)) == 0) return only;
    alignas(32) float near[node_width];
    in.store(near);
    const auto next = [&] {
        const int i = std::countr_zero(mask);
        mask &= mask - 1;
        return Entry{near[i], node.child[i]};
    };
    Entry first = next(), second = next();
    if (second.near < first.near) std::swap(first, second);
    Entry* const bottom = ++top;
    *bottom = second;
    while (mask != 0) {
        Entry entry = next();
        if (entry.near < first.near) std::swap(entry, first);
        Entry* at = ++top;
        for (; at > bottom && at[-1].near < entry.near; --at) *at = at[-1];
        *at = entry;
    }
    return first.child;
}

/// Visits the leaves that a ray may meet before `limit`, near to far; leaf(number) returns the
/// limit from then on, −∞ to end it. Returns how many nodes were opened.
template <class Leaf>
LUCH_INLINE std::uint32_t visit_leaves(const Tree& tree, const NodeTest& test_node, float limit,
                                       Leaf&& leaf) {
    constexpr std::uint32_t end = ~0u;
    Entry stack[max_depth * (node_width - 1) + 1];
    stack[0] = {-infinite, end};
    Entry* top = stack;
    std::uint32_t child = 0, nodes = 0;
    for (;;) {
        while ((child & leaf_bit) == 0) {
            const Node& node = tree.nodes[child];
            ++nodes;
            Eight in;
            const unsigned mask = test_node(node, limit, in);
            if (mask == 0) break;
            child = push_sorted(node, mask, in, top);
        }
        if ((child & leaf_bit) != 0) limit = leaf(child & ~leaf_bit);
        while (!(top->near <= limit)) --top;
        child = top--->child;
        if (child == end) return nodes;
    }
}

/// Improves best, or stops at anything that does.
template <bool any>
bool search(const Tree& tree, const ObjectRay& ray, NodeId node, Hit& best, WorkCounts& work) {
    const BlockTest test_block(ray, node, tree.cull_backfaces);
    Search found{best, {}};
    std::uint32_t blocks = 0;
    bool improved = false;
    const std::uint32_t nodes =
        visit_leaves(tree, NodeTest(ray, tree.extent), best.t, [&](std::uint32_t block) {
            ++blocks;
            improved |= test_block(tree.blocks[block], found);
            return any && improved ? -infinite : best.t;
        });
    work.boxes += std::uint64_t{nodes} * node_width;
    work.primitives += std::uint64_t{blocks} * block_width;
    if (any || !improved) return improved;
    const Barycentric at = barycentric(found.weights[0], found.weights[1], found.weights[2]);
    best.u = at.u;
    best.v = at.v;
    return true;
}

void walk(const Tree& tree, const ObjectRay& ray, float limit, float slack,
          float (*leaf)(void* context, std::uint32_t number), void* context, WorkCounts& work) {
    const std::uint32_t nodes =
        visit_leaves(tree, NodeTest(ray, tree.extent, slack), limit,
                     [&](std::uint32_t number) { return leaf(context, number); });
    work.boxes += std::uint64_t{nodes} * node_width;
}

bool closest(const Tree& tree, const ObjectRay& ray, NodeId node, Hit& best, WorkCounts& work) {
    return search<false>(tree, ray, node, best, work);
}

bool occluded(const Tree& tree, const ObjectRay& ray, WorkCounts& work) {
    Hit blocker{.t = ray.t_max};
    return search<true>(tree, ray, 0, blocker, work);
}

}  // namespace
}  // namespace luch::wide
