#include "framework/math/rng.h"
#include "framework/stress/made/meshes.h"
#include "framework/stress/made/scenes.h"
#include "framework/stress/raster/sights.h"
#include "framework/stress/rays/rows.h"
#include "framework/stress/things.h"

#include <fmt/format.h>

namespace luch::stress {

namespace {

/// Many things, turned and mirrored, most of them meshes.
Scene crowd() {
    Scene scene = empty_scene();
    for (int i = 0; i < 30; ++i) {
        const Key key = Key(55).branch(i);
        Transform place = Transform::rotation(6 * key.uniform(0), 3 * key.uniform(1), 0);
        if (i % 4 == 0) place.matrix[0] *= -0.5;
        place.offset = 4.0 * random_point(key.branch(2), 1) + Vec3d(0, 0, 9);
        add(scene, i % 5 == 0 ? all_things[i / 5 % all_things.size()] : Thing::ball, Lambert{},
            place);
    }
    return scene;
}

}  // namespace

Tally items_against_rays(const Effort& effort) {
    Tally tally;
    const Scene scene = crowd();
    const auto accelerator = build_accelerator(scene, effort.isa);
    ItemBuffer buffer(scene, effort.isa);
    WorkCounts work;
    const Workers workers(1);
    constexpr Size size{48, 36};
    Sights all;
    for (std::uint64_t i = 0; i * size.area() < effort.of(1'000'000); ++i) {
        const Key key = Key(59).branch(i);
        const Camera camera = camera_at(random_point(key.branch(0), 1), 30 * key.uniform(1) - 15,
                                        30 * key.uniform(2) - 15, 40 + 40 * key.uniform(3));
        const Sights sights =
            compared(buffer, camera, size, Vec2d(0.5), workers,
                     [&](const Ray& ray) { return accelerator->closest(ray, work); });
        all += sights;
        tally.judge(sights.right(), [&] {
            return fmt::format("view {}: {} items, {} hits and {} depths are wrong", i,
                               sights.wrong_items, sights.wrong_hits, sights.wrong_depths);
        });
    }
    tally.rays = all.pixels;
    const bool telling = all.hits > all.pixels / 4 && all.ambiguous < all.hits / 2;
    if (!telling) {
        tally.judge(false, [&] {
            return fmt::format("{} pixels of {} show something, {} are ambiguous", all.hits,
                               all.pixels, all.ambiguous);
        });
    }
    return tally;
}

}  // namespace luch::stress
