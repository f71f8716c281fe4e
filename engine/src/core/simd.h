#pragma once

#include <cstdint>
#include <cstring>

#include "impulse/real.h"

#ifdef __SSE2__
#include <immintrin.h>
#endif

/// The only place that knows instruction sets.
///
/// Every file in a folder lanes/ is compiled for what all processors of the target have (`baseline`), once more with
/// one number at a time (`scalar`, the oracle) and, on x86-64, with AVX2 (`avx2`) and with AVX-512 (`avx512`); the
/// namespace IMPULSE_LANES keeps them apart. Which one runs is asked once, see instruction_set.h. No kernel may call an
/// inline function from outside this namespace: a linker that keeps one copy might keep the AVX-512 one.
///
/// Lanes are eight, in as many registers as that takes, or sixteen where one register holds so many, and each lane
/// computes what a Real would: no approximation, no sum across lanes. So results never depend on the instruction set.
#ifndef IMPULSE_LANES
#define IMPULSE_LANES baseline
#endif

namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

/// One number at a time, for processors that have no registers below; the oracle of those that are there.
struct ScalarRegister {
  static constexpr std::uint32_t width = 1;
  struct Mask {
    bool m;
    friend Mask operator&(Mask a, Mask b) { return {a.m && b.m}; }
    friend Mask operator|(Mask a, Mask b) { return {a.m || b.m}; }
    friend Mask operator!(Mask a) { return {!a.m}; }
  };
  Real v;

  static ScalarRegister load(const Real* from) { return {*from}; }
  static ScalarRegister all(Real value) { return {value}; }
  void store(Real* to) const { *to = v; }
  friend ScalarRegister operator+(ScalarRegister a, ScalarRegister b) { return {a.v + b.v}; }
  friend ScalarRegister operator-(ScalarRegister a, ScalarRegister b) { return {a.v - b.v}; }
  friend ScalarRegister operator*(ScalarRegister a, ScalarRegister b) { return {a.v * b.v}; }
  friend ScalarRegister operator/(ScalarRegister a, ScalarRegister b) { return {a.v / b.v}; }
  friend ScalarRegister operator-(ScalarRegister a) { return {-a.v}; }
  friend Mask operator<(ScalarRegister a, ScalarRegister b) { return {a.v < b.v}; }
  friend Mask operator<=(ScalarRegister a, ScalarRegister b) { return {a.v <= b.v}; }
  friend Mask operator==(ScalarRegister a, ScalarRegister b) { return {a.v == b.v}; }
  static ScalarRegister select(Mask mask, ScalarRegister yes, ScalarRegister no) { return mask.m ? yes : no; }
  static ScalarRegister root(ScalarRegister a) { return {static_cast<Real>(__builtin_sqrt(a.v))}; }
  static ScalarRegister magnitude(ScalarRegister a) { return {static_cast<Real>(__builtin_fabs(a.v))}; }
  static std::uint32_t bits(Mask mask) { return mask.m ? 1 : 0; }
  static Mask of(std::uint32_t bits) { return {(bits & 1U) != 0}; }
  static void transpose(const auto& rows, std::uint32_t at, ScalarRegister columns[4]) {
    for (std::uint32_t column = 0; column < 4; ++column) columns[column].v = rows[at][column];
  }
  static void transpose_back(const ScalarRegister columns[4], const auto& rows, std::uint32_t at) {
    for (std::uint32_t column = 0; column < 4; ++column) rows[at][column] = columns[column].v;
  }
};

#if defined(__SSE2__) && !defined(IMPULSE_LANES_scalar)

