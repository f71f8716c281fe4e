#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "contacts/contact_rows.h"
#include "core/method_list.h"
#include "core/softness.h"
#include "core/stages.h"
#include "solver/motion.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr Real speculative = static_cast<Real>(.02);  // m, gap up to which contacts are considered
constexpr Real highest_frequency = 30;                // 1/s, of contacts; but never beyond a quarter of the sub-steps'
constexpr Real damping_ratio = 10;
constexpr Real push_out_speed = 3;         // m/s, the greatest speed at which overlap is removed
constexpr Real restitution_threshold = 1;  // m/s, of approach
/// Joints are springs of the frequency of fixed contacts, overdamped so that errors decay slowly.
constexpr Real joint_damping_ratio = 5;

/// A step is cut into sub-steps of h, each of them
///
///   kick     v += h a
///   warm     the impulses of the last sub-step again
///   press    contacts as soft constraints: velocities that correct positions too
///   drift    x += h v
///   relax    the same contacts rigid, with friction: removes the velocity that the soft constraints added
///
/// and at the end of the step restitution is applied once to the contacts that were hit. One iteration each: the small
/// steps converge ("small steps in physics simulation", Macklin et al. 2019), not iterations.
class SoftStep : public Solver {
 public:
  void step(StepData& data) override;
  void state(const Settings& settings, StatedErrors& errors) const override;
  bool contact_persistence() const override { return true; }
  Margin margin(const Settings& settings) const override { return {speculative, settings.dt}; }

 private:
  void prepare(StepData& data);
  void notice_approach(const BodySet& bodies);
  void share_impulses(StepData& data, Real by);
  void substep(StepData& data);
  void kick(BodySet& bodies) const;
  void warm_start(StepData& data);
  void press(StepData& data);
  void drift(StepData& data);
  void relax(StepData& data);
  void restitute(BodySet& bodies);

  /// Speed (m/s) of approach of a row's points at the start of the step; only of rows with restitution.
  struct Approach {
    std::size_t row = 0;
    std::array<Real, 2> speed{};
  };

  static Real frequency(const Settings& settings) {
    return std::min(highest_frequency, static_cast<Real>(settings.substeps) / (4 * settings.dt));
  }

  Real h_ = 0;
  Real per_h_ = 0;         // 1/h: multiplying is faster than dividing
  Softness soft_, stiff_;  // between movable bodies; against fixed ones
  Softness joint_;         // of joints
  std::vector<ContactRow> rows_;
  std::vector<Approach> approaches_;
  std::vector<Pose> start_;             // of each body
  std::vector<Motion> motion_;          // of each body since the start of the step
  std::vector<Velocity> acceleration_;  // of each body, by the force field
  bool forces_vary_ = false;            // within a step
};

void SoftStep::step(StepData& data) {
  prepare(data);
  end_stage("prepare");
  for (int i = 0; i < data.settings.substeps; ++i) substep(data);
  restitute(data.bodies);
  place(data.bodies, start_, motion_);
  end_stage("place");
  share_impulses(data, static_cast<Real>(data.settings.substeps));
  for (const ContactRow& row : rows_) store_row(row, data.contacts);
  end_stage("store");
}

/// Scales impulses between a whole step and a sub-step. They are stored per step, because the number of sub-steps may
/// change.
void SoftStep::share_impulses(StepData& data, Real by) {
  for (ContactRow& row : rows_) {
    for (RowPoint& p : row.points) {
      p.normal_impulse *= by;
      p.tangent_impulse *= by;
    }
  }
  for (ActiveJoint& joint : data.joints) {
    for_each_row(joint.block, [by](JointRow& row) { row.impulse *= by; });
  }
}

// A contact rests where its spring bears the load, at load / (m_eff w^2). For the two corners of a square on its like,
// each bears m g/2 and 1/m_eff = 2/m + 2 (a/2)^2/(m a^2/6) = 5/m: a depth of 2.5 g / w^2 for every body on top.
void SoftStep::state(const Settings& settings, StatedErrors& errors) const {
  const Real omega = 2 * pi * frequency(settings);
  errors.joints = true;
  errors.h = settings.dt / static_cast<Real>(settings.substeps);
  errors.drift = static_cast<Real>(.5);  // symplectic Euler
  errors.order = 1;
  errors.order_in_contact = 1;
  errors.impact_lag = static_cast<Real>(settings.substeps);
  errors.gap = static_cast<Real>(2.5) * length(settings.gravity) / (omega * omega);
  errors.joint_gap = errors.gap / 4;  // its joints are springs of twice the frequency
  errors.creep = 0;
  errors.restitution_threshold = restitution_threshold;
}

void SoftStep::prepare(StepData& data) {
  h_ = data.settings.dt / static_cast<Real>(data.settings.substeps);
  per_h_ = 1 / h_;
  soft_ = Softness::of(frequency(data.settings), damping_ratio, h_);
  stiff_ = Softness::of(2 * frequency(data.settings), damping_ratio, h_);
  joint_ = Softness::of(2 * frequency(data.settings), joint_damping_ratio, h_);
  start_ = data.bodies.pose;
  motion_.assign(data.bodies.size(), {});
  forces_vary_ = data.forces.vary(data.bodies);
  data.forces.accelerations(data.bodies, h_, acceleration_);
  prepare_rows(data.bodies, data.contacts, rows_);
  share_impulses(data, 1 / static_cast<Real>(data.settings.substeps));
  notice_approach(data.bodies);
}

