#include "framework/scene/loader/gltf/hierarchy.h"

#include <fmt/format.h>

#include <stdexcept>

namespace luch::loader::gltf {
namespace {

/// 16 numbers, column by column, for a column vector: so each column is a row of ours.
Transform of_matrix(const Part& node, const std::vector<double>& m) {
    if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) {
        node.fail("its matrix does not end in the row 0 0 0 1; correct the file");
    }
    Transform transform{glm::dmat3(), {m[12], m[13], m[14]}};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            transform.matrix[column][row] = m[4 * row + column];
        }
    }
    return transform;
}

/// A unit quaternion's rotation as a matrix for row vectors (the transpose of the usual one).
glm::dmat3 rotation_of(const Part& node, const std::vector<double>& q) {
    const double largest =
        std::max({std::abs(q[0]), std::abs(q[1]), std::abs(q[2]), std::abs(q[3])});
    if (!(largest > 1e-30)) node.fail("its rotation is no quaternion; correct the file");
    double x = q[0] / largest, y = q[1] / largest, z = q[2] / largest, w = q[3] / largest;
    const double length = std::sqrt(x * x + y * y + z * z + w * w);
    x /= length, y /= length, z /= length, w /= length;
    const Vec3d rows[] = {{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
                          {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
                          {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)}};
    glm::dmat3 matrix;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) matrix[column][row] = rows[row][column];
    }
    return matrix;
}

Vec3d vector_of(const Part& node, std::string_view key, const Vec3d& fallback) {
    const auto n = node.numbers(key, 3);
    return n ? Vec3d((*n)[0], (*n)[1], (*n)[2]) : fallback;
}

/// A node's own transform: a matrix, or first scale, then rotation, then translation.
Transform local_transform(const Part& node) {
    if (const auto matrix = node.numbers("matrix", 16)) return of_matrix(node, *matrix);
    Transform transform = Transform::scaling(vector_of(node, "scale", Vec3d(1)));
    if (const auto q = node.numbers("rotation", 4)) {
        transform = transform.then({rotation_of(node, *q), Vec3d(0)});
    }
    return transform.then(Transform::translation(vector_of(node, "translation", Vec3d(0))));
}

void check_invertible(const Part& node, const Transform& to_scene) {
    constexpr double most = 1e30;
    const auto fail = [&] {
        node.fail(
            "its transform, with those around it, is singular; choose numbers that flatten "
            "nothing");
    };
    try {
        const Transform inverse = to_scene.inverse();
        if (!(max_norm(inverse.matrix) <= most && max_norm(to_scene.matrix) <= most &&
              max_norm(to_scene.offset) <= most)) {
            fail();
        }
    } catch (const std::domain_error&) {
        fail();
    }
}

/// A node still to be visited.
struct Waiting {
    std::uint64_t node;
    int depth;
    Transform parent;
};

}  // namespace

std::vector<Placed> placed_meshes(const Document& document) {
    constexpr int deepest = 256;
    const Part& root = document.root();
    if (root.size("scenes") == 0) root.fail("has no scene; export one");
    const Part scene = document.element("scenes", root.whole("scene").value_or(0), root);

    std::vector<Waiting> stack;
    std::vector<bool> seen(root.size("nodes"), false);
    const auto wait_for = [&](const Part& from, std::string_view key, int depth,
                              const Transform& parent) {
        const std::vector<std::uint64_t> nodes = from.wholes(key);
        for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
            const Part part = document.element("nodes", *node, from);
            if (seen[*node]) {
                part.fail(
                    "is reached twice: it contains itself or has two parents; make the "
                    "nodes a tree");
            }
            if (depth > deepest) part.fail("is nested deeper than 256; flatten the nodes");
            seen[*node] = true;
            stack.push_back({*node, depth, parent});
        }
    };
    std::vector<Placed> placed;
    wait_for(scene, "nodes", 1, Transform::scaling({1, 1, -1}));
    while (!stack.empty()) {
        const Waiting at = stack.back();
        stack.pop_back();
        const Part node = document.element("nodes", at.node, scene);
        const Transform to_scene = local_transform(node).then(at.parent);
        check_invertible(node, to_scene);
        if (const auto mesh = node.whole("mesh")) {
            placed.push_back({document.element("meshes", *mesh, node), to_scene});
        }
        wait_for(node, "children", at.depth + 1, to_scene);
    }
    return placed;
}

}  // namespace luch::loader::gltf
