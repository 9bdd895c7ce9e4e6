#include "framework/accel/csg_hit.h"

#include <algorithm>

namespace luch {
namespace {

/// Which wires of a solid are on: is the ray inside this part, inside this partial result?
class Switchboard {
 public:
    explicit Switchboard(const Csg& csg) : csg_(csg) { std::fill_n(on_.begin(), csg.wires(), 0); }

    /// Whether the ray is inside the whole solid.
    [[nodiscard]] bool result() const { return on_[csg_.wires() - 1] != 0; }

    void toggle(std::uint32_t part) {
        std::size_t wire = part;
        on_[wire] ^= 1;
        while (wire + 1 < csg_.wires()) {
            wire = csg_.gate_of[wire];
            const Csg::Gate& gate = csg_.gates[wire - csg_.parts.size()];
            const bool now = gate.result(on_[gate.left] != 0, on_[gate.right] != 0);
            if (now == (on_[wire] != 0)) return;
            on_[wire] = now;
        }
    }

 private:
    const Csg& csg_;
    std::array<std::uint8_t, 2 * Csg::most_parts> on_;  // only the wires that there are are set
};

void add(const Plane& plane, const Ray& ray, Crossings& crossings, WorkCounts& work) {
    ++work.primitives;
    find_crossings(plane, ray, crossings);
}
void add(const Sphere& sphere, const Ray& ray, Crossings& crossings, WorkCounts& work) {
    ++work.primitives;
    find_crossings(sphere, ray, crossings);
}
void add(const Cube& cube, const Ray& ray, Crossings& crossings, WorkCounts& work) {
    ++work.primitives;
    find_crossings(cube, ray, crossings);
}
void add(const Heightfield& field, const Ray& ray, Crossings& crossings, WorkCounts& work) {
    find_crossings(field, ray, crossings, work);
}
void add(const Mesh&, const Ray&, Crossings&, WorkCounts&) {}  // found by who has its BVH
void add(const Csg&, const Ray&, Crossings&, WorkCounts&) {}   // no part of a solid is a solid

}  // namespace

void find_crossings(const Geometry& geometry, const Ray& ray, Crossings& crossings,
                    WorkCounts& work) {
    std::visit([&](const auto& shape) { add(shape, ray, crossings, work); }, geometry);
}

std::optional<Hit> first_change(const Csg& csg, Crossings& crossings, const Ray& ray) {
    auto& found = crossings.found();
    std::sort(found.begin(), found.end());
    Switchboard board(csg);
    for (const Crossing& crossing : found) board.toggle(crossing.part);
    for (std::size_t i = 0; i < found.size();) {
        const float t = found[i].t;
        if (!(t < ray.t_max)) break;
        const bool before = board.result();
        const Crossing* changer = nullptr;
        for (; i < found.size() && found[i].t == t; ++i) {
            const bool was = board.result();
            board.toggle(found[i].part);
            if (board.result() != was) changer = &found[i];
        }
        if (board.result() == before) continue;
        return Hit{t, changer->u, changer->v, no_node,
                   csg.parts[changer->part].first_primitive + changer->primitive};
    }
    return std::nullopt;
}

}  // namespace luch
