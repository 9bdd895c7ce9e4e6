#include "framework/accel/isa.h"

#include "framework/accel/wide/kernels.h"
#include "framework/base/error.h"

#include <string>

namespace luch {
namespace {

std::vector<Isa> found_isas() {
    std::vector<Isa> found{Isa::plain};
#if defined(LUCH_X86_64_LEVELS)
    // The parts of each level that the kernels' compiler may use (x86-64 psABI, table 3.1).
    __builtin_cpu_init();
    if (!__builtin_cpu_supports("sse4.2") || !__builtin_cpu_supports("popcnt")) return found;
    found.push_back(Isa::v2);
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma") ||
        !__builtin_cpu_supports("bmi2")) {
        return found;
    }
    found.push_back(Isa::v3);
    for (const bool has :
         {__builtin_cpu_supports("avx512f") != 0, __builtin_cpu_supports("avx512bw") != 0,
          __builtin_cpu_supports("avx512cd") != 0, __builtin_cpu_supports("avx512dq") != 0,
          __builtin_cpu_supports("avx512vl") != 0}) {
        if (!has) return found;
    }
    found.push_back(Isa::v4);
#endif
    return found;
}

}  // namespace

std::string_view to_string(Isa isa) {
    constexpr std::string_view names[] = {"plain", "v2", "v3", "v4"};
    return names[static_cast<int>(isa)];
}

const std::vector<Isa>& usable_isas() {
    static const std::vector<Isa> isas = found_isas();
    return isas;
}

Isa parsed_isa(std::string_view text) {
    if (text.empty()) return usable_isas().back();
    std::string names;
    for (const Isa isa : usable_isas()) {
        if (to_string(isa) == text) return isa;
        names += (names.empty() ? "" : ", ") + std::string(to_string(isa));
    }
    throw Error("--isa " + std::string(text) + ": this processor runs " + names);
}

const wide::Kernels& wide::kernels(Isa isa) {
#if defined(LUCH_X86_64_LEVELS)
    if (isa == Isa::v2) return kernels_v2();
    if (isa == Isa::v3) return kernels_v3();
    if (isa == Isa::v4) return kernels_v4();
#endif
    static_cast<void>(isa);
    return kernels_plain();
}

}  // namespace luch
