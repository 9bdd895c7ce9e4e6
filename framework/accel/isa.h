#pragma once

#include <string_view>
#include <vector>

namespace luch {

/// The instructions that kernels may use: x86-64's levels, or none in particular.
enum class Isa { plain, v2, v3, v4 };

std::string_view to_string(Isa isa);

/// Those that this processor and this build can run, the best last; `plain` always comes first.
const std::vector<Isa>& usable_isas();

/// "v3" → Isa::v3, "" → the best. Throws Error, naming those that can be used here.
Isa parsed_isa(std::string_view text);

}  // namespace luch