/// As many numbers as one register of the processor holds.
struct Register {
#ifdef __AVX512F__
  static constexpr std::uint32_t bytes = 64;
#elif defined(__AVX2__)
  static constexpr std::uint32_t bytes = 32;
#else
  static constexpr std::uint32_t bytes = 16;
#endif
  static constexpr std::uint32_t width = bytes / sizeof(Real);
  typedef Real Vector __attribute__((vector_size(bytes)));
  using Bits = decltype(Vector{} < Vector{});
#ifdef __AVX512F__
  struct Mask {
    std::uint16_t m;
    friend Mask operator&(Mask a, Mask b) { return {static_cast<std::uint16_t>(a.m & b.m)}; }
    friend Mask operator|(Mask a, Mask b) { return {static_cast<std::uint16_t>(a.m | b.m)}; }
    friend Mask operator!(Mask a) { return {static_cast<std::uint16_t>(~a.m & ((1U << width) - 1))}; }
  };
#else
  struct Mask {
    Bits m;
    friend Mask operator&(Mask a, Mask b) { return {a.m & b.m}; }
    friend Mask operator|(Mask a, Mask b) { return {a.m | b.m}; }
    friend Mask operator!(Mask a) { return {~a.m}; }
  };
#endif
  Vector v;

  static Register load(const Real* from) {
    Register result;
    std::memcpy(&result.v, from, bytes);
    return result;
  }
  static Register all(Real value) { return {value - Vector{}}; }
  void store(Real* to) const { std::memcpy(to, &v, bytes); }
  friend Register operator+(Register a, Register b) { return {a.v + b.v}; }
  friend Register operator-(Register a, Register b) { return {a.v - b.v}; }
  friend Register operator*(Register a, Register b) { return {a.v * b.v}; }
  friend Register operator/(Register a, Register b) { return {a.v / b.v}; }
  friend Register operator-(Register a) { return {-a.v}; }
  static Register magnitude(Register a) {
    return {reinterpret_cast<Vector>(reinterpret_cast<Bits>(a.v) & ~reinterpret_cast<Bits>(all(-Real{0}).v))};
  }
#if defined(__AVX512F__) && defined(IMPULSE_DOUBLE)
  friend Mask operator<(Register a, Register b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LT_OS)}; }
  friend Mask operator<=(Register a, Register b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LE_OS)}; }
  friend Mask operator==(Register a, Register b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_EQ_OQ)}; }
  static Register select(Mask mask, Register yes, Register no) {
    return {_mm512_mask_blend_pd(static_cast<__mmask8>(mask.m), no.v, yes.v)};
  }
#elif defined(__AVX512F__)
  friend Mask operator<(Register a, Register b) { return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_LT_OS)}; }
  friend Mask operator<=(Register a, Register b) { return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_LE_OS)}; }
  friend Mask operator==(Register a, Register b) { return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_EQ_OQ)}; }
  static Register select(Mask mask, Register yes, Register no) { return {_mm512_mask_blend_ps(mask.m, no.v, yes.v)}; }
#else
  friend Mask operator<(Register a, Register b) { return {a.v < b.v}; }
  friend Mask operator<=(Register a, Register b) { return {a.v <= b.v}; }
  friend Mask operator==(Register a, Register b) { return {a.v == b.v}; }
  static Register select(Mask mask, Register yes, Register no) { return {mask.m ? yes.v : no.v}; }
#endif
#ifdef __AVX512F__
  static std::uint32_t bits(Mask mask) { return mask.m; }
  static Mask of(std::uint32_t bits) { return {static_cast<std::uint16_t>(bits & ((1U << width) - 1))}; }
#else
  static Mask of(std::uint32_t bits) {
    Bits lane{};
    for (std::uint32_t i = 0; i < width; ++i) lane[i] = 1 << i;
    return {((Bits{} + static_cast<int>(bits)) & lane) == lane};
  }
#endif
#if defined(__AVX512F__) && defined(IMPULSE_DOUBLE)
  static Register root(Register a) { return {_mm512_maskz_sqrt_pd(0xff, a.v)}; }
#elif defined(__AVX512F__)
  static Register root(Register a) { return {_mm512_maskz_sqrt_ps(0xffff, a.v)}; }
#elif defined(__AVX2__) && defined(IMPULSE_DOUBLE)
  static Register root(Register a) { return {_mm256_sqrt_pd(a.v)}; }
  static std::uint32_t bits(Mask mask) {
    return static_cast<std::uint32_t>(_mm256_movemask_pd(reinterpret_cast<__m256d>(mask.m)));
  }
#elif defined(__AVX2__)
  static Register root(Register a) { return {_mm256_sqrt_ps(a.v)}; }
  static std::uint32_t bits(Mask mask) {
    return static_cast<std::uint32_t>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask.m)));
  }
