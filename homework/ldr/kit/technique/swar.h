#pragma once

#include "techniques/ldr/word.h"

// The students' kit: what a word can do is the homework. This is all that is given.
namespace luch::techniques::ldr {

/// Every channel times s/255, rounded to nearest, one after the other; 0 ≤ s ≤ 255.
LUCH_LDR_INLINE Word scaled(Word a, std::uint32_t s) {
    const auto part = [&](int i) { return (2 * a.channel(i) * s + 255) / 510; };
    return {part(3), part(2), part(1), part(0)};
}

}  // namespace luch::techniques::ldr
