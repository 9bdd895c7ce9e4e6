#pragma once

#include "techniques/ldr/ldr.h"

// The operations over many words that hold no table and no power, compiled for every level of the
// processor (see luch_kernels()): plain loops, of which the compiler makes vector instructions.
namespace luch::techniques::ldr {

struct Spans {
    void (*add)(Word* a, const Word* b, std::size_t n);
    void (*modulate)(Word* a, const Word* b, std::size_t n);
    void (*mix)(Word* a, const Word* b, const std::uint8_t* up, std::size_t n);
    void (*lerp)(Word* a, const Word* b, const std::uint8_t* alpha, std::size_t n);
    void (*accumulate)(const Word* words, Wide* sums, std::size_t n);
    /// `linear`: what each of 256 levels is worth, 0…65535.
    void (*tint)(Wide* sums, const Word* albedo, const std::uint32_t* linear, std::size_t n);
};

// Those compiled for x86-64-v2, -v3 and -v4 exist on that processor only.
const Spans& spans_plain();
const Spans& spans_v2();
const Spans& spans_v3();
const Spans& spans_v4();

}  // namespace luch::techniques::ldr
