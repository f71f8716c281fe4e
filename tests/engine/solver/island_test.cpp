#include "solver/island.h"

#include <gtest/gtest.h>

#include <complex>
#include <numbers>

namespace impulse::inline IMPULSE_PRECISION::island_test {
namespace {

constexpr double dt = 1.0 / 60;
constexpr double damping_ratio = 10;

/// Calls see(softness) for those that contacts have, cut into 1 to 32 sub-steps.
template <class See>
void for_all_softnesses(See see) {
  for (const int substeps : {1, 2, 4, 5, 8, 16, 32}) {
    const Real h = static_cast<Real>(dt / substeps);
    for (const Real steps : {Real{4}, Real{6}, Real{8}, Real{12}}) {
      see(Softness::of(1 / (steps * h), static_cast<Real>(damping_ratio), h));
    }
  }
}

/// Share of its stiffness by which a contact takes energy from what swings with `swing` rad/s: the imaginary part of
/// its answer. Its offset follows once a step, from the depth at the end of one for all of the next.
double taken(const OffsetRule& rule, const Softness& soft, double swing) {
  const double gain = rule.gain(soft);
  const double leak = rule.leak();
  const std::complex<double> step = std::polar(1.0, -swing * dt);
  // o[n] = o[n-1] + gain x[n] - leak o[n-1], held for a step: half of one late on the mean.
  const std::complex<double> offset = gain / (1.0 - (1 - leak) * step) * std::polar(1.0, -swing * dt / 2);
  return offset.imag() + swing * 2 * damping_ratio / soft.omega;
}

TEST(OffsetRule, OfGranularPilesDampsEveryOscillation) {
  const OffsetRule rule = OffsetRule::passive(static_cast<Real>(dt), static_cast<Real>(damping_ratio));
  for_all_softnesses([&](const Softness& soft) {
    for (double swing = 1e-3; swing < std::numbers::pi / dt; swing *= 1.1) {
      EXPECT_GT(taken(rule, soft, swing), 0) << "w " << soft.omega << " at " << swing << " rad/s";
    }
  });
}

TEST(OffsetRule, WithoutALeakExcitesSlowOscillations) {
  const double h = dt / 4;
  const Softness soft = Softness::of(static_cast<Real>(1 / (12 * h)), static_cast<Real>(damping_ratio), Real(h));
  const OffsetRule rule = OffsetRule::lifting(static_cast<Real>(dt), 60, static_cast<Real>(damping_ratio), soft);
  EXPECT_LT(taken(rule, soft, .5), 0);
  EXPECT_GT(taken(rule, soft, 10), 0);
}

/// The depth at which a load rests that presses in by `explained` without an offset.
double rests_at(const OffsetRule& rule, const Softness& soft, double explained) {
  double offset = 0;
  double last = explained;
  for (int step = 0; step < 10000; ++step) {
    const double depth = explained - offset;
    EXPECT_LE(depth, last * (1 + 1e-6)) << "swings back in step " << step;
    last = depth;
    offset += static_cast<double>(rule.gain(soft)) * depth - static_cast<double>(rule.leak()) * offset;
  }
  return explained - offset;
}

TEST(OffsetRule, LeavesAThirdOfThePenetrationOnlyInGranularPiles) {
  const double h = dt / 4;
  const Softness soft = Softness::of(static_cast<Real>(1 / (12 * h)), static_cast<Real>(damping_ratio), Real(h));
  const OffsetRule passive = OffsetRule::passive(static_cast<Real>(dt), static_cast<Real>(damping_ratio));
  EXPECT_NEAR(rests_at(passive, soft, .009), .003, 1e-8);
  const OffsetRule lifting = OffsetRule::lifting(static_cast<Real>(dt), 60, static_cast<Real>(damping_ratio), soft);
  EXPECT_NEAR(rests_at(lifting, soft, .009), 0, 1e-8);
}

TEST(OffsetRule, NeverOvershoots) {
  const OffsetRule rule = OffsetRule::passive(static_cast<Real>(dt), static_cast<Real>(damping_ratio));
  for_all_softnesses([&](const Softness& soft) {
    EXPECT_LE(rule.gain(soft) + rule.leak(), Real{1});
    EXPECT_GT(rests_at(rule, soft, .009), 0);
  });
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::island_test
