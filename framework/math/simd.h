#pragma once

// Thin lanes over xsimd, for kernel files only: they are compiled once for every level of x86-64
// (see luch_kernels in framework/cmake/kernels.cmake), with LUCH_PLAIN_LANES in plain C++.
#if defined(LUCH_PLAIN_LANES)
#include "framework/math/simd_plain.h"
#else
#include <xsimd/xsimd.hpp>
#endif

#include <cstdint>
#include <cstring>

#define LUCH_INLINE [[gnu::always_inline]] inline

// Kernel files of different levels see this header with different instructions behind the same
// names, so nothing here may have linkage.
namespace luch::simd {
namespace {

#if !defined(LUCH_PLAIN_LANES)
using Sse = xsimd::batch<float, xsimd::sse4_2>;
LUCH_INLINE unsigned bits(Sse::batch_bool_type m) {
    return static_cast<unsigned>(_mm_movemask_ps(m.data));
}
/// A bit for each of the numbers that is `f` to another.
template <class F>
LUCH_INLINE unsigned judged(Sse, const std::uint32_t* all, std::uint32_t other, F&& f) {
    using Whole = xsimd::batch<std::uint32_t, xsimd::sse4_2>;
    const auto yes = f(Whole::load_unaligned(all), Whole(other));
    return static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(yes.data)));
}
/// a where a lane's bit is set, else b.
LUCH_INLINE Sse pick(unsigned bits, Sse a, Sse b) {
    const __m128i lane = _mm_setr_epi32(1, 2, 4, 8);
    const __m128i set = _mm_and_si128(_mm_set1_epi32(static_cast<int>(bits)), lane);
    return _mm_blendv_ps(b, a, _mm_castsi128_ps(_mm_cmpeq_epi32(set, lane)));
}
LUCH_INLINE float largest_of(Sse a) {
    const __m128 two = _mm_max_ps(a, _mm_movehl_ps(a, a));
    return _mm_cvtss_f32(_mm_max_ss(two, _mm_shuffle_ps(two, two, 1)));
}
#if defined(__AVX2__)
using Avx = xsimd::batch<float, xsimd::fma3<xsimd::avx2>>;
LUCH_INLINE unsigned bits(Avx::batch_bool_type m) {
    return static_cast<unsigned>(_mm256_movemask_ps(m.data));
}
template <class F>
LUCH_INLINE unsigned judged(Avx, const std::uint32_t* all, std::uint32_t other, F&& f) {
    using Whole = xsimd::batch<std::uint32_t, xsimd::fma3<xsimd::avx2>>;
    const auto yes = f(Whole::load_unaligned(all), Whole(other));
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(yes.data)));
}
LUCH_INLINE Avx pick(unsigned bits, Avx a, Avx b) {
    const __m256i lane = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
    const __m256i set = _mm256_and_si256(_mm256_set1_epi32(static_cast<int>(bits)), lane);
    return _mm256_blendv_ps(b, a, _mm256_castsi256_ps(_mm256_cmpeq_epi32(set, lane)));
}
LUCH_INLINE float largest_of(Avx a) {
    return largest_of(Sse(_mm_max_ps(_mm256_castps256_ps128(a), _mm256_extractf128_ps(a, 1))));
}
#else
using Avx = Sse;
#endif
#if defined(__AVX512F__)
using Avx512 = xsimd::batch<float, xsimd::avx512f>;
LUCH_INLINE unsigned bits(Avx512::batch_bool_type m) {
    return m.data;
}
template <class F>
LUCH_INLINE unsigned judged(Avx512, const std::uint32_t* all, std::uint32_t other, F&& f) {
    using Whole = xsimd::batch<std::uint32_t, xsimd::avx512f>;
    return f(Whole::load_unaligned(all), Whole(other)).data;
}
LUCH_INLINE Avx512 pick(unsigned bits, Avx512 a, Avx512 b) {
    return _mm512_mask_blend_ps(static_cast<__mmask16>(bits), b, a);
}
LUCH_INLINE float largest_of(Avx512 a) {
    return _mm512_reduce_max_ps(a);
}
#else
using Avx512 = Avx;
#endif
template <int N>
using Part = std::conditional_t<(N >= 16), Avx512, std::conditional_t<(N >= 8), Avx, Sse>>;
#endif

/// N floats, in as many registers as that takes.
template <int N>
struct Lanes {
    using P = Part<N>;
    static constexpr int width = static_cast<int>(P::size), parts = N / width;
    P part[parts];

