#include "reports/judge/poses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "../fakes.h"

namespace plumb::poses_test {
namespace {

constexpr double dt = 0.1;
constexpr double factor = 10;       // by which differences grow
constexpr double own = 0.5;         // m, the method's error
constexpr std::size_t horizon = 5;  // moments
constexpr Stepping stepping{.dt = dt, .h = dt, .epsilon = 0x1p-53};

class FakeAmplification : public Amplification {
 public:
  explicit FakeAmplification(double undecided) : undecided_(undecided) {}
  std::optional<double> of(double size, std::size_t moment, std::size_t) const override {
    return moment < horizon ? std::optional(factor * size) : std::nullopt;
  }
  std::optional<double> of_method(const Stepping&, std::size_t, std::size_t) const override { return own; }
  double undecided_from(double, std::span<const double>) const override { return undecided_; }

 private:
  double undecided_;
};

// A box at rest for eight moments, and a run of it that is off by as much in all moments from one on.
class Poses : public ::testing::Test {
 protected:
  RelationCheck check(double off, std::size_t from, double undecided = std::numeric_limits<double>::infinity()) {
    const FakeAmplification amplification(undecided);
    const RelationRun run{scene_, trace_, stepping, amplification};
    const std::vector<double> rounding(trace_.size(), 1e-6);
    return compare_poses(
        run, trace_.size(),
        [&](std::size_t moment, std::size_t body) {
          BodyState state = trace_.states(moment)[body];
          if (moment >= from) state.position.x += off;
          return state;
        },
        explained_by_rounding(run, rounding));
  }

  void SetUp() override {
    for (int i = 0; i < 8; ++i) trace_.record(i * dt, initial_states(scene_), {});
  }

  Scene scene_ = fakes::thrown_box();
  Trace trace_{1};
};

TEST_F(Poses, AreHeldToTheLeastThatExplainsThem) {
  EXPECT_EQ(check(5e-7, 0).check.tolerance, 1e-6);
  EXPECT_EQ(check(5e-6, 0).check.tolerance, factor * 1e-6);
  EXPECT_EQ(check(5e-6, 0).check.status, CheckStatus::held);
  EXPECT_EQ(check(5e-5, 0).check.status, CheckStatus::broken);
}

TEST_F(Poses, AreNotComparedBeyondTheHorizon) {
  EXPECT_EQ(check(1, horizon).check.status, CheckStatus::held);
  EXPECT_EQ(check(1, horizon - 1).check.status, CheckStatus::broken);
  EXPECT_NE(check(1, horizon).check.detail.find("the horizon"), std::string::npos);
}

TEST_F(Poses, MayDifferByTheMethodsErrorOnceItDecidesByRoundOff) {
  EXPECT_EQ(check(0.9, 3, 0.25).check.status, CheckStatus::held);
  EXPECT_EQ(check(1.1, 3, 0.25).check.status, CheckStatus::broken);
  EXPECT_EQ(check(0.9, 2, 0.25).check.status, CheckStatus::broken);
}

TEST_F(Poses, SayWhenNothingCanBeTold) {
  const FakeAmplification amplification(0);
  const RelationRun run{scene_, trace_, stepping, amplification};
  const std::vector<Allowance> unknown{{"who knows", [](std::size_t, std::size_t) { return std::nullopt; }}};
  const auto same = [&](std::size_t moment, std::size_t body) { return trace_.states(moment)[body]; };
  EXPECT_EQ(compare_poses(run, trace_.size(), same, unknown).why_not,
            "what may differ cannot be told from the start on: who knows");
}

TEST_F(Poses, CountNoTurns) {
  const FakeAmplification amplification(0);
  const RelationRun run{scene_, trace_, stepping, amplification};
  const auto turned = [&](std::size_t moment, std::size_t body) {
    BodyState state = trace_.states(moment)[body];
    state.angle += 6.283185307179586;
    return state;
  };
  EXPECT_LT(compare_poses(run, trace_.size(), turned, explained_by_rounding(run, pose_rounding(run))).check.value,
            1e-14);
}

// An engine in float that only adds, as for quantity_rounding.
TEST(PoseRounding, BoundsTheErrorOfFloats) {
  const Scene scene = fakes::thrown_box();
  constexpr double step = 1e-3;
  Trace trace(1);
  float y = 2;
  float v = 8;
  for (int i = 0; i <= 2000; ++i) {
    const BodyState state{.position = {0, y}, .velocity = {0, v}};
    trace.record(i * step, std::span(&state, 1), {});
    v += static_cast<float>(step) * -10.0F;
    y += static_cast<float>(step) * v;
  }
  const FakeAmplification amplification(0);
  const Stepping floats{.dt = step, .h = step, .epsilon = 0x1p-24};
  const std::vector<double> bound = pose_rounding({scene, trace, floats, amplification});
  ASSERT_EQ(bound.size(), 2001U);
  for (int i = 1; i <= 2000; ++i) {
    const double t = i * step;
    const double exact = 2 + 8 * t - 5 * t * t - 5 * t * step;  // of symplectic Euler
    const auto moment = static_cast<std::size_t>(i);
    EXPECT_LE(std::abs(trace.states(moment)[0].position.y - exact), bound[moment]) << i;
  }
  EXPECT_LT(bound.back(), 0.01);
  EXPECT_GT(bound.back(), bound[1]);
}

}  // namespace
}  // namespace plumb::poses_test
