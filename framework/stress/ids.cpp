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

/// A picture's ids, pixel by pixel, against the nodes that rays meet. What a mask says was traced
/// is no word of the buffer's.
struct Ids {
    std::size_t covered = 0, wrong = 0, traced = 0;
};

Ids counted_ids(const Image<NodeId>& ids, const Image<std::uint8_t>* traced, const Screen& screen,
                const Accelerator& accelerator) {
    Ids counts;
    WorkCounts work;
    for (int y = 0; y < ids.height(); ++y) {
        for (int x = 0; x < ids.width(); ++x) {
            const Hit hit = accelerator.closest(screen.ray(x + 0.5, y + 0.5), work);
            const bool gave_up = traced != nullptr && (*traced)(x, y) != 0;
            counts.covered += hit ? 1 : 0;
            counts.traced += gave_up ? 1 : 0;
            counts.wrong += !gave_up && ids(x, y) != hit.node ? 1 : 0;
        }
    }
    return counts;
}

/// At most a share of the covered pixels may be wrong.
StressResult ids_of(const Subject& subject, Scene scene, double share) {
    const OwnStudio studio(std::move(scene));
    Shot shot = shot_of(studio.scene());
    shot.spp = subject.spp();
    const Outcome outcome = studio.render(*subject.info->create(), shot);
    if (!outcome.plan.applies) return {StressVerdict::does_not_apply, outcome.plan.why};
    const auto* ids = plane_of_kind<NodeId>(outcome.frame, PlaneKind::id);
    if (ids == nullptr) return {StressVerdict::does_not_apply, "no plane of ids"};
    const Ids counts =
        counted_ids(*ids, plane_of_kind<std::uint8_t>(outcome.frame, PlaneKind::mask),
                    Screen(shot.camera, shot.size), studio.studio().accelerator);
    const bool right =
        static_cast<double>(counts.wrong) <= share * static_cast<double>(counts.covered);
    return finished(outcome,
                    judged(right, fmt::format("{} wrong of {} covered, {} traced", counts.wrong,
                                              counts.covered, counts.traced)));
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
    const auto add = [&](std::string name, std::string expected, double share,
                         std::function<Scene()> scene) {
        list.add(15, "ids of " + std::move(name), std::move(expected),
                 [subject = list.subject, share, scene = std::move(scene)] {
                     return ids_of(subject, scene(), share);
                 });
    };
    for (const Thing thing : all_things) {
        const bool round = thing == Thing::sphere || thing == Thing::solid;
        add(std::string(to_string(thing)),
            round ? "those of rays, ≤ 5 % at rims" : "those of rays, ≤ 0.2 % at edges",
            round ? rims : edges, [thing] { return larger(one_thing(thing)); });
    }
    add("a shape of every kind", "those of rays, ≤ 5 % at rims", rims, one_of_each);
    add("sixty spheres", "those of rays, ≤ 5 % at rims", rims, sixty_spheres);
    add("nothing", "none", 0, empty_scene);
}

}  // namespace luch::stress
