#include "framework/accel/bvh.h"

#include <algorithm>
#include <numeric>

namespace luch {
namespace {

constexpr int bin_count = 16;
constexpr std::uint32_t max_leaf = 4;

/// Primitives [first, first + count) of the order, to become the subtree at `node`.
struct Task {
    std::uint32_t node, first, count;
    int depth;
};

/// Where to split: primitives whose centre falls into a bin ≤ `bin` along `axis` go left.
struct Split {
    int axis = -1;
    int bin = 0;
};

template <class B>
class Builder {
 public:
    using V = decltype(B::lo);
    using Scalar = typename B::Scalar;
    using Node = typename Bvh<B>::Node;

    Builder(std::span<const B> boxes, std::vector<Node>& nodes, std::vector<std::uint32_t>& order)
        : boxes_(boxes), nodes_(nodes), order_(order) {}

    void build() {
        order_.resize(boxes_.size());
        std::iota(order_.begin(), order_.end(), 0u);
        if (boxes_.empty()) return;
        nodes_.reserve(2 * boxes_.size());
        nodes_.emplace_back();
        std::vector<Task> tasks{{0, 0, static_cast<std::uint32_t>(boxes_.size()), 0}};
        while (!tasks.empty()) {
            const Task task = tasks.back();
            tasks.pop_back();
            const std::uint32_t left = divide(task);
            if (left == task.count) continue;
            const auto child = static_cast<std::uint32_t>(nodes_.size());
            nodes_[task.node].first = child;
            nodes_[task.node].count = 0;
            nodes_.resize(nodes_.size() + 2);
            tasks.push_back({child, task.first, left, task.depth + 1});
            tasks.push_back({child + 1, task.first + left, task.count - left, task.depth + 1});
        }
    }

 private:
    /// Fills the node as a leaf; returns how many primitives go left, or all for a leaf.
    std::uint32_t divide(const Task& task) {
        const auto begin = order_.begin() + task.first, end = begin + task.count;
        B box, centres;
        for (auto i = begin; i != end; ++i) {
            box.grow(boxes_[*i]);
            centres.grow(boxes_[*i].centre());
        }
        nodes_[task.node] = {box, task.first, task.count};
        if (task.count == 1) return 1;
        const Split split =
            task.depth < Bvh<B>::sah_depth ? best_split(task, box, centres) : Split{};
        if (split.axis >= 0) {
            const auto middle = std::partition(begin, end, [&](std::uint32_t i) {
                return bin_of(i, split.axis, centres) <= split.bin;
            });
            return static_cast<std::uint32_t>(middle - begin);
        }
        return task.count <= max_leaf ? task.count : task.count / 2;
    }

    /// Which bin a primitive's centre falls into. Written so that NaN and infinity land in one too.
    int bin_of(std::uint32_t primitive, int axis, const B& centres) const {
        const Scalar width = centres.hi[axis] - centres.lo[axis];
        const Scalar bin =
            (boxes_[primitive].centre()[axis] - centres.lo[axis]) / width * Scalar(bin_count);
        if (!(bin > 0)) return 0;
        return bin < bin_count ? static_cast<int>(bin) : bin_count - 1;
    }

    /// The cheapest split, or axis −1 when a leaf is cheaper or no plane separates the centres. A
    /// step down costs as much as one primitive's test.
    Split best_split(const Task& task, const B& box, const B& centres) const {
        Split best;
        Scalar best_cost = task.count <= max_leaf ? box.half_area() * Scalar(task.count - 1)
                                                  : std::numeric_limits<Scalar>::infinity();
        for (int axis = 0; axis < 3; ++axis) {
            if (!(centres.hi[axis] > centres.lo[axis])) continue;
            std::array<B, bin_count> bins;
            std::array<std::uint32_t, bin_count> counts{};
            for (std::uint32_t i = task.first; i < task.first + task.count; ++i) {
                const int bin = bin_of(order_[i], axis, centres);
                bins[bin].grow(boxes_[order_[i]]);
                ++counts[bin];
            }
            std::array<Scalar, bin_count> right_cost{};
            B right;
            std::uint32_t right_count = 0;
            for (int bin = bin_count - 1; bin > 0; --bin) {
                right.grow(bins[bin]);
                right_count += counts[bin];
                right_cost[bin] = right.half_area() * Scalar(right_count);
            }
            B left;
            std::uint32_t left_count = 0;
            for (int bin = 0; bin + 1 < bin_count; ++bin) {
                left.grow(bins[bin]);
                left_count += counts[bin];
                if (left_count == 0 || left_count == task.count) continue;
                const Scalar cost = left.half_area() * Scalar(left_count) + right_cost[bin + 1];
                if (cost < best_cost) {
                    best_cost = cost;
                    best = {axis, bin};
                }
            }
        }
        return best;
    }

    std::span<const B> boxes_;
    std::vector<Node>& nodes_;
    std::vector<std::uint32_t>& order_;
};

}  // namespace

template <class B>
Bvh<B>::Bvh(std::span<const B> boxes) {
    Builder<B>(boxes, nodes_, order_).build();
}

template class Bvh<Box>;
template class Bvh<Boxd>;

}  // namespace luch