void SoftStep::notice_approach(const BodySet& bodies) {
  approaches_.clear();
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const ContactRow& row = rows_[r];
    if (row.restitution == 0) continue;
    const ContactFrame frame(row, bodies.velocity[row.a], bodies.velocity[row.b]);
    approaches_.push_back({r, {-frame.normal_velocity(row.points[0]), -frame.normal_velocity(row.points[1])}});
  }
}

void SoftStep::substep(StepData& data) {
  kick(data.bodies);
  end_stage("kick");
  warm_start(data);
  end_stage("warm start");
  press(data);
  end_stage("press");
  drift(data);
  end_stage("drift");
  relax(data);
  end_stage("relax");
}

void SoftStep::kick(BodySet& bodies) const {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    bodies.velocity[i].v += h_ * acceleration_[i].v;
    bodies.velocity[i].w += h_ * acceleration_[i].w;
  }
}

void SoftStep::warm_start(StepData& data) {
  BodySet& bodies = data.bodies;
  for (const ActiveJoint& joint : data.joints) {
    impulse::warm_start(joint.block, 1, bodies.velocity[joint.block.a], bodies.velocity[joint.block.b]);
  }
  for (const ContactRow& row : rows_) {
    ContactFrame frame(row, bodies.velocity[row.a], bodies.velocity[row.b]);
    impulse::warm_start(row, frame);
    frame.write_back(row, bodies.velocity[row.a], bodies.velocity[row.b]);
  }
}

/// A gap may close within the sub-step, but no further; overlap is a soft constraint.
void SoftStep::press(StepData& data) {
  BodySet& bodies = data.bodies;
  for (ActiveJoint& joint : data.joints) solve_soft_joint(joint.block, h_, h_, joint_, bodies);
  for (ContactRow& row : rows_) {
    const Softness& soft = row.mass_a.m == 0 || row.mass_b.m == 0 ? stiff_ : soft_;
    ContactFrame frame(row, bodies.velocity[row.a], bodies.velocity[row.b]);
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      RowPoint& p = row.points[i];
      const Real s = separation(row, p, motion_[row.a], motion_[row.b]);
      const Real v = frame.normal_velocity(p);
      const Real push = s > 0 ? -p.normal_mass * (v + s * per_h_)
                              : -p.normal_mass * soft.mass_scale * (v + std::max(soft.bias_rate * s, -push_out_speed)) -
                                    soft.impulse_scale * p.normal_impulse;
      apply_accumulated(row, p, frame, std::max(p.normal_impulse + push, Real{0}));
    }
    frame.write_back(row, bodies.velocity[row.a], bodies.velocity[row.b]);
  }
}

void SoftStep::drift(StepData& data) {
  BodySet& bodies = data.bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    motion_[i].advance(bodies.velocity[i], h_);
  }
  const auto pose = [&](std::uint32_t body) {
    return JointPose{motion_[body].from(start_[body]), bodies.angle[body] + motion_[body].turn};
  };
  for (ActiveJoint& joint : data.joints) joint.model->write(pose(joint.block.a), pose(joint.block.b), joint.block);
  if (!forces_vary_) return;
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies.pose[i] = motion_[i].from(start_[i]);
  data.forces.accelerations(bodies, h_, acceleration_);
}

void SoftStep::relax(StepData& data) {
  BodySet& bodies = data.bodies;
  for (ActiveJoint& joint : data.joints) solve_joint(joint.block, h_, 0, bodies);
  for (ContactRow& row : rows_) {
    ContactFrame frame(row, bodies.velocity[row.a], bodies.velocity[row.b]);
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      RowPoint& p = row.points[i];
      const Real s = separation(row, p, motion_[row.a], motion_[row.b]);
      const Real push = -p.normal_mass * (frame.normal_velocity(p) + std::max(s, Real{0}) * per_h_);
      apply_accumulated(row, p, frame, std::max(p.normal_impulse + push, Real{0}));
      p.total_normal += p.normal_impulse;
    }
    solve_friction(row, frame);
    for (RowPoint& p : row.points) p.total_tangent += p.tangent_impulse;
    frame.write_back(row, bodies.velocity[row.a], bodies.velocity[row.b]);
  }
}

/// Newton's law for the points that were hit: those that approached faster than the threshold separate at e times that
/// speed. The sum of impulses stays >= 0. The warm start does not include this impulse, because the next step has no
/// such load.
void SoftStep::restitute(BodySet& bodies) {
  for (const Approach& approach : approaches_) {
    ContactRow& row = rows_[approach.row];
    ContactFrame frame(row, bodies.velocity[row.a], bodies.velocity[row.b]);
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      RowPoint& p = row.points[i];
      if (approach.speed[i] < restitution_threshold || p.total_normal == 0) continue;
      const Real wanted = p.normal_mass * (row.restitution * approach.speed[i] - frame.normal_velocity(p));
      const Real push = std::max(wanted, -p.normal_impulse);
      frame.push_normal(row, p, push);
      p.total_normal += push;
    }
    frame.write_back(row, bodies.velocity[row.a], bodies.velocity[row.b]);
  }
}

const MethodList<Solver>::Entry soft_step_entry{
    {"soft-step", "sub-steps of its own (symplectic Euler) with soft contacts and a rigid relaxing sweep",
     "E. Catto, Box2D v3 and Solver2D (2024); M. Macklin et al., Small steps in physics simulation (2019)"},
    [] { return std::make_unique<SoftStep>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
