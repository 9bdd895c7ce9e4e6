#include "techniques/shadow_map/content.h"

#include <bit>
#include <cstring>

namespace luch::techniques::shadow_map {
namespace {

template <class T>
Key followed_all(Key key, const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::size_t bytes = values.size() * sizeof(T);
    key = key.branch(values.size());
    const auto* from = reinterpret_cast<const char*>(values.data());
    for (std::size_t at = 0; at < bytes; at += sizeof(std::uint64_t)) {
        std::uint64_t word = 0;
        std::memcpy(&word, from + at, std::min(sizeof word, bytes - at));
        key = key.branch(word);
    }
    return key;
}

Key followed(Key key, const Transform& transform) {
    for (int i = 0; i < 3; ++i) key = shadow_map::followed(key, transform.matrix[i]);
    return shadow_map::followed(key, transform.offset);
}

/// What a geometry's key follows with; those of solids need the keys of their parts.
struct GeometryKey {
    const std::vector<Key>& parts;
    Key key;

    Key operator()(const Plane& plane) const {
        return shadow_map::followed(shadow_map::followed(key, plane.y), plane.limit);
    }
    Key operator()(const Sphere& sphere) const {
        return shadow_map::followed(shadow_map::followed(key, sphere.centre), sphere.radius);
    }
    Key operator()(const Cube& cube) const {
        return shadow_map::followed(shadow_map::followed(key, cube.centre), cube.side);
    }
    Key operator()(const Mesh& mesh) const {
        Key all = followed_all(key, mesh.positions).branch(mesh.cull_backfaces ? 1 : 0);
        for (const Mesh::Triangle& triangle : mesh.triangles) {
            const auto& [a, b, c] = triangle.position;
            all = all.branch(std::uint64_t{a} << 32 | b).branch(c);
        }
        return all;
    }
    Key operator()(const Heightfield& field) const {
        Key all = key.branch(static_cast<std::uint64_t>(field.width()));
        for (int z = 0; z < field.height(); ++z) {
            for (int x = 0; x < field.width(); ++x) {
                all = all.branch(std::bit_cast<std::uint32_t>(field.at(x, z)));
            }
        }
        return all;
    }
    Key operator()(const Csg& csg) const {
        Key all = key;
        for (const Csg::Part& part : csg.parts) {
            all = followed(all.branch(parts[part.geometry].bits(0)), part.to_frame);
        }
        for (const Csg::Gate& gate : csg.gates) {
            const auto operation = static_cast<std::uint64_t>(gate.operation);
            all = all.branch(operation << 32 | std::uint64_t{gate.left} << 16 | gate.right);
        }
        return all;
    }
};

bool receives(const Scene& scene, const Node& node) {
    if (node.material == materials_of_file) return true;
    const Material& material = scene.materials[node.material];
    return !std::holds_alternative<Const>(material) &&
           !std::holds_alternative<Emission>(material) &&
           !std::holds_alternative<Reflection>(material) &&
           !std::holds_alternative<Refraction>(material);
}

/// Hits may lie so far outside of a node's box, in its sizes and distances: rounding of a mesh's
/// rays to float, with room.
constexpr double padding = 0x1p-18;

Boxd padded(Boxd box) {
    if (box.empty()) return box;
    for (int axis = 0; axis < 3; ++axis) {
        const double most = std::max(std::abs(box.lo[axis]), std::abs(box.hi[axis]));
        if (!std::isfinite(most)) continue;
        box.lo[axis] -= padding * most;
        box.hi[axis] += padding * most;
    }
    return box;
}

}  // namespace

Key followed(Key key, double number) {
    return key.branch(std::bit_cast<std::uint64_t>(number));
}

Key followed(Key key, const Vec3d& numbers) {
    return followed(followed(followed(key, numbers.x), numbers.y), numbers.z);
}

Content::Content(const Scene& scene) {
    std::vector<Key> geometries(scene.geometries.size());
    std::vector<Boxd> boxes;
    for (const bool solids : {false, true}) {  // whose parts are no solids
        for (std::size_t i = 0; i < geometries.size(); ++i) {
            const Geometry& geometry = scene.geometries[i];
            if (std::holds_alternative<Csg>(geometry) != solids) continue;
            geometries[i] = std::visit(GeometryKey{geometries, Key(geometry.index())}, geometry);
        }
    }
    for (const Geometry& geometry : scene.geometries) boxes.push_back(bounds_of(geometry));
    Key all(scene.nodes.size());
    for (const Node& node : scene.nodes) {
        const Key key = followed(geometries[node.geometry].branch(things_.size()), node.to_world);
        things_.push_back(
            {key, padded(node.to_world.box(boxes[node.geometry])), receives(scene, node)});
        all = all.branch(key.bits(0)).branch(things_.back().receives ? 1 : 0);
    }
    digest_ = all.bits(0);
}

}  // namespace luch::techniques::shadow_map
