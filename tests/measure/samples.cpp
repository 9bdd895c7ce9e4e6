#include "tests/measure/samples.h"

namespace luch::testing {
namespace {

LabPoint point(double value, double ms, double rmse, std::uint64_t rays) {
    LabPoint point;
    point.value = value;
    point.frame_ms = ms;
    point.cpu_ms = 2 * ms;
    point.frames = 3;
    point.counts.of(RayKind::primary) = rays;
    point.errors.rmse = rmse;
    point.errors.differing = rmse > 0 ? 10 : 0;
    point.identical = rmse == 0;
    return point;
}

}  // namespace

LabReport sample_report(const std::string& name) {
    SceneReport scene;
    scene.scene = name;
    scene.size = {100, 50};
    scene.baseline = point(0, 40, 0, 5000);
    LabSeries swept{"quick",
                    "a quick one",
                    "lod",
                    "baseline, 1 sample a pixel",
                    {point(1, 5, 0.1, 1000), point(2, 10, 0.01, 2000), point(4, 20, 0, 2500)},
                    false};
    const Stage bump{
        .name = "bump", .needed = false, .kind = Stage::exact, .why = "no bump maps", .bound = 0};
    for (LabPoint& point : swept.points) point.plan.stages = {bump};
    LabSeries idle{"idle", "an idle one", "", "baseline, 1 sample a pixel", {{}}, false};
    idle.points[0].not_run = "does not apply: no lights, none";
    const LabSeries samples{"baseline",
                            "the classic ray tracer",
                            "spp",
                            "baseline, 64 samples a pixel, seed 1",
                            {point(1, 40, 0.05, 5000), point(4, 160, 0.02, 20000)},
                            true};
    scene.series = {swept, idle, samples};
    scene.truths.resize(2);
    scene.truths[0].name = swept.truth;
    scene.truths[0].exact = true;
    scene.truths[1].name = samples.truth;
    return {"luch lab x.scene", {}, {scene}};
}

std::size_t occurrences(const std::string& text, const std::string& piece) {
    std::size_t count = 0;
    for (std::size_t at = text.find(piece); at != std::string::npos;
         at = text.find(piece, at + piece.size())) {
        ++count;
    }
    return count;
}

}  // namespace luch::testing
