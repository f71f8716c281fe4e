// Every version of the kernel against sin_cos, bit for bit.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

#include "../../real_literal.h"
#include "impulse/math.h"
#include "solver/lanes/kernels.h"

namespace impulse::inline IMPULSE_PRECISION::rotations_test {

namespace {

auto bits(Real number) {
  return std::bit_cast<std::conditional_t<sizeof number == 4, std::uint32_t, std::uint64_t>>(number);
}

void expect_bits_of_sin_cos(std::vector<Real> angles) {
  const std::size_t count = angles.size();
  angles.resize(count + 8);
  for (const InstructionSet set : runnable_instruction_sets()) {
    std::vector<Real> cosines(angles.size()), sines(angles.size());
    solver_kernels(set).turn_to_angles(angles.data(), static_cast<std::uint32_t>(count), cosines.data(), sines.data());
    for (std::size_t i = 0; i < count; ++i) {
      const SinCos of = sin_cos(angles[i]);
      ASSERT_EQ(bits(cosines[i]), bits(of.cos)) << angles[i];
      ASSERT_EQ(bits(sines[i]), bits(of.sin)) << angles[i];
    }
  }
}

TEST(Rotations, AreThoseOfSinCosForAnglesOfAnySize) {
  std::mt19937_64 random(1);
  for (const double range : {1e-30, 1e-3, 1., 4., 100., 1e4, 1.6e6}) {
    std::uniform_real_distribution<double> number(-range, range);
    std::vector<Real> angles(100000);
    for (Real& angle : angles) angle = static_cast<Real>(number(random));
    expect_bits_of_sin_cos(angles);
  }
}

TEST(Rotations, AreThoseOfSinCosNextToMultiplesOfAnEighthTurn) {
  std::vector<Real> angles;
  for (int n = -20000; n <= 20000; ++n) {
    const auto angle = static_cast<Real>(n * (3.14159265358979323846 / 4));
    angles.insert(angles.end(), {std::nextafter(angle, -10_r * std::abs(angle)), angle, std::nextafter(angle, 1e9_r)});
  }
  expect_bits_of_sin_cos(angles);
}

TEST(Rotations, AreThoseOfSinCosForZeroHugeAndNanAngles) {
  constexpr Real huge = std::numeric_limits<Real>::max();
  constexpr Real infinity = std::numeric_limits<Real>::infinity();
  constexpr Real tiny = std::numeric_limits<Real>::denorm_min();
  constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
  // Among others in the same register, and one in each place of it.
  const std::array specials{0_r,      -0_r,     tiny, -tiny, 1.6e6_r,  std::nextafter(1.6e6_r, 2e6_r),
                            -1.7e6_r, 123.e9_r, huge, -huge, infinity, -infinity,
                            nan};
  for (const Real special : specials) {
    for (std::size_t place = 0; place < 13; ++place) {
      std::vector<Real> angles(13, 2_r);
      angles[place] = special;
      expect_bits_of_sin_cos(angles);
    }
  }
}

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION::rotations_test
