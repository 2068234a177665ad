// The vector instructions that the step is written in: one double, two (SSE2), four (AVX2) or eight (AVX-512)
// at a time. Every operation rounds as IEEE 754 says, so all give the same bits.
//
// A kernel that is compiled for one instruction set must call nothing that is compiled for all: an inline
// function of the standard library that used AVX2 could be the one that the linker keeps for everyone. Hence
// no <cmath>.
#pragma once

#include <cstdint>
#include <cstring>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace clothlab {
namespace { // a copy for each file, see above

struct ScalarLanes {
    static constexpr int kCount = 1;
    using Vector = double;
    using Mask = bool;
    static Vector load(const double* from) { return *from; }
    static void store(double* to, Vector v) { *to = v; }
    static Vector all(double value) { return value; }
    static Vector squareRoot(Vector v) { return __builtin_sqrt(v); }
    static Mask less(Vector a, Vector b) { return a < b; }
    static Mask both(Mask a, Mask b) { return a && b; }
    static Mask butNot(Mask a, Mask b) { return a && !b; } // a and not b
    static Mask either(Mask a, Mask b) { return a || b; }
    static Vector choose(Mask mask, Vector yes, Vector no) { return mask ? yes : no; }
    static Vector orZero(Mask mask, Vector v) { return mask ? v : 0; }
    static Mask fromBytes(const std::uint8_t* bytes) { return *bytes != 0; } // 1 or 0 a lane
    static unsigned bits(Mask mask) { return mask ? 1 : 0; }                 // lane n is bit n
};

#if defined(__x86_64__)

struct Sse2Lanes {
    static constexpr int kCount = 2;
    using Vector = __m128d;
    using Mask = __m128d;
    static Vector load(const double* from) { return _mm_loadu_pd(from); }
    static void store(double* to, Vector v) { _mm_storeu_pd(to, v); }
    static Vector all(double value) { return _mm_set1_pd(value); }
    static Vector squareRoot(Vector v) { return _mm_sqrt_pd(v); }
    static Mask less(Vector a, Vector b) { return _mm_cmplt_pd(a, b); }
    static Mask both(Mask a, Mask b) { return _mm_and_pd(a, b); }
    static Mask butNot(Mask a, Mask b) { return _mm_andnot_pd(b, a); }
    static Mask either(Mask a, Mask b) { return _mm_or_pd(a, b); }
    static Vector choose(Mask mask, Vector yes, Vector no) {
        return _mm_or_pd(_mm_and_pd(mask, yes), _mm_andnot_pd(mask, no));
    }
    static Vector orZero(Mask mask, Vector v) { return _mm_and_pd(mask, v); }
    static Mask fromBytes(const std::uint8_t* bytes) {
        return _mm_castsi128_pd(_mm_set_epi64x(-std::int64_t(bytes[1]), -std::int64_t(bytes[0])));
    }
    static unsigned bits(Mask mask) { return unsigned(_mm_movemask_pd(mask)); }
};

#endif

#if defined(__AVX2__)

struct Avx2Lanes {
    static constexpr int kCount = 4;
    using Vector = __m256d;
    using Mask = __m256d;
    static Vector load(const double* from) { return _mm256_loadu_pd(from); }
    static void store(double* to, Vector v) { _mm256_storeu_pd(to, v); }
    static Vector all(double value) { return _mm256_set1_pd(value); }
    static Vector squareRoot(Vector v) { return _mm256_sqrt_pd(v); }
    static Mask less(Vector a, Vector b) { return _mm256_cmp_pd(a, b, _CMP_LT_OQ); }
    static Mask both(Mask a, Mask b) { return _mm256_and_pd(a, b); }
    static Mask butNot(Mask a, Mask b) { return _mm256_andnot_pd(b, a); }
    static Mask either(Mask a, Mask b) { return _mm256_or_pd(a, b); }
    static Vector choose(Mask mask, Vector yes, Vector no) { return _mm256_blendv_pd(no, yes, mask); }
    static Vector orZero(Mask mask, Vector v) { return _mm256_and_pd(mask, v); }
    static Mask fromBytes(const std::uint8_t* bytes) {
        std::int32_t four = 0;
        std::memcpy(&four, bytes, sizeof four);
        const __m256i wide = _mm256_cvtepu8_epi64(_mm_cvtsi32_si128(four));
        return _mm256_castsi256_pd(_mm256_cmpgt_epi64(wide, _mm256_setzero_si256()));
    }
    static unsigned bits(Mask mask) { return unsigned(_mm256_movemask_pd(mask)); }
};

#endif

#if defined(__AVX512F__)

struct Avx512Lanes {
    static constexpr int kCount = 8;
    using Vector = __m512d;
    using Mask = __mmask8;
    static Vector load(const double* from) { return _mm512_loadu_pd(from); }
    static void store(double* to, Vector v) { _mm512_storeu_pd(to, v); }
    static Vector all(double value) { return _mm512_set1_pd(value); }
    static Vector squareRoot(Vector v) { return _mm512_sqrt_pd(v); }
    static Mask less(Vector a, Vector b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
    static Mask both(Mask a, Mask b) { return Mask(a & b); }
    static Mask butNot(Mask a, Mask b) { return Mask(a & ~b); }
    static Mask either(Mask a, Mask b) { return Mask(a | b); }
    static Vector choose(Mask mask, Vector yes, Vector no) { return _mm512_mask_blend_pd(mask, no, yes); }
    static Vector orZero(Mask mask, Vector v) { return _mm512_maskz_mov_pd(mask, v); }
    static Mask fromBytes(const std::uint8_t* bytes) {
        std::int64_t eight = 0;
        std::memcpy(&eight, bytes, sizeof eight);
        const __m512i wide = _mm512_maskz_cvtepu8_epi64(0xff, _mm_cvtsi64_si128(eight));
        return _mm512_test_epi64_mask(wide, wide);
    }
    static unsigned bits(Mask mask) { return mask; }
};

#endif

} // namespace
} // namespace clothlab
