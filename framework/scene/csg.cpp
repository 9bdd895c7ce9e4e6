#include "framework/scene/csg.h"

#include "framework/scene/geometry.h"

#include <algorithm>
#include <stdexcept>

namespace luch {
namespace {

/// A geometry that is no solid, as one of a single part and no gate.
Csg single(GeometryId id, const Geometry& geometry) {
    const auto* mesh = std::get_if<Mesh>(&geometry);
    const Transform from_frame = mesh ? mesh->from_frame : Transform();
    Csg csg;
    csg.parts.push_back({id, 0, false, from_frame.inverse()});
    csg.primitives = primitive_count(geometry);
    csg.bounds = from_frame.box(bounds_of(geometry));
    // A ball and a cube are closed; a mesh may have holes, and the others have no inside.
    csg.bounded =
        std::holds_alternative<Sphere>(geometry) || std::holds_alternative<Cube>(geometry);
    return csg;
}

Csg side_of(GeometryId id, const std::vector<Geometry>& geometries) {
    const auto* csg = std::get_if<Csg>(&geometries[id]);
    return csg ? *csg : single(id, geometries[id]);
}

Boxd common(const Boxd& a, const Boxd& b) {
    return {glm::max(a.lo, b.lo), glm::min(a.hi, b.hi)};
}

/// Where one side is open, "inside" reaches out of its box along a ray, and so may the other's
/// surface that is seen there.
void set_bounds(Csg& csg, const Csg& left, const Csg& right) {
    csg.bounds = left.bounds;
    csg.bounds.grow(right.bounds);
    csg.bounded = left.bounded && right.bounded;
    if (csg.operation == Csg::Operation::join) return;
    const bool both = csg.operation == Csg::Operation::intersect;
    csg.bounded = left.bounded || (both && right.bounded);
    if (both && left.bounded && right.bounded) {
        csg.bounds = common(left.bounds, right.bounds);
    } else if (left.bounded) {
        csg.bounds = left.bounds;
    } else if (both && right.bounded) {
        csg.bounds = right.bounds;
    }
}

/// Adds one side's parts and gates, and gives the wire that its value comes out of. Wires of the
/// whole: all parts, then all gates.
Csg::Wire add_side(Csg& csg, const Csg& side, std::size_t first_part, std::size_t part_count,
                   bool flipped) {
    const std::size_t first_gate = part_count + csg.gates.size();
    const auto moved = [&](Csg::Wire wire) {
        const bool is_part = wire < side.parts.size();
        return static_cast<Csg::Wire>(is_part ? wire + first_part
                                              : wire - side.parts.size() + first_gate);
    };
    for (Csg::Part part : side.parts) {
        part.first_primitive += csg.primitives;
        part.flipped = part.flipped != flipped;
        csg.parts.push_back(part);
    }
    csg.primitives += side.primitives;
    for (const Csg::Gate& gate : side.gates) {
        csg.gates.push_back({gate.operation, moved(gate.left), moved(gate.right)});
    }
    return moved(static_cast<Csg::Wire>(side.wires() - 1));
}

}  // namespace

const Csg::Part& Csg::part_of(std::uint32_t primitive) const {
    const auto after = std::upper_bound(
        parts.begin(), parts.end(), primitive,
        [](std::uint32_t p, const Part& part) { return p < part.first_primitive; });
    return *std::prev(after);
}

Csg make_csg(Csg::Operation operation, GeometryId left_id, GeometryId right_id,
             const std::vector<Geometry>& geometries) {
    const Csg left = side_of(left_id, geometries), right = side_of(right_id, geometries);
    Csg csg;
    csg.operation = operation;
    csg.left = left_id;
    csg.right = right_id;
    const std::size_t part_count = left.parts.size() + right.parts.size();
    if (part_count > Csg::most_parts) throw std::length_error("too many parts");
    if (std::uint64_t{left.primitives} + right.primitives > ~std::uint32_t{0}) {
        throw std::length_error("too many primitives");
    }
    const Csg::Wire from_left = add_side(csg, left, 0, part_count, false);
    const Csg::Wire from_right =
        add_side(csg, right, left.parts.size(), part_count, operation == Csg::Operation::subtract);
    csg.gates.push_back({operation, from_left, from_right});
    csg.gate_of.assign(csg.wires(), 0);
    for (std::size_t j = 0; j < csg.gates.size(); ++j) {
        const auto wire = static_cast<Csg::Wire>(part_count + j);
        csg.gate_of[csg.gates[j].left] = csg.gate_of[csg.gates[j].right] = wire;
    }
    set_bounds(csg, left, right);
    return csg;
}

}  // namespace luch
