#pragma once

#include <cstdint>

#include "impulse/real.h"

#ifdef __SSE2__
#include <immintrin.h>
#endif

/// The only place that knows instruction sets.
///
/// Every file in kernels/ is compiled for what all processors of the target have (`baseline`) and, on x86-64, once more
/// with AVX2 (`avx2`); the namespace IMPULSE_LANES keeps the two apart. Which one runs is asked once, see kernels.h. No
/// kernel may call an inline function from outside this namespace: a linker that keeps one copy might keep the AVX2
/// one.
///
/// Lanes are always eight, in as many registers as that takes, and each lane computes what a Real would: no fused
/// multiply-add, no approximation, no sum across lanes. So results never depend on the instruction set.
#ifndef IMPULSE_LANES
#define IMPULSE_LANES baseline
#endif

namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

/// One number at a time, for processors that have no registers below; the oracle of those that are there.
struct ScalarRegister {
  static constexpr std::uint32_t width = 1;
  struct Mask {
    bool m;
  };
  Real v;

  static ScalarRegister load(const Real* from) { return {*from}; }
  static ScalarRegister all(Real value) { return {value}; }
  static Mask at_most(ScalarRegister a, ScalarRegister b) { return {a.v <= b.v}; }
  static Mask both(Mask a, Mask b) { return {a.m && b.m}; }
  static std::uint32_t bits(Mask mask) { return mask.m ? 1 : 0; }
};

#if defined(__AVX2__) && defined(IMPULSE_DOUBLE)

struct Register {
  static constexpr std::uint32_t width = 4;
  struct Mask {
    __m256d m;
  };
  __m256d v;

  static Register load(const Real* from) { return {_mm256_loadu_pd(from)}; }
  static Register all(Real value) { return {_mm256_set1_pd(value)}; }
  static Mask at_most(Register a, Register b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_LE_OQ)}; }
  static Mask both(Mask a, Mask b) { return {_mm256_and_pd(a.m, b.m)}; }
  static std::uint32_t bits(Mask mask) { return static_cast<std::uint32_t>(_mm256_movemask_pd(mask.m)); }
};

#elif defined(__AVX2__)

struct Register {
  static constexpr std::uint32_t width = 8;
  struct Mask {
    __m256 m;
  };
  __m256 v;

  static Register load(const Real* from) { return {_mm256_loadu_ps(from)}; }
  static Register all(Real value) { return {_mm256_set1_ps(value)}; }
  static Mask at_most(Register a, Register b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)}; }
  static Mask both(Mask a, Mask b) { return {_mm256_and_ps(a.m, b.m)}; }
  static std::uint32_t bits(Mask mask) { return static_cast<std::uint32_t>(_mm256_movemask_ps(mask.m)); }
};

#elif defined(__SSE2__) && defined(IMPULSE_DOUBLE)

struct Register {
  static constexpr std::uint32_t width = 2;
  struct Mask {
    __m128d m;
  };
  __m128d v;

  static Register load(const Real* from) { return {_mm_loadu_pd(from)}; }
  static Register all(Real value) { return {_mm_set1_pd(value)}; }
  static Mask at_most(Register a, Register b) { return {_mm_cmple_pd(a.v, b.v)}; }
  static Mask both(Mask a, Mask b) { return {_mm_and_pd(a.m, b.m)}; }
  static std::uint32_t bits(Mask mask) { return static_cast<std::uint32_t>(_mm_movemask_pd(mask.m)); }
};

#elif defined(__SSE2__)

struct Register {
  static constexpr std::uint32_t width = 4;
  struct Mask {
    __m128 m;
  };
  __m128 v;

  static Register load(const Real* from) { return {_mm_loadu_ps(from)}; }
  static Register all(Real value) { return {_mm_set1_ps(value)}; }
  static Mask at_most(Register a, Register b) { return {_mm_cmple_ps(a.v, b.v)}; }
  static Mask both(Mask a, Mask b) { return {_mm_and_ps(a.m, b.m)}; }
  static std::uint32_t bits(Mask mask) { return static_cast<std::uint32_t>(_mm_movemask_ps(mask.m)); }
};

#else

using Register = ScalarRegister;

#endif

constexpr std::uint32_t lane_count = 8;

/// Eight yes or no.
template <class R>
struct MaskOf {
  typename R::Mask part[lane_count / R::width];

  friend MaskOf operator&(const MaskOf& a, const MaskOf& b) {
    MaskOf result;
    for (std::uint32_t i = 0; i < lane_count / R::width; ++i) result.part[i] = R::both(a.part[i], b.part[i]);
    return result;
  }
  /// Bit i tells of lane i.
  std::uint32_t bits() const {
    std::uint32_t all = 0;
    for (std::uint32_t i = 0; i < lane_count / R::width; ++i) all |= R::bits(part[i]) << (i * R::width);
    return all;
  }
};

/// Eight numbers.
template <class R>
struct LanesOf {
  R part[lane_count / R::width];

  static LanesOf load(const Real* from) {
    LanesOf result;
    for (std::uint32_t i = 0; i < lane_count / R::width; ++i) result.part[i] = R::load(from + i * R::width);
    return result;
  }
  static LanesOf all(Real value) {
    LanesOf result;
    for (R& one : result.part) one = R::all(value);
    return result;
  }
  /// No where either is not a number.
  friend MaskOf<R> operator<=(const LanesOf& a, const LanesOf& b) {
    MaskOf<R> result;
    for (std::uint32_t i = 0; i < lane_count / R::width; ++i) result.part[i] = R::at_most(a.part[i], b.part[i]);
    return result;
  }
};

using Lanes = LanesOf<Register>;

/// Of every set of lanes its members in order, then zeros, and how many they are.
struct SetOfLanes {
  std::uint8_t members[lane_count];
  std::uint8_t count;
};
struct SetsOfLanes {
  SetOfLanes of[1U << lane_count];
};
constexpr SetsOfLanes list_sets() {
  SetsOfLanes sets{};
  for (std::uint32_t bits = 0; bits < 1U << lane_count; ++bits) {
    for (std::uint8_t lane = 0; lane < lane_count; ++lane) {
      if ((bits >> lane & 1U) != 0) sets.of[bits].members[sets.of[bits].count++] = lane;
    }
  }
  return sets;
}
inline constexpr SetsOfLanes sets_of_lanes = list_sets();

/// Writes base + i for every lane i in the set and returns the end of what counts; there must be room for all eight.
inline std::uint32_t* write_members(std::uint32_t bits, std::uint32_t base, std::uint32_t* to) {
  const SetOfLanes& set = sets_of_lanes.of[bits];
#ifdef __SSE2__
  const __m128i lanes = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(set.members));
#ifdef __AVX2__
  const __m256i all = _mm256_add_epi32(_mm256_cvtepu8_epi32(lanes), _mm256_set1_epi32(static_cast<int>(base)));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), all);
#else
  const __m128i first = _mm_set1_epi32(static_cast<int>(base));
  const __m128i wide = _mm_unpacklo_epi8(lanes, _mm_setzero_si128());
  _mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm_add_epi32(first, _mm_unpacklo_epi16(wide, _mm_setzero_si128())));
  _mm_storeu_si128(reinterpret_cast<__m128i*>(to + 4),
                   _mm_add_epi32(first, _mm_unpackhi_epi16(wide, _mm_setzero_si128())));
#endif
#else
  for (std::uint32_t i = 0; i < lane_count; ++i) to[i] = base + set.members[i];
#endif
  return to + set.count;
}

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
