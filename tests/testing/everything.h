#pragma once

#include "framework/stress/made/everything.h"

namespace luch::testing {

using stress::add;
using stress::bit_of_everything;

}  // namespace luch::testing
