#pragma once

#include <cstddef>
#include <cstdint>

// The 50:50 mix of two pictures, (a + b) / 2, in several representations; see kernel.cpp.
namespace luch::mix {

template <class T>
struct Planes {
    const T *albedo, *lights[3], *highlights, *rest;
    T* to;
};

/// The mixes, compiled for one level of the processor. `n` counts values of the type given.
/// Pictures must not overlap. 8-bit channels are rounded up at half.
struct Kernels {
    void (*floats_alone)(const float* a, const float* b, float* to, std::size_t n);
    void (*floats)(const float* a, const float* b, float* to, std::size_t n);
    void (*bytes_alone)(const std::uint8_t* a, const std::uint8_t* b, std::uint8_t* to,
                        std::size_t n);
    void (*bytes)(const std::uint8_t* a, const std::uint8_t* b, std::uint8_t* to, std::size_t n);
    /// Four channels in an integer, and eight.
    void (*words_alone)(const std::uint32_t* a, const std::uint32_t* b, std::uint32_t* to,
                        std::size_t n);
    void (*longs_alone)(const std::uint64_t* a, const std::uint64_t* b, std::uint64_t* to,
                        std::size_t n);
    void (*words)(const std::uint32_t* a, const std::uint32_t* b, std::uint32_t* to, std::size_t n);

    /// a becomes the mean of both.
    void (*floats_in_place)(float* a, const float* b, std::size_t n);
    void (*bytes_in_place)(std::uint8_t* a, const std::uint8_t* b, std::size_t n);

    /// A frame put together from planes: albedo · (three lights) + highlights + all else; bytes
    /// with saturation and a rounded product.
    void (*float_planes)(const Planes<float>& planes, std::size_t n);
    void (*byte_planes)(const Planes<std::uint8_t>& planes, std::size_t n);
};

// Those compiled for x86-64-v2, -v3 and -v4 exist on that processor only.
const Kernels& kernels_plain();
const Kernels& kernels_v2();
const Kernels& kernels_v3();
const Kernels& kernels_v4();

}  // namespace luch::mix