#elif defined(IMPULSE_DOUBLE)
  static Register root(Register a) { return {_mm_sqrt_pd(a.v)}; }
  static std::uint32_t bits(Mask mask) {
    return static_cast<std::uint32_t>(_mm_movemask_pd(reinterpret_cast<__m128d>(mask.m)));
  }
#else
  static Register root(Register a) { return {_mm_sqrt_ps(a.v)}; }
  static std::uint32_t bits(Mask mask) {
    return static_cast<std::uint32_t>(_mm_movemask_ps(reinterpret_cast<__m128>(mask.m)));
  }
#endif

  /// Of rows of four numbers, one for each lane, the four columns; and back. Full masks spare GCC 12 false warnings.
#if defined(__AVX512F__) && !defined(IMPULSE_DOUBLE)
  static void transpose(const auto& rows, std::uint32_t at, Register columns[4]) {
    Vector four[4];  // rows i, i + 4, i + 8, i + 12
    for (std::uint32_t i = 0; i < 4; ++i) {
      const __m256 low = _mm256_set_m128(_mm_loadu_ps(rows[at + i + 4]), _mm_loadu_ps(rows[at + i]));
      const __m256 high = _mm256_set_m128(_mm_loadu_ps(rows[at + i + 12]), _mm_loadu_ps(rows[at + i + 8]));
      four[i] = _mm512_maskz_insertf32x8(0xffff, _mm512_castps256_ps512(low), high, 1);
    }
    transpose_fours(four[0], four[1], four[2], four[3], columns);
  }
  static void transpose_back(const Register columns[4], const auto& rows, std::uint32_t at) {
    Register four[4];
    transpose_fours(columns[0].v, columns[1].v, columns[2].v, columns[3].v, four);
    for (std::uint32_t i = 0; i < 4; ++i) {
      _mm_storeu_ps(rows[at + i], _mm512_maskz_extractf32x4_ps(0xf, four[i].v, 0));
      _mm_storeu_ps(rows[at + i + 4], _mm512_maskz_extractf32x4_ps(0xf, four[i].v, 1));
      _mm_storeu_ps(rows[at + i + 8], _mm512_maskz_extractf32x4_ps(0xf, four[i].v, 2));
      _mm_storeu_ps(rows[at + i + 12], _mm512_maskz_extractf32x4_ps(0xf, four[i].v, 3));
    }
  }
  /// In each quarter of the registers.
  static void transpose_fours(Vector a, Vector b, Vector c, Vector d, Register to[4]) {
    const Vector low_ab = low_halves(a, b);
    const Vector high_ab = high_halves(a, b);
    const Vector low_cd = low_halves(c, d);
    const Vector high_cd = high_halves(c, d);
    to[0].v = __builtin_shufflevector(low_ab, low_cd, 0, 1, 16, 17, 4, 5, 20, 21, 8, 9, 24, 25, 12, 13, 28, 29);
    to[1].v = __builtin_shufflevector(low_ab, low_cd, 2, 3, 18, 19, 6, 7, 22, 23, 10, 11, 26, 27, 14, 15, 30, 31);
    to[2].v = __builtin_shufflevector(high_ab, high_cd, 0, 1, 16, 17, 4, 5, 20, 21, 8, 9, 24, 25, 12, 13, 28, 29);
    to[3].v = __builtin_shufflevector(high_ab, high_cd, 2, 3, 18, 19, 6, 7, 22, 23, 10, 11, 26, 27, 14, 15, 30, 31);
  }
  /// Of each quarter of a and of b one half, a number of each in turn.
  static Vector low_halves(Vector a, Vector b) {
    return __builtin_shufflevector(a, b, 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29);
  }
  static Vector high_halves(Vector a, Vector b) {
    return __builtin_shufflevector(a, b, 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31);
  }
