#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

// What simd.h needs of a register, in plain C++: for processors without the others, and so that
// the tests can hold the kernels against it.
namespace luch::simd {
namespace {

/// Four floats. A comparison gives a bit a lane.
struct Plain {
    static constexpr std::size_t size = 4;
    float lane[size];

    Plain() = default;
    explicit Plain(float all) : lane{all, all, all, all} {}
    static Plain load_aligned(const float* from) {
        Plain r;
        for (std::size_t i = 0; i < size; ++i) r.lane[i] = from[i];
        return r;
    }
    void store_aligned(float* to) const {
        for (std::size_t i = 0; i < size; ++i) to[i] = lane[i];
    }
    template <class F>
    static Plain each(const Plain& a, const Plain& b, F&& f) {
        Plain r;
        for (std::size_t i = 0; i < size; ++i) r.lane[i] = f(a.lane[i], b.lane[i]);
        return r;
    }
    template <class F>
    static unsigned mask(const Plain& a, const Plain& b, F&& f) {
        unsigned r = 0;
        for (std::size_t i = 0; i < size; ++i) r |= (f(a.lane[i], b.lane[i]) ? 1u : 0u) << i;
        return r;
    }
    friend Plain operator+(const Plain& a, const Plain& b) {
        return each(a, b, [](float x, float y) { return x + y; });
    }
    friend Plain operator-(const Plain& a, const Plain& b) {
        return each(a, b, [](float x, float y) { return x - y; });
    }
    friend Plain operator*(const Plain& a, const Plain& b) {
        return each(a, b, [](float x, float y) { return x * y; });
    }
    friend Plain operator/(const Plain& a, const Plain& b) {
        return each(a, b, [](float x, float y) { return x / y; });
    }
    friend Plain fms(const Plain& a, const Plain& b, const Plain& c) { return a * b - c; }
    friend Plain min(const Plain& a, const Plain& b) {
        return each(a, b, [](float x, float y) { return x < y ? x : y; });
    }
    friend Plain max(const Plain& a, const Plain& b) {
        return each(a, b, [](float x, float y) { return x > y ? x : y; });
    }
    friend Plain abs(const Plain& a) {
        return each(a, a, [](float x, float) { return std::abs(x); });
    }
    friend unsigned operator<(const Plain& a, const Plain& b) {
        return mask(a, b, [](float x, float y) { return x < y; });
    }
    friend unsigned operator<=(const Plain& a, const Plain& b) {
        return mask(a, b, [](float x, float y) { return x <= y; });
    }
};

inline unsigned bits(unsigned mask) {
    return mask;
}
template <class F>
unsigned judged(const Plain&, const std::uint32_t* all, std::uint32_t other, F&& f) {
    unsigned r = 0;
    for (std::size_t i = 0; i < Plain::size; ++i) r |= (f(all[i], other) ? 1u : 0u) << i;
    return r;
}
inline float largest_of(const Plain& a) {
    float most = a.lane[0];
    for (const float x : a.lane) most = x > most ? x : most;
    return most;
}
inline Plain pick(unsigned mask, const Plain& a, const Plain& b) {
    Plain r;
    for (std::size_t i = 0; i < Plain::size; ++i) {
        r.lane[i] = (mask >> i & 1) != 0 ? a.lane[i] : b.lane[i];
    }
    return r;
}

template <int N>
using Part = Plain;

}  // namespace
}  // namespace luch::simd
