#pragma once

#include "framework/apps/arguments.h"

namespace luch {

// One file each: bench.cpp, check.cpp, compare.cpp, doctor.cpp, kit.cpp, lab.cpp, list.cpp,
// plan.cpp, render.cpp, stress.cpp, view.cpp.
std::unique_ptr<Verb> make_bench();
std::unique_ptr<Verb> make_check();
std::unique_ptr<Verb> make_compare();
std::unique_ptr<Verb> make_doctor();
std::unique_ptr<Verb> make_kit();
std::unique_ptr<Verb> make_lab();
std::unique_ptr<Verb> make_list();
std::unique_ptr<Verb> make_plan();
std::unique_ptr<Verb> make_render();
std::unique_ptr<Verb> make_stress();
std::unique_ptr<Verb> make_view();

}  // namespace luch