#elif defined(__AVX512F__)
  static void transpose(const auto& rows, std::uint32_t at, Register columns[4]) {
    Vector pair[4];  // row i beside row i + 4
    for (std::uint32_t i = 0; i < 4; ++i) {
      const __m512d low = _mm512_castpd256_pd512(_mm256_loadu_pd(rows[at + i]));
      pair[i] = _mm512_maskz_insertf64x4(0xff, low, _mm256_loadu_pd(rows[at + i + 4]), 1);
    }
    transpose_fours(pair[0], pair[1], pair[2], pair[3], columns);
  }
  static void transpose_back(const Register columns[4], const auto& rows, std::uint32_t at) {
    Register pair[4];
    transpose_fours(columns[0].v, columns[1].v, columns[2].v, columns[3].v, pair);
    for (std::uint32_t i = 0; i < 4; ++i) {
      _mm256_storeu_pd(rows[at + i], _mm512_maskz_extractf64x4_pd(0xf, pair[i].v, 0));
      _mm256_storeu_pd(rows[at + i + 4], _mm512_maskz_extractf64x4_pd(0xf, pair[i].v, 1));
    }
  }
  /// In each half of the registers.
  static void transpose_fours(Vector a, Vector b, Vector c, Vector d, Register to[4]) {
    const Vector even_ab = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
    const Vector odd_ab = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
    const Vector even_cd = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14);
    const Vector odd_cd = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
    to[0].v = __builtin_shufflevector(even_ab, even_cd, 0, 1, 8, 9, 4, 5, 12, 13);
    to[1].v = __builtin_shufflevector(odd_ab, odd_cd, 0, 1, 8, 9, 4, 5, 12, 13);
    to[2].v = __builtin_shufflevector(even_ab, even_cd, 2, 3, 10, 11, 6, 7, 14, 15);
    to[3].v = __builtin_shufflevector(odd_ab, odd_cd, 2, 3, 10, 11, 6, 7, 14, 15);
  }
#elif defined(__AVX2__) && !defined(IMPULSE_DOUBLE)
  static void transpose(const auto& rows, std::uint32_t at, Register columns[4]) {
    Vector pair[4];  // row i beside row i + 4
    for (std::uint32_t i = 0; i < 4; ++i) {
      pair[i] = _mm256_set_m128(_mm_loadu_ps(rows[at + i + 4]), _mm_loadu_ps(rows[at + i]));
    }
    transpose_fours(pair[0], pair[1], pair[2], pair[3], columns);
  }
  static void transpose_back(const Register columns[4], const auto& rows, std::uint32_t at) {
    Register pair[4];
    transpose_fours(columns[0].v, columns[1].v, columns[2].v, columns[3].v, pair);
    for (std::uint32_t i = 0; i < 4; ++i) {
      _mm_storeu_ps(rows[at + i], _mm256_castps256_ps128(pair[i].v));
      _mm_storeu_ps(rows[at + i + 4], _mm256_extractf128_ps(pair[i].v, 1));
    }
  }
  /// In each half of the registers.
  static void transpose_fours(Vector a, Vector b, Vector c, Vector d, Register to[4]) {
    const Vector low_ab = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
    const Vector high_ab = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
    const Vector low_cd = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13);
    const Vector high_cd = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
    to[0].v = __builtin_shufflevector(low_ab, low_cd, 0, 1, 8, 9, 4, 5, 12, 13);
    to[1].v = __builtin_shufflevector(low_ab, low_cd, 2, 3, 10, 11, 6, 7, 14, 15);
    to[2].v = __builtin_shufflevector(high_ab, high_cd, 0, 1, 8, 9, 4, 5, 12, 13);
    to[3].v = __builtin_shufflevector(high_ab, high_cd, 2, 3, 10, 11, 6, 7, 14, 15);
  }
#elif defined(__AVX2__) || !defined(IMPULSE_DOUBLE)
  static void transpose(const auto& rows, std::uint32_t at, Register columns[4]) {
    transpose_fours(load(rows[at]).v, load(rows[at + 1]).v, load(rows[at + 2]).v, load(rows[at + 3]).v, columns);
  }
  static void transpose_back(const Register columns[4], const auto& rows, std::uint32_t at) {
    Register row[4];
    transpose_fours(columns[0].v, columns[1].v, columns[2].v, columns[3].v, row);
    for (std::uint32_t i = 0; i < 4; ++i) row[i].store(rows[at + i]);
  }
  static void transpose_fours(Vector a, Vector b, Vector c, Vector d, Register to[4]) {
    const Vector low_ab = __builtin_shufflevector(a, b, 0, 4, 1, 5);
    const Vector high_ab = __builtin_shufflevector(a, b, 2, 6, 3, 7);
    const Vector low_cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
    const Vector high_cd = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    to[0].v = __builtin_shufflevector(low_ab, low_cd, 0, 1, 4, 5);
    to[1].v = __builtin_shufflevector(low_ab, low_cd, 2, 3, 6, 7);
    to[2].v = __builtin_shufflevector(high_ab, high_cd, 0, 1, 4, 5);
    to[3].v = __builtin_shufflevector(high_ab, high_cd, 2, 3, 6, 7);
  }
