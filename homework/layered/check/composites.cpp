// Task t5: layers over one another.
#include "framework/grading/gates.h"
#include "homework/layered/check/same.h"
#include "homework/layered/check/tests.h"

#include <limits>

namespace luch::homework::layered {
namespace {

using grading::Finding;

Image<Rgba> over(const Steps& steps, const Image<Rgba>& front, Image<Rgba> back) {
    steps.over(front.view(), front.view().tile(), back.view());
    return back;
}

Finding composed(const Steps& steps, const Sample& sample) {
    return same_layers(over(steps, sample.spread, sample.far), sample.composed);
}

/// Both ways of putting brackets give the same: only so may layers be put together one by one.
Finding in_any_brackets(const Steps& steps, const Sample& sample) {
    const Image<Rgba> first = over(steps, over(steps, sample.spread, sample.along_x), sample.near);
    const Image<Rgba> last = over(steps, sample.spread, over(steps, sample.along_x, sample.near));
    Finding same = same_layers(first, last);
    if (!same.passed) return same;
    // Coverage is never lost, and full coverage hides all.
    const Image<Rgba> full(sample.far.size(), Rgba(0.5f, 0.25f, 1, 1));
    const Image<Rgba> dazzling(sample.far.size(), Rgba(std::numeric_limits<float>::infinity()));
    return grading::first_failure_of({same_layers(over(steps, full, sample.far), full),
                                      same_layers(over(steps, full, dazzling), full)});
}

/// Nothing in front changes nothing; light without coverage is added.
Finding empty_layers(const Steps& steps, const Sample& sample) {
    const Image<Rgba> nothing(sample.far.size(), Rgba(0)),
        light(sample.far.size(), Rgba(0.5f, 0.25f, 0, 0));
    Image<Rgba> lit = sample.composed;
    for (Rgba& pixel : lit.pixels()) pixel += Rgba(0.5f, 0.25f, 0, 0);
    return grading::first_failure_of(
        {same_layers(over(steps, nothing, sample.composed), sample.composed),
         same_layers(over(steps, sample.spread, nothing), sample.spread),
         same_layers(over(steps, light, sample.composed), lit)});
}

}  // namespace

grading::Task over_task(const Samples& samples) {
    return {"layered.t5",
            "over: premultiplied",
            {{"layered.t5.composed", 2, cases_of(samples, composed)},
             {"layered.t5.in_any_brackets", 1, cases_of(samples, in_any_brackets)},
             {"layered.t5.empty_layers", 1, cases_of(samples, empty_layers)}}};
}

}  // namespace luch::homework::layered
