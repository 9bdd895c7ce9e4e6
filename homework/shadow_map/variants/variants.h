#pragma once

#include "homework/shadow_map/check/others.h"

// Honest solutions: each is the reference with one step done otherwise.
namespace luch::homework::shadow_map {

std::vector<grading::Other> map_variants();     ///< t1, t2, t3, t4
std::vector<grading::Other> shadow_variants();  ///< t5, t6, t7

}  // namespace luch::homework::shadow_map
