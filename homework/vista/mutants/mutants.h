#pragma once

#include "homework/vista/check/others.h"

// Mistakes that students make, by task: each is the reference with one step spoilt.
namespace luch::homework::vista {

std::vector<grading::Other> shape_mutants();     ///< t1, t2
std::vector<grading::Other> triangle_mutants();  ///< t3, t4, t5
std::vector<grading::Other> raster_mutants();    ///< t6
std::vector<grading::Other> look_up_mutants();   ///< t7

}  // namespace luch::homework::vista
