#include <memory>
#include <optional>

#include "core/method_list.h"
#include "methods/position_correction.h"
#include "methods/sequential_impulses.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Solves velocities and positions separately: sequential impulses only stop the approach, then overlap is removed by
/// moving the bodies, which therefore separate without a jump.
class SplitImpulse : public SequentialImpulses {
 private:
  void push_apart(ImpulseRow& row, ContactFrame& frame) const override { push_apart_in_turn(row, frame); }
  void correct(StepData& data, const std::vector<ImpulseRow>& rows, const StartPoses& start) override {
    positions_.run(data.bodies, rows, data.joints, start, slop, data.settings.position_iterations);
  }

  PositionCorrection positions_;
};

const MethodList<Solver>::Entry split_impulse_entry{
    {"split-impulse", "accumulated, warm-started impulses; positions corrected apart (nonlinear Gauss-Seidel)",
     "E. Catto, Modeling and Solving Constraints (GDC 2009), and Box2D 2.4"},
    [] { return std::make_unique<SplitImpulse>(); }};

/// The matrix of two points almost in one place does not determine the difference of their loads.
constexpr Real worst_condition = 1000;

/// Sequential impulses in which the two points of a manifold are solved together, so that a box resting on a side does
/// not rock between its corners. With K the matrix of inverse effective masses, w the separating speeds beyond those
/// required, and x the accumulated impulses,
///
///   w = K x + q,   w >= 0,   x >= 0,   w . x = 0,
///
/// a linear complementarity problem small enough to try its four cases in turn (Murty, Linear Complementarity,
/// 1988, total enumeration). Positions as in split-impulse.
class Block : public SequentialImpulses {
 private:
  void push_apart(ImpulseRow& row, ContactFrame& frame) const override;
  void correct(StepData& data, const std::vector<ImpulseRow>& rows, const StartPoses& start) override {
    positions_.run(data.bodies, rows, data.joints, start, slop, data.settings.position_iterations);
  }

  PositionCorrection positions_;
};

/// x of the problem above, K = ((k11, k12), (k12, k22)); nullopt if rounding excludes all four cases.
std::optional<Vec2> complementary(const Mat22& k, Vec2 q) {
  const Vec2 both = k.solve(-q);
  if (both.x >= 0 && both.y >= 0) return both;
  const Vec2 first{-q.x / k.x.x, 0};
  if (first.x >= 0 && k.x.y * first.x + q.y >= 0) return first;
  const Vec2 second{0, -q.y / k.y.y};
  if (second.y >= 0 && k.y.x * second.y + q.x >= 0) return second;
  if (q.x >= 0 && q.y >= 0) return Vec2{};
  return std::nullopt;
}

void Block::push_apart(ImpulseRow& row, ContactFrame& frame) const {
  if (row.count < 2) return push_apart_in_turn(row, frame);
  RowPoint& p1 = row.points[0];
  RowPoint& p2 = row.points[1];
  const Real k11 = 1 / p1.normal_mass;
  const Real k22 = 1 / p2.normal_mass;
  const Real k12 =
      row.mass_a.m + row.mass_b.m + row.mass_a.i * p1.cross_a * p2.cross_a + row.mass_b.i * p1.cross_b * p2.cross_b;
  const Mat22 k({k11, k12}, {k12, k22});
  if (k11 * k22 > worst_condition * k.determinant()) return push_apart_in_turn(row, frame);
  const Vec2 before{p1.normal_impulse, p2.normal_impulse};
  const Vec2 speed{frame.normal_velocity(p1) - row.rebound[0], frame.normal_velocity(p2) - row.rebound[1]};
  const std::optional<Vec2> total = complementary(k, speed - k * before);
  if (!total) return push_apart_in_turn(row, frame);
  apply_accumulated(row, p1, frame, total->x);
  apply_accumulated(row, p2, frame, total->y);
}

const MethodList<Solver>::Entry block_entry{
    {"block", "as split-impulse, but the two points of a manifold are solved together",
     "E. Catto, Box2D 2.4 (block solver); K. Murty, Linear Complementarity (1988)"},
    [] { return std::make_unique<Block>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
