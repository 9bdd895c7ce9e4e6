#include "techniques/ssao/ssao.h"

#include "framework/technique/catalogue.h"
#include "techniques/ssao/render.h"
#include "techniques/ssao/stress.h"

#include <array>

namespace luch::techniques::ssao {
namespace {

constexpr std::array<double, 6> sample_counts{4, 8, 18, 36, 72, 144};

}  // namespace

std::unique_ptr<Technique> make(const Steps& steps, const Params& params) {
    return technique_of(steps, params);
}

const std::span<const double> samples_to_walk{sample_counts};

TechniqueInfo describe() {
    return {.name = "ssao",
            .title = "ambient occlusion in screen space",
            .topic = "6. ambient light",
            .create = [] { return make(reference(), {}); },
            .sweep = {"samples", samples_to_walk},
            .approximates = false,
            .truth = "mode=rays",
            .stress_cases = stress_cases};
}

}  // namespace luch::techniques::ssao
