#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "contacts/contact_rows.h"
#include "core/method_list.h"
#include "methods/position_correction.h"
#include "solver/motion.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr Real kept_gap = static_cast<Real>(.02);  // m, gap up to which a pair is considered in the sub-steps

/// A row with the approach speed of its points in this sub-step, before anything is solved.
struct PositionRow : ContactRow {
  std::array<Real, 2> approach{};  // m/s
};

/// Extended position-based dynamics: positions are solved, velocities follow from them. A step is cut into sub-steps
/// of h, each of them
///
///   drift       v += h a, x += h v
///   positions   sliding is undone where static friction holds, and overlap is removed
///   velocities  v = (x - x before) / h
///   impacts     restitution and friction on those velocities
///
/// one iteration each. Lambda, the positional impulse (kg m), is h times an impulse; rows hold it divided by h, in N s.
/// All contacts are rigid: the compliance of the paper is 0.
class Xpbd : public Solver {
 public:
  void step(StepData& data) override;
  void state(const Settings& settings, StatedErrors& errors) const override;
  Margin margin(const Settings& settings) const override { return {kept_gap, settings.dt}; }

 private:
  void prepare(StepData& data);
  void substep(StepData& data);
  void drift(StepData& data);
  void note_approach(const BodySet& bodies);
  void solve_positions(StepData& data);
  void hold(PositionRow& row);
  void part(PositionRow& row);
  void move(const ContactRow& row, Vec2 impulse, Real turn_a, Real turn_b);
  void derive_velocities(BodySet& bodies) const;
  void solve_velocities(BodySet& bodies);

  Real h_ = 0;
  Real inelastic_ = 0;  // m/s, slower impacts have no restitution
  std::vector<ContactRow> plain_rows_;
  std::vector<PositionRow> rows_;
  std::vector<Pose> start_;
  std::vector<Real> start_angle_;
  std::vector<Motion> motion_;  // of each body since the start of the step
  std::vector<Motion> before_;  // the same at the start of the sub-step
  std::vector<Velocity> acceleration_;
  bool forces_vary_ = false;
};

/// The paper's threshold: two sub-steps of gravity.
Real inelastic_speed(const Settings& settings) {
  return 2 * length(settings.gravity) * settings.dt / static_cast<Real>(settings.substeps);
}

void Xpbd::step(StepData& data) {
  prepare(data);
  for (int i = 0; i < data.settings.substeps; ++i) substep(data);
  place(data.bodies, start_, motion_);
  for (PositionRow& row : rows_) {
    for (RowPoint& p : row.points) p.normal_impulse *= static_cast<Real>(data.settings.substeps);
    store_row(row, data.contacts);
  }
}

// In each sub-step a body falls g h^2, and its contact removes its share: between equal bodies half of their overlap p,
// so p = 2 g h^2 for every body on top; for the corners of squares, each of which bears half at 1/m_eff = 5/m,
// 2.5 g h^2.
void Xpbd::state(const Settings& settings, StatedErrors& errors) const {
  errors.h = settings.dt / static_cast<Real>(settings.substeps);
  errors.drift = static_cast<Real>(.5);  // symplectic Euler
  errors.order = 1;
  errors.order_in_contact = 1;
  errors.gap = static_cast<Real>(2.5) * length(settings.gravity) * errors.h * errors.h;
  errors.joint_gap = errors.gap;  // found once per sub-step, like a contact
  // A point that static friction alone cannot hold slides for the sub-step at the speed that gravity gives it.
  errors.creep = length(settings.gravity) * errors.h;
  errors.restitution_threshold = inelastic_speed(settings);
  errors.joints = true;
}

void Xpbd::prepare(StepData& data) {
  h_ = data.settings.dt / static_cast<Real>(data.settings.substeps);
  inelastic_ = inelastic_speed(data.settings);
  start_ = data.bodies.pose;
  start_angle_ = data.bodies.angle;
  motion_.assign(data.bodies.size(), {});
  forces_vary_ = data.forces.vary(data.bodies);
  data.forces.accelerations(data.bodies, h_, acceleration_);
  prepare_rows(data.bodies, data.contacts, plain_rows_);
  rows_.clear();
  for (const ContactRow& plain : plain_rows_) {
    PositionRow& row = rows_.emplace_back(PositionRow{plain, {}});
    for (RowPoint& p : row.points) p.normal_impulse /= static_cast<Real>(data.settings.substeps);
  }
}

void Xpbd::substep(StepData& data) {
  drift(data);
  solve_positions(data);
  derive_velocities(data.bodies);
  solve_velocities(data.bodies);
}

void Xpbd::drift(StepData& data) {
  BodySet& bodies = data.bodies;
  before_ = motion_;
  if (forces_vary_) {
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies.pose[i] = motion_[i].from(start_[i]);
    data.forces.accelerations(bodies, h_, acceleration_);
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    bodies.velocity[i].v += h_ * acceleration_[i].v;
    bodies.velocity[i].w += h_ * acceleration_[i].w;
  }
  note_approach(bodies);
  for (std::size_t i = 0; i < bodies.size(); ++i) motion_[i].advance(bodies.velocity[i], h_);
}

