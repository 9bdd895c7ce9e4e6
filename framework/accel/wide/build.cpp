#include "framework/accel/wide/build.h"

#include "framework/accel/wide/kernels.h"
#include "framework/parallel/workers.h"

#include <array>
#include <memory>
#include <span>

namespace luch::wide {
namespace {

/// Deeper than this, ranges are cut in two by count.
constexpr int sah_depth = 48;
/// Ranges smaller than this are one thread's.
constexpr std::uint32_t parallel_count = 4096;
/// What a node costs beside a block of triangles.
constexpr float node_cost = 1;

/// A node of the binary tree, and the cost of the cheapest forest of at most i + 1 wide nodes and
/// leaves that stands for it (Ylitie, Karras, Laine, "Efficient Incoherent Ray Traversal on GPUs
/// Through Compressed Wide BVHs", 2017, section 3). A subtree of n triangles has 2n − 1 nodes from
/// its root on, wherever they are used.
struct Binary {
    Corners box;
    std::uint32_t first, count;  ///< of the refs
    std::uint32_t right = 0;     ///< the right child; 0: a leaf. The left one comes next.
    std::array<float, node_width - 1> cost;
    std::array<std::uint8_t, node_width + 1> left_share;  ///< of i wide nodes, how many are left's
};

class Builder {
 public:
    /// At most `leaf_size` things to a leaf.
    Builder(std::size_t count, std::uint32_t leaf_size, Isa isa)
        : kernels_(kernels(isa)),
          count_(static_cast<std::uint32_t>(count)),
          leaf_size_(leaf_size),
          refs_(new Ref[count_]),
          nodes_(new Binary[2 * static_cast<std::size_t>(count_)]) {}

    /// box_of(i): of a thing; add_leaf(refs): the number of a leaf with these.
    template <class BoxOf, class AddLeaf>
    std::vector<Node> build(BoxOf&& box_of, AddLeaf&& add_leaf) {
        wide_.reserve(count_ / 8 + 1);
        wide_.emplace_back();
        for (std::uint32_t i = 0; i < count_; ++i) {
            const Box box = box_of(i);
            refs_[i] = {{box.lo.x, box.lo.y, box.lo.z}, i, {box.hi.x, box.hi.y, box.hi.z}, 0};
        }
        if (count_ > 0) {
            const Range all = kernels_.range_of(refs_.get(), count_);
            divide(all, 0, 0);
        }
        emit(add_leaf);
        return std::move(wide_);
    }

    /// The largest |bound|.
    [[nodiscard]] float extent() const {
        float most = 0;
        for (int axis = 0; axis < 3 && count_ > 0; ++axis) {
            const Corners& box = nodes_[0].box;
            most = std::max({most, std::abs(box.lo[axis]), std::abs(box.hi[axis])});
        }
        return most;
    }

 private:
    void divide(const Range& range, std::uint32_t index, int depth) {
        Binary& node = nodes_[index];
        node.box = range.box;
        node.first = range.first;
        node.count = range.count;
        node.right = 0;
        if (range.count <= leaf_size_) {
            node.cost.fill(half_area(range.box));
            return;
        }
        Range left, right;
        kernels_.split(refs_.get(), range, depth >= sah_depth, left, right);
        node.right = index + 2 * left.count;
        const std::uint32_t right_index = node.right;
        if (range.count < parallel_count) {
            divide(left, index + 1, depth + 1);
            divide(right, right_index, depth + 1);
        } else {
            run_both([&] { divide(left, index + 1, depth + 1); },
                     [&] { divide(right, right_index, depth + 1); });
        }
        weigh(node, nodes_[index + 1], nodes_[right_index]);
    }

    /// How i places are best shared between two children, and what that costs.
    static void weigh(Binary& node, const Binary& left, const Binary& right) {
        std::array<float, node_width + 1> shared;
        for (int places = 2; places <= node_width; ++places) {
            shared[places] = std::numeric_limits<float>::infinity();
            node.left_share[places] = 1;
            for (int i = 1; i < places; ++i) {
                const float cost = left.cost[i - 1] + right.cost[places - i - 1];
                if (i > node_width - 1 || places - i > node_width - 1) continue;
                if (cost < shared[places]) {
                    shared[places] = cost;
                    node.left_share[places] = static_cast<std::uint8_t>(i);
                }
            }
        }
        node.cost[0] = shared[node_width] + node_cost * half_area(node.box);
        for (int places = 2; places < node_width; ++places) {
            node.cost[places - 1] = std::min(shared[places], node.cost[places - 2]);
            if (!(shared[places] < node.cost[places - 2])) node.left_share[places] = 0;
        }
    }

