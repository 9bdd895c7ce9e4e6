#pragma once

#include <string>

namespace luch::assets {

/// A number with at most that many decimals: no zeros at the end, no "-0", the same in every
/// locale.
std::string number(double value, int decimals);

}  // namespace luch::assets
