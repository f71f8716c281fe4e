// Compares lanes with one number at a time, bit for bit.
#include "core/simd.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "../random_shapes.h"

namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

namespace {

using Numbers = std::array<Real, lane_count>;
using Twin = LanesOf<ScalarRegister>;

/// Random numbers, among them equal ones and special values.
Numbers numbers(RandomShapes& random) {
  using Limits = std::numeric_limits<Real>;
  const std::array<Real, 8> odd{0,
                                -Real{0},
                                Limits::infinity(),
                                -Limits::infinity(),
                                Limits::quiet_NaN(),
                                1,
                                Limits::denorm_min(),
                                Limits::max()};
  Numbers result{};
  for (Real& one : result) {
    const Real chance = random.number(0, 16);
    one = chance < 8 ? odd[static_cast<std::size_t>(chance)] : random.number(-2, 2);
  }
  return result;
}

TEST(Lanes, CompareLikeNumbers) {
  RandomShapes random(1);
  for (int i = 0; i < 1000; ++i) {
    const Numbers a = numbers(random);
    const Numbers b = numbers(random);
    const Numbers c = numbers(random);
    const std::uint32_t at_most = (Lanes::load(a.data()) <= Lanes::load(b.data())).bits();
    EXPECT_EQ(at_most, (Twin::load(a.data()) <= Twin::load(b.data())).bits());
    EXPECT_EQ(Lanes::Mask::of(at_most).bits(), at_most);
    EXPECT_EQ(Twin::Mask::of(at_most).bits(), at_most);
    const auto between = (Lanes::all(a[0]) <= Lanes::load(b.data())) & (Lanes::load(b.data()) <= Lanes::load(c.data()));
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      EXPECT_EQ(at_most >> lane & 1U, a[lane] <= b[lane] ? 1U : 0U);
      EXPECT_EQ(between.bits() >> lane & 1U, a[0] <= b[lane] && b[lane] <= c[lane] ? 1U : 0U);
    }
  }
}

/// Whether the two are equal (zeros also in sign) or both are NaN.
void expect_same(const Lanes& lanes, const Twin& twin) {
  Numbers a{};
  Numbers b{};
  lanes.store(a.data());
  twin.store(b.data());
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    if (std::isnan(b[lane])) {
      EXPECT_TRUE(std::isnan(a[lane]));
    } else {
      EXPECT_EQ(a[lane], b[lane]);
      EXPECT_EQ(std::signbit(a[lane]), std::signbit(b[lane]));
    }
  }
}

TEST(Lanes, CalculateLikeNumbers) {
  RandomShapes random(2);
  for (int i = 0; i < 1000; ++i) {
    const Numbers numbers_a = numbers(random);
    const Numbers numbers_b = numbers(random);
    const Lanes a = Lanes::load(numbers_a.data());
    const Lanes b = Lanes::load(numbers_b.data());
    const Twin twin_a = Twin::load(numbers_a.data());
    const Twin twin_b = Twin::load(numbers_b.data());
    expect_same(a + b, twin_a + twin_b);
    expect_same(a - b, twin_a - twin_b);
    expect_same(a * b, twin_a * twin_b);
    expect_same(a / b, twin_a / twin_b);
    expect_same(-a, -twin_a);
    expect_same(sqrt(a), sqrt(twin_a));
    expect_same(abs(a), abs(twin_a));
    expect_same(max(a, b), max(twin_a, twin_b));
    expect_same(min(a, b), min(twin_a, twin_b));
    expect_same(select((a < b) | !(a == b), a, b), select((twin_a < twin_b) | !(twin_a == twin_b), twin_a, twin_b));
    EXPECT_EQ((a < b).bits(), (twin_a < twin_b).bits());
  }
}

TEST(Lanes, GatherAndScatterRows) {
  std::array<std::array<Real, 4>, lane_count> rows{};
  std::array<Real*, lane_count> to{};
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    for (std::size_t k = 0; k < 4; ++k) rows[lane][k] = static_cast<Real>(10 * lane + k);
    to[lane] = rows[lane].data();
  }
  std::array<Lanes, 4> columns{};
  Lanes::gather(to.data(), columns.data());
  for (std::size_t k = 0; k < 4; ++k) {
    Numbers column{};
    columns[k].store(column.data());
    for (std::size_t lane = 0; lane < lane_count; ++lane) EXPECT_EQ(column[lane], static_cast<Real>(10 * lane + k));
  }
  std::reverse(to.begin(), to.end());
  Lanes::scatter(columns.data(), to.data());
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(rows[lane][k], static_cast<Real>(10 * (lane_count - 1 - lane) + k));
  }
}

TEST(Lanes, WriteTheMembersOfEverySetInOrder) {
  for (std::uint32_t bits = 0; bits < 256; ++bits) {
    std::array<std::uint32_t, lane_count + 1> written{};
    written.back() = 7;
    const std::uint32_t* end = write_members(bits, 1000, written.data());
    const std::uint32_t* next = written.data();
    for (std::uint32_t lane = 0; lane < lane_count; ++lane) {
      if ((bits >> lane & 1U) == 0) continue;
      EXPECT_EQ(*next++, 1000 + lane) << bits;
    }
    EXPECT_EQ(next, end);
    EXPECT_EQ(written.back(), 7U);
  }
}

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