#else
  static void transpose(const auto& rows, std::uint32_t at, Register columns[4]) {
    for (std::uint32_t half = 0; half < 2; ++half) {
      const Vector a = load(rows[at] + 2 * half).v;
      const Vector b = load(rows[at + 1] + 2 * half).v;
      columns[2 * half].v = __builtin_shufflevector(a, b, 0, 2);
      columns[2 * half + 1].v = __builtin_shufflevector(a, b, 1, 3);
    }
  }
  static void transpose_back(const Register columns[4], const auto& rows, std::uint32_t at) {
    for (std::uint32_t half = 0; half < 2; ++half) {
      const Vector a = columns[2 * half].v;
      const Vector b = columns[2 * half + 1].v;
      Register{__builtin_shufflevector(a, b, 0, 2)}.store(rows[at] + 2 * half);
      Register{__builtin_shufflevector(a, b, 1, 3)}.store(rows[at + 1] + 2 * half);
    }
  }
#endif
};

#else

using Register = ScalarRegister;

#endif

constexpr std::uint32_t lane_count = Register::width > 8 ? Register::width : 8;
constexpr std::uint32_t all_lanes = (1U << lane_count) - 1;
/// The first n lanes, or all.
inline std::uint32_t first_lanes(std::uint32_t n) { return n < lane_count ? (1U << n) - 1 : all_lanes; }

/// A yes or no for each lane.
template <class R>
struct MaskOf {
  typename R::Mask part[lane_count / R::width];

  friend MaskOf operator&(const MaskOf& a, const MaskOf& b) {
    return each([&](std::uint32_t i) { return a.part[i] & b.part[i]; });
  }
  friend MaskOf operator|(const MaskOf& a, const MaskOf& b) {
    return each([&](std::uint32_t i) { return a.part[i] | b.part[i]; });
  }
  friend MaskOf operator!(const MaskOf& a) {
    return each([&](std::uint32_t i) { return !a.part[i]; });
  }
  /// Bit i tells of lane i.
  std::uint32_t bits() const {
    std::uint32_t all = 0;
    for (std::uint32_t i = 0; i < lane_count / R::width; ++i) all |= R::bits(part[i]) << (i * R::width);
    return all;
  }
  static MaskOf of(std::uint32_t bits) {
    return each([&](std::uint32_t i) { return R::of(bits >> (i * R::width)); });
  }
  template <class PartOf>
  static MaskOf each(PartOf part_of) {
    MaskOf result;
    for (std::uint32_t i = 0; i < lane_count / R::width; ++i) result.part[i] = part_of(i);
    return result;
  }
};

/// A number for each lane. Comparisons are no where either is not a number.
template <class R>
struct LanesOf {
  using Mask = MaskOf<R>;
  R part[lane_count / R::width];