    struct Children {
        std::array<std::uint32_t, node_width> node;
        int count = 0;
    };

    /// The wide nodes and leaves that stand for a binary node in so many places.
    void gather(std::uint32_t index, int places, Children& children) const {
        const Binary& node = nodes_[index];
        while (places > 1 && places < node_width && node.right != 0 &&
               node.left_share[places] == 0) {
            --places;
        }
        if (node.right == 0 || places == 1) {
            children.node[children.count++] = index;
            return;
        }
        gather(index + 1, node.left_share[places], children);
        gather(node.right, places - node.left_share[places], children);
    }

    template <class AddLeaf>
    void emit(AddLeaf&& add_leaf) {
        struct Task {
            std::uint32_t binary, wide;
        };
        std::vector<Task> tasks{{0, 0}};
        while (!tasks.empty()) {
            const Task task = tasks.back();
            tasks.pop_back();
            Children children;
            if (count_ > 0) gather(task.binary, node_width, children);
            Node node{};
            node.used = (1u << children.count) - 1;
            for (int i = 0; i < node_width; ++i) {
                if (i >= children.count) {
                    set_empty(node, i);
                    continue;
                }
                const Binary& child = nodes_[children.node[i]];
                set_box(node, i, child.box);
                if (child.right == 0) {
                    node.child[i] =
                        leaf_bit | add_leaf(std::span(&refs_[child.first], child.count));
                } else {
                    node.child[i] = static_cast<std::uint32_t>(wide_.size());
                    wide_.emplace_back();
                    tasks.push_back({children.node[i], node.child[i]});
                }
            }
            wide_[task.wide] = node;
        }
    }

    static void set_box(Node& node, int slot, const Corners& box) {
        for (int axis = 0; axis < 3; ++axis) {
            node.bounds[2 * axis][slot] = box.lo[axis];
            node.bounds[2 * axis + 1][slot] = box.hi[axis];
        }
    }
    static void set_empty(Node& node, int slot) {
        for (int axis = 0; axis < 3; ++axis) {
            node.bounds[2 * axis][slot] = std::numeric_limits<float>::infinity();
            node.bounds[2 * axis + 1][slot] = -std::numeric_limits<float>::infinity();
        }
    }

    const Kernels& kernels_;
    std::uint32_t count_, leaf_size_;
    std::unique_ptr<Ref[]> refs_;
    std::unique_ptr<Binary[]> nodes_;
    std::vector<Node> wide_;
};

Block block_of(const Mesh& mesh, std::span<const Ref> refs) {
    Block block{};
    for (std::size_t lane = 0; lane < block_width; ++lane) {
        block.id[lane] = refs[std::min(lane, refs.size() - 1)].id;
        block.edge[lane] = 0;
        for (int k = 0; k < 3; ++k) {
            const Vec3& corner = mesh.corner(block.id[lane], k);
            const Vec3 edge = glm::abs(mesh.corner(block.id[lane], (k + 1) % 3) - corner);
            // Arguments in this order leave out NaN.
            block.edge[lane] =
                std::max(std::max(std::max(block.edge[lane], edge.x), edge.y), edge.z);
            for (int axis = 0; axis < 3; ++axis) block.corner[3 * k + axis][lane] = corner[axis];
        }
    }
    return block;
}

}  // namespace

Tree built(const Mesh& mesh, Isa isa) {
    Tree tree;
    tree.cull_backfaces = mesh.cull_backfaces;
    tree.blocks.reserve(mesh.triangles.size() / 3 + 1);
    Builder builder(mesh.triangles.size(), block_width, isa);
    tree.nodes = builder.build([&](std::uint32_t i) { return mesh.box(i); },
                               [&](std::span<const Ref> refs) {
                                   tree.blocks.push_back(block_of(mesh, refs));
                                   return static_cast<std::uint32_t>(tree.blocks.size() - 1);
                               });
    tree.extent = builder.extent();
    return tree;
}

Tree built(std::span<const Box> boxes, Isa isa) {
    Tree tree;
    Builder builder(boxes.size(), 1, isa);
    tree.nodes = builder.build([&](std::uint32_t i) { return boxes[i]; },
                               [](std::span<const Ref> refs) { return refs[0].id; });
    tree.extent = builder.extent();
    return tree;
}

}  // namespace luch::wide
