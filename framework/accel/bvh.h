#pragma once

#include "framework/math/bounds.h"

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace luch {

/// A binary bounding volume hierarchy over boxes, built by the binned surface area heuristic
/// (Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007).
/// B is Box (triangles in a mesh's frame) or Boxd (nodes in the world).
template <class B>
class Bvh {
 public:
    struct Node {
        B box;
        std::uint32_t first =
            0;  ///< leaf: index into order(); inner: left child, the right one follows
        std::uint32_t count = 0;  ///< primitives of a leaf; 0: an inner node
    };
    /// Deeper than this a node is split by count, so no input makes the traversal's stack overflow.
    static constexpr int sah_depth = 48;
    static constexpr int stack_size = sah_depth + 40;

    Bvh() = default;
    explicit Bvh(std::span<const B> boxes);

    /// The root comes first, children after their parent; empty when there are no boxes.
    [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
    /// The primitives, those of a leaf together.
    [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }
    [[nodiscard]] std::uint64_t bytes() const {
        return nodes_.size() * sizeof(Node) + order_.size() * sizeof(std::uint32_t);
    }

    /// Visits leaves from near to far. `enter(node index)` gives the t at which the ray enters the
    /// node, or a NaN to leave it out; `limit()` is the t beyond which nothing is wanted any more;
    /// `leaf(node)` returns true to end the walk.
    template <class Enter, class Limit, class Leaf>
    void walk(Enter&& enter, Limit&& limit, Leaf&& leaf) const;

 private:
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
};

template <class B>
template <class Enter, class Limit, class Leaf>
void Bvh<B>::walk(Enter&& enter, Limit&& limit, Leaf&& leaf) const {
    using Scalar = typename B::Scalar;
    struct Entry {
        std::uint32_t node;
        Scalar near;
    };
    std::array<Entry, stack_size> stack;
    int size = 0;
    const auto push = [&](Entry entry) {
        if (entry.near <= limit()) stack[size++] = entry;  // false for NaN, too
    };
    if (!nodes_.empty()) push({0, enter(0u)});
    while (size > 0) {
        const Entry entry = stack[--size];
        if (!(entry.near <= limit())) continue;
        const Node& node = nodes_[entry.node];
        if (node.count > 0) {
            if (leaf(node)) return;
            continue;
        }
        Entry near{node.first, enter(node.first)};
        Entry far{node.first + 1, enter(node.first + 1)};
        if (far.near < near.near) std::swap(near, far);
        push(far);
        push(near);
    }
}

extern template class Bvh<Box>;
extern template class Bvh<Boxd>;

}  // namespace luch