  static LanesOf load(const Real* from) {
    return each([&](std::uint32_t i) { return R::load(from + i * R::width); });
  }
  static LanesOf all(Real value) {
    return each([&](std::uint32_t) { return R::all(value); });
  }
  void store(Real* to) const {
    for (std::uint32_t i = 0; i < lane_count / R::width; ++i) part[i].store(to + i * R::width);
  }
  friend LanesOf operator+(const LanesOf& a, const LanesOf& b) {
    return each([&](std::uint32_t i) { return a.part[i] + b.part[i]; });
  }
  friend LanesOf operator-(const LanesOf& a, const LanesOf& b) {
    return each([&](std::uint32_t i) { return a.part[i] - b.part[i]; });
  }
  friend LanesOf operator*(const LanesOf& a, const LanesOf& b) {
    return each([&](std::uint32_t i) { return a.part[i] * b.part[i]; });
  }
  friend LanesOf operator/(const LanesOf& a, const LanesOf& b) {
    return each([&](std::uint32_t i) { return a.part[i] / b.part[i]; });
  }
  friend LanesOf operator-(const LanesOf& a) {
    return each([&](std::uint32_t i) { return -a.part[i]; });
  }
  friend Mask operator<(const LanesOf& a, const LanesOf& b) {
    return Mask::each([&](std::uint32_t i) { return a.part[i] < b.part[i]; });
  }
  friend Mask operator<=(const LanesOf& a, const LanesOf& b) {
    return Mask::each([&](std::uint32_t i) { return a.part[i] <= b.part[i]; });
  }
  friend Mask operator==(const LanesOf& a, const LanesOf& b) {
    return Mask::each([&](std::uint32_t i) { return a.part[i] == b.part[i]; });
  }
  /// yes where the mask is set, no elsewhere.
  friend LanesOf select(const Mask& mask, const LanesOf& yes, const LanesOf& no) {
    return each([&](std::uint32_t i) { return R::select(mask.part[i], yes.part[i], no.part[i]); });
  }
  /// As std::max and std::min: the first where the two compare equal, or do not compare.
  friend LanesOf max(const LanesOf& a, const LanesOf& b) { return select(a < b, b, a); }
  friend LanesOf min(const LanesOf& a, const LanesOf& b) { return select(b < a, b, a); }
  friend LanesOf sqrt(const LanesOf& a) {
    return each([&](std::uint32_t i) { return R::root(a.part[i]); });
  }
  friend LanesOf abs(const LanesOf& a) {
    return each([&](std::uint32_t i) { return R::magnitude(a.part[i]); });
  }

  /// rows[i] is where lane i's four numbers are; the k-th of them go to columns[k].
  static void gather(const auto& rows, LanesOf columns[4]) {
    for (std::uint32_t i = 0; i < lane_count / R::width; ++i) {
      R part[4];
      R::transpose(rows, i * R::width, part);
      for (std::uint32_t k = 0; k < 4; ++k) columns[k].part[i] = part[k];
    }
  }
  static void scatter(const LanesOf columns[4], const auto& rows) {
    for (std::uint32_t i = 0; i < lane_count / R::width; ++i) {
      R part[4];
      for (std::uint32_t k = 0; k < 4; ++k) part[k] = columns[k].part[i];
      R::transpose_back(part, rows, i * R::width);
    }
  }
  template <class PartOf>
  static LanesOf each(PartOf part_of) {
    LanesOf result;
    for (std::uint32_t i = 0; i < lane_count / R::width; ++i) result.part[i] = part_of(i);
    return result;
  }
};

using Lanes = LanesOf<Register>;

/// Of every set of eight lanes its members in order, then zeros, and how many they are.
struct SetOfLanes {
  std::uint8_t members[8];
  std::uint8_t count;
};
struct SetsOfLanes {
  SetOfLanes of[1U << 8U];
};
constexpr SetsOfLanes list_sets() {
  SetsOfLanes sets{};
  for (std::uint32_t bits = 0; bits < 1U << 8U; ++bits) {
    for (std::uint8_t lane = 0; lane < 8; ++lane) {
      if ((bits >> lane & 1U) != 0) sets.of[bits].members[sets.of[bits].count++] = lane;
    }
  }
  return sets;
}
inline constexpr SetsOfLanes sets_of_lanes = list_sets();

/// Writes base + i for every lane i in a set of eight and returns the end of what counts; there must be room for all.
inline std::uint32_t* write_eight(std::uint32_t bits, std::uint32_t base, std::uint32_t* to) {
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
  for (std::uint32_t i = 0; i < 8; ++i) to[i] = base + set.members[i];
#endif
  return to + set.count;
}

/// The same for all lanes.
inline std::uint32_t* write_members(std::uint32_t bits, std::uint32_t base, std::uint32_t* to) {
  for (std::uint32_t i = 0; i < lane_count; i += 8) to = write_eight(bits >> i & 0xffU, base + i, to);
  return to;
}

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
