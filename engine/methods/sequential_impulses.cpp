#include "methods/sequential_impulses.h"

#include <algorithm>
#include <memory>

#include "core/method_list.h"

namespace impulse::inline IMPULSE_PRECISION {

void SequentialImpulses::step(StepData& data) {
  const Real dt = data.settings.dt;
  start_ = data.bodies.pose;
  start_angle_ = data.bodies.angle;
  data.integrator.begin(data.bodies, data.forces, dt);
  prepare(data);
  const Real joint_share = steer(rows_, dt);
  warm_start(data);
  for (int i = 0; i < data.settings.iterations; ++i) iterate(data, joint_share);
  for (ImpulseRow& row : rows_) {
    for (RowPoint& p : row.points) {
      p.total_normal = p.normal_impulse;
      p.total_tangent = p.tangent_impulse;
    }
    store_row(row, data.contacts);
  }
  data.integrator.finish(data.bodies, data.forces, dt);
  correct(data, rows_, {start_, start_angle_});
}

void SequentialImpulses::prepare(StepData& data) {
  prepare_rows(data.bodies, data.contacts, plain_rows_);
  rows_.clear();
  for (const ContactRow& plain : plain_rows_) {
    ImpulseRow& row = rows_.emplace_back(ImpulseRow{plain, {}});
    const ContactFrame frame(row, data.bodies.velocity[row.a], data.bodies.velocity[row.b]);
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      const Real vn = frame.normal_velocity(row.points[i]);
      if (vn < -restitution_threshold) row.rebound[i] = -row.restitution * vn;
    }
  }
}

void SequentialImpulses::warm_start(StepData& data) {
  std::vector<Velocity>& velocity = data.bodies.velocity;
  for (const ActiveJoint& joint : data.joints) {
    impulse::warm_start(joint.block, 1, velocity[joint.block.a], velocity[joint.block.b]);
  }
  for (const ImpulseRow& row : rows_) {
    ContactFrame frame(row, velocity[row.a], velocity[row.b]);
    impulse::warm_start(row, frame);
    frame.write_back(row, velocity[row.a], velocity[row.b]);
  }
}

// Joints and friction first: the constraint solved last is satisfied best, and non-penetration matters most.
void SequentialImpulses::iterate(StepData& data, Real joint_share) {
  std::vector<Velocity>& velocity = data.bodies.velocity;
  for (ActiveJoint& joint : data.joints) solve_joint(joint.block, data.settings.dt, joint_share, data.bodies);
  for (ImpulseRow& row : rows_) {
    ContactFrame frame(row, velocity[row.a], velocity[row.b]);
    solve_friction(row, frame);
    push_apart(row, frame);
    frame.write_back(row, velocity[row.a], velocity[row.b]);
  }
}

namespace {

constexpr Real beta = static_cast<Real>(.2);  // fraction of the error removed in a step

/// Sequential impulses with Baumgarte's stabilisation: a point that overlaps beyond the slop must separate at
///
///   beta (overlap - slop) / dt,
///
/// so the same impulses that stop bodies also push them apart. Simple, but that velocity is energy: overlapping bodies
/// jump apart.
class SequentialImpulse : public SequentialImpulses {
 private:
  void push_apart(ImpulseRow& row, ContactFrame& frame) const override { push_apart_in_turn(row, frame); }

  Real steer(std::vector<ImpulseRow>& rows, Real dt) const override {
    for (ImpulseRow& row : rows) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
        const Real overlap = -row.points[i].separation - slop;
        row.rebound[i] = std::max(row.rebound[i], beta * overlap / dt);
      }
    }
    return beta;
  }
};

const MethodList<Solver>::Entry sequential_impulse_entry{
    {"sequential-impulse", "accumulated, warm-started impulses; overlap pushed apart by velocities (Baumgarte)",
     "E. Catto, Iterative Dynamics with Temporal Coherence (GDC 2005), Fast and Simple Physics using Sequential "
     "Impulses (GDC 2006), and Box2D-Lite"},
    [] { return std::make_unique<SequentialImpulse>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
