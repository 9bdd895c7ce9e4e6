#pragma once

#include "homework/shadow_map/check/others.h"

// Mistakes that students make, by task: each is the reference with one step spoilt.
namespace luch::homework::shadow_map {

std::vector<grading::Other> map_mutants();     ///< t1, t2, t3
std::vector<grading::Other> bias_mutants();    ///< t4
std::vector<grading::Other> shadow_mutants();  ///< t5, t6
std::vector<grading::Other> light_mutants();   ///< t7

}  // namespace luch::homework::shadow_map
