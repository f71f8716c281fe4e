#pragma once

#include <array>
#include <vector>

#include "contacts/contact_rows.h"
#include "methods/position_correction.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

/// A row with the separating speed (m/s) required at each of its points.
struct ImpulseRow : ContactRow {
  std::array<Real, 2> rebound{};
};

/// The common part of the methods of sequential impulses: one step of the chosen integrator, between whose halves the
/// contacts are solved one after the other, repeatedly (projected Gauss-Seidel). Impulses are accumulated: an iteration
/// may reduce what an earlier one applied, and only the sum must be >= 0; the sums are the start of the next step (warm
/// starting).
///
/// Restitution follows Newton's law, from the velocities at the start of the step.
class SequentialImpulses : public Solver {
 public:
  void step(StepData& data) final;
  /// A fraction of the overlap beyond the slop is removed in each step; 1 % of the slop is allowed for what remains.
  void state(const Settings&, StatedErrors& errors) const final {
    errors.gap = slop + slop / 100;
    errors.joint_gap = slop;  // each iteration removes a joint's error, but its neighbours bring some of it back
    errors.restitution_threshold = restitution_threshold;
    errors.joints = true;
  }

 protected:
  static constexpr Real slop = static_cast<Real>(.005);  // m, overlap left so that contacts persist
  static constexpr Real restitution_threshold = 1;       // m/s, of approach

  /// Non-penetration at the points of one row.
  virtual void push_apart(ImpulseRow& row, ContactFrame& frame) const = 0;
  /// May add to the required separating speeds; returns the fraction of a joint's error to be removed by velocities in
  /// a step.
  virtual Real steer(std::vector<ImpulseRow>&, Real /*dt*/) const { return 0; }
  /// Corrects positions after the bodies have moved; the rows are of the start of the step.
  virtual void correct(StepData&, const std::vector<ImpulseRow>&, const StartPoses&) {}

 private:
  void prepare(StepData& data);
  void warm_start(StepData& data);
  void iterate(StepData& data, Real joint_share);

  std::vector<ContactRow> plain_rows_;
  std::vector<ImpulseRow> rows_;
  std::vector<Pose> start_;
  std::vector<Real> start_angle_;
};

/// vn >= rebound at one point, by the accumulated impulse.
inline void push_apart(ImpulseRow& row, std::size_t point, ContactFrame& frame) {
  RowPoint& p = row.points[point];
  const Real push = p.normal_mass * (row.rebound[point] - frame.normal_velocity(p));
  apply_accumulated(row, p, frame, p.normal_impulse + push > 0 ? p.normal_impulse + push : Real{0});
}

/// The same at all points, one after the other.
inline void push_apart_in_turn(ImpulseRow& row, ContactFrame& frame) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) push_apart(row, i, frame);
}

}  // namespace impulse::inline IMPULSE_PRECISION
