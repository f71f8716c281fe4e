#include <memory>

#include "core/method_list.h"
#include "methods/position_correction.h"
#include "methods/sequential_impulses.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Velocities and positions apart: sequential impulses that only stop what approaches, then the overlap is removed by
/// moving the bodies. What was pushed into each other parts without a jump.
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

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
