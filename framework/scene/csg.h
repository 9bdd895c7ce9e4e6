#pragma once

#include "framework/math/bounds.h"
#include "framework/math/transform.h"

#include <cstdint>
#include <vector>

namespace luch {

/// Index into Scene::geometries.
using GeometryId = std::uint32_t;

/// Constructive solid geometry: a boolean expression of other geometries, after S. Roth, "Ray
/// Casting for Modeling Solids" (1982). It is kept flat: nested solids are unfolded into parts,
/// which are no solids themselves, and gates that join them. Values travel along wires: wire i is
/// "inside part i", wire parts.size() + j is the result of gate j; the last one is the solid.
/// make_csg() in geometry.h makes them.
struct Csg {
    enum class Operation : std::uint8_t { join, intersect, subtract };
    using Wire = std::uint16_t;
    static constexpr std::size_t most_parts = 4096;

    struct Part {
        GeometryId geometry;
        std::uint32_t first_primitive;  ///< the part's own primitives are counted on from here
        bool flipped;        ///< its outward normal is the solid's inward one (it is subtracted)
        Transform to_frame;  ///< from the solid's coordinates to the part's (a mesh's own frame)
    };
    struct Gate {
        Operation operation;
        Wire left, right;
        [[nodiscard]] bool result(bool in_left, bool in_right) const {
            switch (operation) {
                case Operation::join:
                    return in_left || in_right;
                case Operation::intersect:
                    return in_left && in_right;
                case Operation::subtract:
                    break;
            }
            return in_left && !in_right;
        }
    };

    Operation operation = Operation::join;
    GeometryId left = 0, right = 0;  ///< as the scene says
    std::vector<Part> parts;
    std::vector<Gate> gates;    ///< in an order in which their inputs are known
    std::vector<Wire> gate_of;  ///< wire of the gate that a wire leads to; the last leads nowhere
    std::uint32_t primitives = 0;
    Boxd bounds;           ///< the surface lies in it
    bool bounded = false;  ///< certainly outside of the solid wherever outside of `bounds`

    [[nodiscard]] std::size_t wires() const { return parts.size() + gates.size(); }
    /// The part that a primitive of the solid belongs to.
    [[nodiscard]] const Part& part_of(std::uint32_t primitive) const;
};

}  // namespace luch
