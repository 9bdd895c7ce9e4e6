#pragma once

#include "homework/ssao/check/others.h"

namespace luch::homework::ssao {

std::vector<grading::Other> occlusion_mutants();  ///< of t4
std::vector<grading::Other> smoothing_mutants();  ///< of t5 to t7

}  // namespace luch::homework::ssao
