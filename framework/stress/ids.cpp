#include "framework/stress/made/everything.h"
#include "framework/stress/subject.h"
#include "framework/stress/things.h"

#include <fmt/format.h>

namespace luch::stress {
namespace {

/// A plane of that kind with entries of that type; null when the frame has none.
template <class T>
const Image<T>* plane_of_kind(const Frame& frame, PlaneKind kind) {
    for (const Plane2d& plane : frame.planes()) {
        const auto* pixels = std::get_if<Image<T>>(&plane.pixels);
        if (plane.kind == kind && pixels != nullptr) return pixels;
    }
    return nullptr;
}

/// Every pixel's id against the node that its ray meets, but for pixels that a mask says were
/// traced. At most a share may be wrong.
Check ids_right(double share) {
    return [share](const Sight& sight) -> StressResult {
        const auto* ids = plane_of_kind<NodeId>(sight.outcome.frame, PlaneKind::id);
        if (ids == nullptr) return {StressVerdict::does_not_apply, "no plane of ids"};
        const auto* traced = plane_of_kind<std::uint8_t>(sight.outcome.frame, PlaneKind::mask);
        const Screen screen(sight.shot.camera, sight.shot.size);
        WorkCounts work;
        std::size_t covered = 0, wrong = 0, given_up = 0;
        for (int y = 0; y < ids->height(); ++y) {
            for (int x = 0; x < ids->width(); ++x) {
                const Hit hit = sight.accelerator.closest(screen.ray(x + 0.5, y + 0.5), work);
                covered += hit ? 1 : 0;
                if (traced != nullptr && (*traced)(x, y) != 0) {
                    ++given_up;
                } else if ((*ids)(x, y) != hit.node) {
                    ++wrong;
                }
            }
        }
        const bool right = static_cast<double>(wrong) <= share * static_cast<double>(covered);
        return judged(right,
                      fmt::format("{} wrong of {} covered, {} traced", wrong, covered, given_up));
    };
}

Scene larger(Scene scene) {
    scene.settings.frame = {160, 120};
    return scene;
}

}  // namespace

void add_ids(CaseList& list) {
    // What rounding to a grid on the screen may cost at an edge; a round shape that stands for
    // itself as a polyhedron may lose its rim.
    constexpr double edges = 0.002, rims = 0.05;
    for (const Thing thing : all_things) {
        const bool round = thing == Thing::sphere || thing == Thing::solid;
        list.look(
            15, fmt::format("ids of {}", to_string(thing)),
            round ? "those of rays, ≤ 5 % at rims" : "those of rays, ≤ 0.2 % at edges",
            [thing] { return larger(one_thing(thing)); }, ids_right(round ? rims : edges));
    }
    list.look(
        15, "ids of a shape of every kind", "those of rays, ≤ 5 % at rims",
        [] { return one_of_each(); }, ids_right(rims));
    list.look(
        15, "ids of sixty spheres", "those of rays, ≤ 5 % at rims", [] { return sixty_spheres(); },
        ids_right(rims));
    list.look(
        15, "ids of nothing", "none", [] { return empty_scene(); }, ids_right(0));
}

}  // namespace luch::stress
