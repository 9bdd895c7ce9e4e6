#include "framework/stress/made/everything.h"
#include "framework/stress/memory.h"
#include "framework/stress/subject.h"
#include "framework/stress/things.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>

namespace luch::stress {
namespace {

/// A turn of the camera has so many frames; then it is where it was, at the same moment.
constexpr int turn = 8;

Shot shot_of_frame(const Scene& scene, int spp, int frame) {
    constexpr double late_s = 1e9;  // some thirty years since the clock began
    Shot shot = shot_of(scene);
    shot.spp = spp;
    shot.camera.yaw_deg = 45.0 * (frame % turn);
    shot.frame = frame % turn;
    shot.time_s = late_s + (frame % turn) / 60.0;
    return shot;
}

StressResult looped(const Subject& subject, Scene scene, int frames) {
    scene.settings.frame = {16, 12};
    const OwnStudio studio(std::move(scene));
    const auto technique = subject.info->create();
    const auto frame = [&](int i) {
        return studio.render(*technique, shot_of_frame(studio.scene(), subject.spp(), i));
    };
    const Outcome first = frame(0);
    if (!first.plan.applies) return {StressVerdict::does_not_apply, first.plan.why};
    const int warm = std::min(frames / 2, 1000);
    std::uint64_t warm_bytes = 0;
    for (int i = 1; i <= frames; ++i) {
        const Outcome outcome = frame(i);
        if (i == warm) warm_bytes = resident_bytes();
        if (i % turn != 0) continue;
        if (outcome.frame.colour != first.frame.colour) {
            return judged(false, fmt::format("frame {} is not frame 0", i));
        }
    }
    const std::uint64_t now = resident_bytes();
    const std::uint64_t growth = now > warm_bytes ? now - warm_bytes : 0;
    const std::string got = fmt::format("{} frames, grown by {} kB", frames, growth >> 10);
    return finished(first, judged(growth <= most_growth, got));
}

}  // namespace

std::uint64_t resident_bytes() {
    std::ifstream statm("/proc/self/statm");
    std::uint64_t all = 0, resident = 0;
    if (!(statm >> all >> resident)) return 0;
    return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

void add_loop(CaseList& list) {
    const int frames = list.subject.full ? 1'000'000 : 2'000;
    list.add(20, "a camera that turns, clock at 1e9 s", "frame N as frame 0, ≤ 1 MB more",
             [subject = list.subject, frames] {
                 return looped(subject, one_thing(Thing::ball), frames);
             });
    list.add(20, "the same with a bit of everything", "frame N as frame 0, ≤ 1 MB more",
             [subject = list.subject, frames] {
                 return looped(subject, bit_of_everything(), frames / 20);
             });
}

}  // namespace luch::stress
