#pragma once

#include "techniques/ssao/ssao.h"

namespace luch::techniques::ssao {

/// What make() makes: looks, runs the passes, and has the baseline shade with what they found.
std::unique_ptr<Technique> technique_of(const Steps& steps, const Params& params);

}  // namespace luch::techniques::ssao