    Lanes() = default;
    LUCH_INLINE Lanes(float all) {
        for (P& p : part) p = P(all);
    }
    /// `from` and `to` are aligned to N floats.
    LUCH_INLINE static Lanes load(const float* from) {
        Lanes r;
        for (int i = 0; i < parts; ++i) r.part[i] = P::load_aligned(from + i * width);
        return r;
    }
    LUCH_INLINE void store(float* to) const {
        for (int i = 0; i < parts; ++i) part[i].store_aligned(to + i * width);
    }
    /// The bits of whole numbers, which no operation but select() may be asked to work on.
    LUCH_INLINE static Lanes load_bits(const std::uint32_t* from) {
        Lanes r;
        std::memcpy(r.part, from, sizeof r.part);
        return r;
    }
    LUCH_INLINE void store_bits(std::uint32_t* to) const { std::memcpy(to, part, sizeof part); }
    template <class F>
    LUCH_INLINE static Lanes zip(const Lanes& a, const Lanes& b, F&& f) {
        Lanes r;
        for (int i = 0; i < parts; ++i) r.part[i] = f(a.part[i], b.part[i]);
        return r;
    }
    LUCH_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) {
        return zip(a, b, [](const P& x, const P& y) { return x + y; });
    }
    LUCH_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) {
        return zip(a, b, [](const P& x, const P& y) { return x - y; });
    }
    LUCH_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) {
        return zip(a, b, [](const P& x, const P& y) { return x * y; });
    }
    LUCH_INLINE friend Lanes operator/(const Lanes& a, const Lanes& b) {
        return zip(a, b, [](const P& x, const P& y) { return x / y; });
    }
    /// a · b − c, rounded once where there is an instruction for that, else twice: for filters with
    /// room for either.
    LUCH_INLINE friend Lanes times_minus(const Lanes& a, const Lanes& b, const Lanes& c) {
        Lanes r;
        for (int i = 0; i < parts; ++i) r.part[i] = fms(a.part[i], b.part[i], c.part[i]);
        return r;
    }
    /// a < b ? a : b, so b where either is a NaN.
    LUCH_INLINE friend Lanes min_or(const Lanes& a, const Lanes& b) {
        return zip(a, b, [](const P& x, const P& y) { return min(x, y); });
    }
    /// a > b ? a : b, so b where either is a NaN.
    LUCH_INLINE friend Lanes max_or(const Lanes& a, const Lanes& b) {
        return zip(a, b, [](const P& x, const P& y) { return max(x, y); });
    }
    /// The largest lane; none may be a NaN.
    LUCH_INLINE friend float largest_lane(const Lanes& a) {
        P most = a.part[0];
        for (int i = 1; i < parts; ++i) most = max(a.part[i], most);
        return largest_of(most);
    }
    LUCH_INLINE friend Lanes abs(const Lanes& a) {
        return zip(a, a, [](const P& x, const P&) { return abs(x); });
    }

    /// Comparisons give one bit a lane, lane 0 lowest.
    template <class F>
    LUCH_INLINE static unsigned compare(const Lanes& a, const Lanes& b, F&& f) {
        unsigned r = 0;
        for (int i = 0; i < parts; ++i) r |= bits(f(a.part[i], b.part[i])) << (i * width);
        return r;
    }
    LUCH_INLINE friend unsigned operator<(const Lanes& a, const Lanes& b) {
        return compare(a, b, [](const P& x, const P& y) { return x < y; });
    }
    LUCH_INLINE friend unsigned operator<=(const Lanes& a, const Lanes& b) {
        return compare(a, b, [](const P& x, const P& y) { return x <= y; });
    }
    /// The same of N whole numbers, wherever they are, with another.
    LUCH_INLINE static unsigned equal(const std::uint32_t* all, std::uint32_t other) {
        return judge(all, other, [](const auto& x, const auto& y) { return x == y; });
    }
    LUCH_INLINE static unsigned below(const std::uint32_t* all, std::uint32_t other) {
        return judge(all, other, [](const auto& x, const auto& y) { return x < y; });
    }
    template <class F>
    LUCH_INLINE static unsigned judge(const std::uint32_t* all, std::uint32_t other, F&& f) {
        unsigned r = 0;
        for (int i = 0; i < parts; ++i) r |= judged(P(), all + i * width, other, f) << (i * width);
        return r;
    }
    LUCH_INLINE friend unsigned operator>(const Lanes& a, const Lanes& b) { return b < a; }

    /// a in the lanes whose bit is set, else b.
    LUCH_INLINE static Lanes select(unsigned mask, const Lanes& a, const Lanes& b) {
        Lanes r;
        for (int i = 0; i < parts; ++i) {
            r.part[i] = pick(mask >> (i * width), a.part[i], b.part[i]);
        }
        return r;
    }
};

}  // namespace
}  // namespace luch::simd