void Xpbd::note_approach(const BodySet& bodies) {
  for (PositionRow& row : rows_) {
    if (row.restitution == 0) continue;
    const ContactFrame frame(row, bodies.velocity[row.a], bodies.velocity[row.b]);
    for (std::size_t i = 0; i < 2; ++i) row.approach[i] = -frame.normal_velocity(row.points[i]);
  }
}

void Xpbd::solve_positions(StepData& data) {
  for (const ActiveJoint& joint : data.joints) {
    close_joint(joint, {start_, start_angle_}, motion_[joint.block.a], motion_[joint.block.b]);
  }
  for (PositionRow& row : rows_) hold(row);
  for (PositionRow& row : rows_) part(row);
}

/// Undoes the sliding of each point in this sub-step if static friction holds: |lambda_t| < mu_s lambda_n, with the
/// normal impulse of the last sub-step. The paper does this contact by contact, after `part`; but that opens and closes
/// gaps that were just corrected, their removal becomes velocity, and a stack of three does not come to rest.
void Xpbd::hold(PositionRow& row) {
  const Vec2 tangent = perpendicular(row.normal);
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
    RowPoint& p = row.points[i];
    p.tangent_impulse = 0;
    if (p.normal_impulse == 0) continue;
    const Motion& a = motion_[row.a];
    const Motion& b = motion_[row.b];
    const Vec2 d = (b.d - before_[row.b].d) - (a.d - before_[row.a].d);
    const Real slid =
        dot(tangent, d) + (b.turn - before_[row.b].turn) * p.dot_b - (a.turn - before_[row.a].turn) * p.dot_a;
    const Real lambda = -p.tangent_mass * slid;
    if (std::abs(lambda) >= row.static_friction * p.normal_impulse * h_) continue;
    move(row, lambda * tangent, lambda * p.dot_a, lambda * p.dot_b);
    p.tangent_impulse = lambda / h_;
  }
}

/// Section 3.5 of the paper: removes all overlap of each point.
void Xpbd::part(PositionRow& row) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
    RowPoint& p = row.points[i];
    p.normal_impulse = 0;
    const Real s = separation(row, p, motion_[row.a], motion_[row.b]);
    if (s >= 0) continue;
    const Real lambda = -p.normal_mass * s;
    move(row, lambda * row.normal, lambda * p.cross_a, lambda * p.cross_b);
    p.normal_impulse = lambda / h_;
  }
}

void Xpbd::move(const ContactRow& row, Vec2 impulse, Real turn_a, Real turn_b) {
  motion_[row.a].d -= row.mass_a.m * impulse;
  motion_[row.a].turn_by(-row.mass_a.i * turn_a);
  motion_[row.b].d += row.mass_b.m * impulse;
  motion_[row.b].turn_by(row.mass_b.i * turn_b);
}

void Xpbd::derive_velocities(BodySet& bodies) const {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies.inverse_mass[i].m > 0) bodies.velocity[i].v = (motion_[i].d - before_[i].d) / h_;
    if (bodies.inverse_mass[i].i > 0) bodies.velocity[i].w = (motion_[i].turn - before_[i].turn) / h_;
  }
}

/// Section 3.6: points that pushed get exactly e times their approach, which removes the velocity added by removing
/// overlap; then friction. Its cone is that of all normal impulses of the sub-step. The paper has one cone for static
/// friction, from lambda_n, and a second for dynamic friction, which together allow twice Coulomb's limit, and neither
/// includes the impulses of this pass.
void Xpbd::solve_velocities(BodySet& bodies) {
  for (PositionRow& row : rows_) {
    ContactFrame frame(row, bodies.velocity[row.a], bodies.velocity[row.b]);
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      RowPoint& p = row.points[i];
      if (p.normal_impulse > 0) {
        const Real wanted = row.approach[i] > inelastic_ ? row.restitution * row.approach[i] : Real{0};
        const Real push = p.normal_mass * (wanted - frame.normal_velocity(p));
        frame.push_normal(row, p, push);
        p.total_normal += p.normal_impulse + push;
        p.normal_impulse = std::max(p.normal_impulse + push, Real{0});
      }
      const Real stopping = p.tangent_impulse - p.tangent_mass * frame.tangent_velocity(p);
      const Real held = within_cone(row, stopping, p.normal_impulse);
      frame.push_tangent(row, p, held - p.tangent_impulse);
      p.tangent_impulse = held;
      p.total_tangent += held;
    }
    frame.write_back(row, bodies.velocity[row.a], bodies.velocity[row.b]);
  }
}

const MethodList<Solver>::Entry xpbd_entry{
    {"xpbd", "sub-steps of its own (symplectic Euler) that solve positions; velocities follow from them",
     "M. Mueller et al., Detailed Rigid Body Simulation with Extended Position Based Dynamics (2020)"},
    [] { return std::make_unique<Xpbd>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
