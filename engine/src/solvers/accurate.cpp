#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <span>
#include <vector>

#include "contact_rows.h"
#include "islands.h"
#include "method_list.h"
#include "solver.h"
#include "solvers/energy_bound.h"
#include "solvers/impacts.h"
#include "solvers/island.h"
#include "stages.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// 1/s, at which the offset takes up a standing depth; 1 ... 4 are all stable, 2 settles soonest.
constexpr Real offset_rate = 2;
/// A contact's first steps are no standing load yet.
constexpr int offset_from_age = 2;

/// What one worker needs to itself.
struct Workspace {
  Impacts impacts;
  JointWorkspace joints;
  EnergyBound bound;
};

/// Share of its kinetic energy that an island with joints may seem to gain in a sub-step, because RATTLE's energy
/// swings about the true one; 1e-5 is seen of a pendulum, 1e-2 and more of chains too fast for the sub-step.
constexpr Real ideal_gain = static_cast<Real>(1e-4);

bool has_stops(const ActiveJoint* joint) { return joint->block.stops > 0 || joint->block.driven; }

/// The sub-step that makes flight and impacts exact to rounding. A step of dt is cut into N sub-steps of h, each
/// kick, press, drift, kick, relax:
///
///   impacts  events of contacts with restitution, at their own times (impacts.h)
///   kick     v += h/2 a, and half of the impulse that held the contact in the last sub-step
///   press    contacts as damped springs on the depth s: velocities that correct positions too
///   drift    x += h v
///   kick     the other halves, with the forces at the new place
///   relax    rigid contacts with friction: velocities keep no trace of the correction
///
/// Kick-drift-kick (velocity Verlet) is exact for a parabola and second order for any smooth force; that contacts, too,
/// give half their impulse before the drift and half after keeps a resting body where it is.
class Accurate : public Solver {
 public:
  void step(StepData& data) override;
  void state(const Settings& settings, StatedErrors& errors) const override {
    errors.h = settings.dt / static_cast<Real>(settings.substeps);
    errors.drift = 0;
    errors.impact_lag = 0;
    errors.gap = tolerated_sink;  // until the offset has taken it up
    errors.creep = 0;
    errors.joints = true;
    errors.restitution_threshold = slow_impact(length(settings.gravity), errors.h);
  }
  bool recycles() const override { return true; }
  /// Whatever may be hit within the step, gravity's part included.
  Margin margin(const Settings& settings) const override {
    return {static_cast<Real>(0.02) + 2 * length(settings.gravity) * settings.dt * settings.dt, settings.dt};
  }

 private:
  void prepare(StepData& data);
  template <class Items, class IslandOf>
  void find_starts(std::vector<std::size_t>& start, const Items& items, IslandOf island_of);
  void tie_islands(const StepData& data);
  Island island(StepData& data, std::size_t number, Workspace& space);
  void step_island(StepData& data, std::size_t number, Workspace& space);
  void fly(StepData& data, const Island& island);
  void substep(StepData& data, Island& island, Workspace& space);
  void find_impacts(StepData& data, Island& island, Impacts& impacts);
  void halve(Island& island) const;
  void kick(BodySet& bodies, Island& island);
  void press(BodySet& bodies, Island& island);
  void drift(StepData& data, const Island& island);
  void relax(BodySet& bodies, Island& island, int sweeps);
  void relax_until_bounded(StepData& data, Island& island, const EnergyBound& bound);
  bool solve_pair(const Island& island, ImpactRow& row, ContactFrame& frame, bool pressing) const;
  void turn_normal(ImpactRow& row) const;
  Real gap(const ImpactRow& row, const RowPoint& p) const {
    return separation(row, p, motion_[row.a], motion_[row.b]) - row.offset;
  }
  void note_loads(const Island& island);
  /// Only bodies that can be pushed: the others are shared among islands.
  template <class Tie>
  void note_load(const Tie& tie) {
    if (tie.mass_a.m + tie.mass_a.i > 0) loaded_[tie.a] = 1;
    if (tie.mass_b.m + tie.mass_b.i > 0) loaded_[tie.b] = 1;
  }
  void settle_offsets(const Island& island);

  Islands islands_;
  std::vector<ContactRow> plain_rows_;
  std::vector<ImpactRow> rows_;         // island by island
  std::vector<std::size_t> row_start_;  // of each island in rows_, and the end
  std::vector<ActiveJoint*> joints_;    // island by island
  std::vector<std::size_t> joint_start_;
  std::vector<std::size_t> next_;       // place of each island that is free, while items are put there
  std::vector<Motion> motion_;          // of each body since the start of the step
  std::vector<Pose> start_;             // of each body
  std::vector<Velocity> acceleration_;  // of each body, by the force field
  std::vector<Velocity> flight_;        // the same, but 0 for a body that rests on a contact
  std::vector<std::uint8_t> loaded_;    // a contact pushed the body in the last sub-step
  std::vector<std::uint8_t> crowd_;     // contacts of each movable body, up to 3
  bool forces_vary_ = false;            // within a step
  std::vector<Workspace> spaces_;       // of each worker
};

void Accurate::step(StepData& data) {
  prepare(data);
  end_stage("prepare");
  spaces_.resize(static_cast<std::size_t>(data.workers.count()));
  // Small islands are handed out in batches; an island's bits depend on nothing outside it.
  constexpr std::size_t batch = 32;
  const std::size_t batches = (islands_.size() + batch - 1) / batch;
  const auto step_batch = [&](std::size_t piece, std::size_t worker) {
    const std::size_t end = std::min((piece + 1) * batch, islands_.size());
    for (std::size_t number = piece * batch; number < end; ++number) step_island(data, number, spaces_[worker]);
  };
  data.workers.share_out(batches, std::ref(step_batch));  // a copy would ask for memory
  end_stage("islands");
  place(data.bodies, start_, motion_);
  end_stage("place");
}

void Accurate::step_island(StepData& data, std::size_t number, Workspace& space) {
  Island now = island(data, number, space);
  if (now.rows.empty() && now.joints.empty() && !forces_vary_) return fly(data, now);
  const auto substeps = static_cast<Real>(now.substeps);
  now.share(1 / substeps);
  now.joints.write();
  for (int i = 0; i < now.substeps; ++i) substep(data, now, space);
  settle_offsets(now);
  now.share(substeps);
  for (const ImpactRow& row : now.rows) {
    store_row(row, data.contacts);
    data.contacts[row.contact].offset = row.offset;
  }
}

/// Bodies that meet nothing under forces that stay the same: x += v t + a t^2/2 is exact, whatever the step.
void Accurate::fly(StepData& data, const Island& island) {
  const Real t = data.settings.dt;
  for (const std::uint32_t body : island.bodies) {
    Velocity& v = data.bodies.velocity[body];
    const Velocity& a = acceleration_[body];
    if (data.bodies.inverse_mass[body].m + data.bodies.inverse_mass[body].i == 0 && v.v == Vec2{} && v.w == 0) continue;
    motion_[body].advance({v.v + t / 2 * a.v, v.w + t / 2 * a.w}, t);
    v.v += t * a.v;
    v.w += t * a.w;
  }
}

void Accurate::substep(StepData& data, Island& island, Workspace& space) {
  if (island.bounces) find_impacts(data, island, space.impacts);
  halve(island);
  if (!island.joints.empty() || island.more_sweeps > 0) space.bound.note(island.bodies, data.bodies, motion_);
  kick(data.bodies, island);
  press(data.bodies, island);
  drift(data, island);
  const bool joints_fit = island.joints.fit();
  island.joints.write();
  kick(data.bodies, island);
  // An island that begins at rest finds its loads now instead of sinking until it has them.
  constexpr int settling_sweeps = 30;
  relax(data.bodies, island, island.settling ? std::max(settling_sweeps, island.sweeps) : island.sweeps);
  if (island.more_sweeps > 0) relax_until_bounded(data, island, space.bound);
  if (!joints_fit || island.ideal) {
    const bool slowed =
        space.bound.keep(island.bodies, data.bodies, motion_, acceleration_, joints_fit ? ideal_gain : Real{0});
    if (slowed && !joints_fit) island.joints.forget();
  }
  note_loads(island);
}

void Accurate::prepare(StepData& data) {
  BodySet& bodies = data.bodies;
  start_ = bodies.pose;
  motion_.assign(bodies.size(), {});
  loaded_.assign(bodies.size(), 0);
  crowd_.assign(bodies.size(), 0);
  forces_vary_ = data.forces.vary(bodies);
  data.forces.accelerations(bodies, data.settings.dt / static_cast<Real>(2 * data.settings.substeps), acceleration_);
  flight_ = acceleration_;

  prepare_rows(bodies, data.contacts, plain_rows_);
  for (const ContactRow& row : plain_rows_) {
    for (const std::uint32_t body : {row.a, row.b})
      crowd_[body] = static_cast<std::uint8_t>(std::min(crowd_[body] + 1, 3));
  }
  tie_islands(data);

  // Rows and joints keep their order within an island: a stable counting sort.
  const auto island_of = [&](const auto& tie) { return islands_.of(tie.mass_a.m + tie.mass_a.i > 0 ? tie.a : tie.b); };
  find_starts(row_start_, plain_rows_, island_of);
  rows_.resize(plain_rows_.size());
  for (const ContactRow& plain : plain_rows_) {
    ImpactRow& row = rows_[next_[island_of(plain)]++];
    static_cast<ContactRow&>(row) = plain;
    const Contact& contact = data.contacts[row.contact];
    row.offset = contact.offset;
    row.disc_distance = contact.discs ? contact.radius_a + contact.radius_b : Real{0};
    row.between = start_[row.b].p - start_[row.a].p;
    row.age = contact.age;
    row.fresh = contact.age == 0;
    row.active = true;
    // In columns the pair of points is solved as a block, which settles them sooner; in the web of a pyramid it harms.
    const bool column = (row.mass_a.m == 0 || crowd_[row.a] <= 2) && (row.mass_b.m == 0 || crowd_[row.b] <= 2);
    row.web = !column;
    row.block = column && row.count == 2;
    for (const RowPoint& p : row.points) {
      if (p.normal_impulse > 0) note_load(row);
    }
  }
  const auto joint_island = [&](const ActiveJoint& joint) { return island_of(joint.block); };
  find_starts(joint_start_, data.joints, joint_island);
  joints_.resize(data.joints.size());
  for (ActiveJoint& joint : data.joints) {
    joints_[next_[joint_island(joint)]++] = &joint;
  }
  for (const ActiveJoint& joint : data.joints) note_load(joint.block);
}

/// Where each island's items will start, and the end; `next_` gets the same as the first free places.
template <class Items, class IslandOf>
void Accurate::find_starts(std::vector<std::size_t>& start, const Items& items, IslandOf island_of) {
  start.assign(islands_.size() + 1, 0);
  for (const auto& item : items) ++start[island_of(item) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  next_.assign(start.begin(), start.end() - 1);
}

/// Bodies share an island if they touch and both move: such bodies must be stepped together. Where forces depend on
/// where bodies are, one island holds them all.
void Accurate::tie_islands(const StepData& data) {
  const BodySet& bodies = data.bodies;
  const auto moves = [&](std::uint32_t body) {
    const Velocity& v = bodies.velocity[body];
    return bodies.inverse_mass[body].m + bodies.inverse_mass[body].i > 0 || !(v.v == Vec2{} && v.w == 0);
  };
  islands_.clear(bodies.size());
  for (const ContactRow& row : plain_rows_) {
    if (moves(row.a) && moves(row.b)) islands_.tie(row.a, row.b);
  }
  for (const ActiveJoint& joint : data.joints) {
    if (moves(joint.block.a) && moves(joint.block.b)) islands_.tie(joint.block.a, joint.block.b);
  }
  if (forces_vary_) {
    for (std::uint32_t body = 1; body < bodies.size(); ++body) islands_.tie(0, body);
  }
  islands_.number();
}

Island Accurate::island(StepData& data, std::size_t number, Workspace& space) {
  const auto joints = std::span(joints_).subspan(joint_start_[number], joint_start_[number + 1] - joint_start_[number]);
  Island now{.bodies = islands_.bodies(number),
             .rows = std::span(rows_).subspan(row_start_[number], row_start_[number + 1] - row_start_[number]),
             .joints = IslandJoints(joints, islands_.bodies(number), data.bodies, start_, motion_, space.joints)};
  now.cut(data.settings.dt, substeps_for(now, data.bodies, acceleration_, data.settings));
  if (!joints.empty() && (!now.rows.empty() || std::any_of(joints.begin(), joints.end(), has_stops))) {
    now.sweeps = data.settings.iterations;
  }
  // A body that slides from one fixed shape to the next hands its load over at once, not in several sub-steps.
  if (now.bodies.size() == 1 && now.rows.size() > 1) now.sweeps = data.settings.iterations;
  // Nothing outside does work on it but the forces.
  const bool closed = !forces_vary_ && std::all_of(now.bodies.begin(), now.bodies.end(), [&](std::uint32_t body) {
    return data.bodies.inverse_mass[body].m + data.bodies.inverse_mass[body].i > 0;
  });
  now.ideal = !joints.empty() && closed &&
              std::none_of(joints.begin(), joints.end(), [](const ActiveJoint* joint) { return joint->block.driven; });
  now.bounces = std::any_of(now.rows.begin(), now.rows.end(), [](const ImpactRow& row) { return row.restitution > 0; });
  if (closed) now.more_sweeps = more_sweeps_for(now, data.bodies);
  const Real slow = 2 * length(data.settings.gravity) * data.settings.dt;
  now.settling = !now.rows.empty() &&
                 std::all_of(now.rows.begin(), now.rows.end(), [](const ImpactRow& row) { return row.fresh; }) &&
                 std::all_of(now.bodies.begin(), now.bodies.end(), [&](std::uint32_t body) {
                   const Velocity& v = data.bodies.velocity[body];
                   return length(v.v) + std::abs(v.w) * data.bodies.reach[body] <= slow;
                 });
  return now;
}

void Accurate::find_impacts(StepData& data, Island& island, Impacts& impacts) {
  Real pressing = 0;  // m/s^2
  for (const std::uint32_t body : island.bodies) {
    flight_[body] = loaded_[body] != 0 ? Velocity{} : acceleration_[body];
    pressing = std::max(pressing, length(acceleration_[body].v));
  }
  impacts.resolve(island.rows, island.joints, island.bodies, data.bodies, motion_, flight_, island.h,
                  slow_impact(pressing, island.h));
}

/// What the contacts bore in the last sub-step is given again, half in each kick.
void Accurate::halve(Island& island) const {
  island.joints.halve();
  for (ImpactRow& row : island.rows) {
    for (std::size_t i = 0; i < 2; ++i) {
      RowPoint& p = row.points[i];
      row.half[i] = row.active ? Vec2{p.normal_impulse / 2, p.tangent_impulse / 2} : Vec2{};
      p.normal_impulse = 0;
      p.tangent_impulse = 0;
    }
  }
}

/// Half of the forces, half of the contacts' last impulses.
void Accurate::kick(BodySet& bodies, Island& island) {
  for (const std::uint32_t body : island.bodies) {
    bodies.velocity[body].v += island.h / 2 * acceleration_[body].v;
    bodies.velocity[body].w += island.h / 2 * acceleration_[body].w;
  }
  for (ImpactRow& row : island.rows) {
    if (!row.active) continue;
    ContactFrame frame(row, bodies.velocity[row.a], bodies.velocity[row.b]);
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      RowPoint& p = row.points[i];
      frame.push_normal(row, p, row.half[i].x);
      frame.push_tangent(row, p, row.half[i].y);
      p.normal_impulse += row.half[i].x;
      p.tangent_impulse += row.half[i].y;
    }
    frame.leave(row, bodies.velocity[row.a], bodies.velocity[row.b]);
  }
  island.joints.kick();
}

void Accurate::turn_normal(ImpactRow& row) const {
  if (row.disc_distance == 0) return;
  row.normal = normalized(row.between + (motion_[row.b].d - motion_[row.a].d));
  // gap() measures along the normal from `between`: for discs that is their distance less the radii.
  row.points[0].separation = dot(row.normal, row.between) - row.disc_distance;
}

/// Contacts give way as damped springs; a gap that would close within the sub-step is closed just so far. Friction
/// waits for the rigid pass, except in a contact's first step (else a box set down on a slope slips before it is held).
void Accurate::press(BodySet& bodies, Island& island) {
  for (int sweep = 0; sweep < island.sweeps; ++sweep) {
    island.joints.press(island.h);
    for (ImpactRow& row : island.rows) {
      if (!row.active) continue;
      turn_normal(row);
      const Softness& soft = island.softness(row);
      ContactFrame frame(row, bodies.velocity[row.a], bodies.velocity[row.b]);
      if (!row.block || !solve_pair(island, row, frame, true)) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
          RowPoint& p = row.points[i];
          const Real s = gap(row, p);
          const Real v = frame.normal_velocity(p);
          const Real push = s > 0
                                ? -p.normal_mass * (v + s / island.h)
                                : -p.normal_mass * soft.strength * (v + soft.rate * s) - soft.relief * p.normal_impulse;
          push_to(row, p, frame, std::max(p.normal_impulse + push, Real{0}));
        }
      }
      if (row.fresh) rub(row, frame);
      frame.leave(row, bodies.velocity[row.a], bodies.velocity[row.b]);
    }
  }
}

/// Rigid contacts with friction, no memory of depth. What has a gap and no load is left alone: it would be braked one
/// sub-step before it arrives.
void Accurate::relax(BodySet& bodies, Island& island, int sweeps) {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    island.joints.relax(island.h);
    for (ImpactRow& row : island.rows) {
      if (!row.active) continue;
      turn_normal(row);
      ContactFrame frame(row, bodies.velocity[row.a], bodies.velocity[row.b]);
      if (!row.block || !solve_pair(island, row, frame, false)) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
          RowPoint& p = row.points[i];
          if (p.normal_impulse == 0 && gap(row, p) > 0) continue;
          const Real push = -p.normal_mass * frame.normal_velocity(p);
          push_to(row, p, frame, std::max(p.normal_impulse + push, Real{0}));
        }
      }
      rub(row, frame);
      frame.leave(row, bodies.velocity[row.a], bodies.velocity[row.b]);
    }
  }
}

/// The impulses of press and relax together are those of an impact without rebound, which takes energy, once relax has
/// converged: until then some of the speed that only parts the bodies is left in them.
void Accurate::relax_until_bounded(StepData& data, Island& island, const EnergyBound& bound) {
  const Real rounding = 64 * std::numeric_limits<Real>::epsilon();
  for (int sweep = 0; sweep < island.more_sweeps; ++sweep) {
    if (!bound.exceeded(island.bodies, data.bodies, motion_, acceleration_, rounding)) return;
    relax(data.bodies, island, 1);
  }
}

/// Both points at once: (K + G) d = -(v + bias + G lambda) with G the springs' give; nothing if a point would pull.
bool Accurate::solve_pair(const Island& island, ImpactRow& row, ContactFrame& frame, bool pressing) const {
  const Softness& soft = island.softness(row);
  std::array<Real, 2> give{};
  std::array<Real, 2> bias{};
  for (std::size_t i = 0; i < 2; ++i) {
    const RowPoint& p = row.points[i];
    const Real s = gap(row, p);
    if (pressing) {
      give[i] = s > 0 ? Real{0} : (1 / soft.strength - 1) / p.normal_mass;
      bias[i] = s > 0 ? s / island.h : soft.rate * s;
    } else if (p.normal_impulse == 0 && s > 0) {
      return false;
    }
  }
  RowPoint& p = row.points[0];
  RowPoint& q = row.points[1];
  const Real k11 = 1 / p.normal_mass + give[0];
  const Real k22 = 1 / q.normal_mass + give[1];
  const Real k12 =
      row.mass_a.m + row.mass_b.m + row.mass_a.i * p.cross_a * q.cross_a + row.mass_b.i * p.cross_b * q.cross_b;
  const Mat22 k({k11, k12}, {k12, k22});
  // Two points almost in one place: the matrix says nothing about the difference of their loads.
  constexpr Real worst_condition = 1000;
  if (k11 * k22 > worst_condition * k.determinant()) return false;
  const Vec2 change = k.solve({-(frame.normal_velocity(p) + bias[0] + give[0] * p.normal_impulse),
                               -(frame.normal_velocity(q) + bias[1] + give[1] * q.normal_impulse)});
  const Vec2 total = Vec2{p.normal_impulse, q.normal_impulse} + change;
  if (total.x < 0 || total.y < 0) return false;
  push_to(row, p, frame, total.x);
  push_to(row, q, frame, total.y);
  return true;
}

void Accurate::drift(StepData& data, const Island& island) {
  BodySet& bodies = data.bodies;
  for (const std::uint32_t body : island.bodies) {
    const Velocity& v = bodies.velocity[body];
    motion_[body].d += island.h * v.v;
    motion_[body].turn_by(island.h * v.w);
  }
  if (!forces_vary_) return;
  for (const std::uint32_t body : island.bodies) {
    bodies.pose[body] = motion_[body].from(start_[body]);
  }
  data.forces.accelerations(bodies, island.h / 2, acceleration_);
}

void Accurate::note_loads(const Island& island) {
  for (const std::uint32_t body : island.bodies) loaded_[body] = 0;
  for (const ActiveJoint* joint : island.joints.all()) note_load(joint->block);
  for (ImpactRow& row : island.rows) {
    for (RowPoint& p : row.points) {
      p.total_normal += p.normal_impulse;
      p.total_tangent += p.tangent_impulse;
      if (p.normal_impulse > 0) note_load(row);
    }
  }
}

/// A standing load presses its springs in. The offset, one for both points of a contact (one each would take away the
/// stiffness that keeps a column upright), slowly moves the springs' rest length until the surfaces just touch; it
/// never exceeds the depth that the load explains, load / (2 m_eff w^2), and goes with the load.
void Accurate::settle_offsets(const Island& island) {
  for (ImpactRow& row : island.rows) {
    const Real omega = island.softness(row).omega;
    Real speed = 0;  // lambda / m_eff
    Real depth = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      const RowPoint& p = row.points[i];
      speed += p.normal_impulse / p.normal_mass;
      depth -= separation(row, p, motion_[row.a], motion_[row.b]);
    }
    const Real points = static_cast<Real>(row.count);
    const Real explained = speed / points / (2 * island.h * omega * omega);
    if (island.settling) {
      row.offset = explained;
    } else if (row.age >= offset_from_age) {
      constexpr Real headroom = static_cast<Real>(1.05);
      row.offset = clamp(row.offset + offset_rate * island.h * static_cast<Real>(island.substeps) * depth / points, 0,
                         headroom * explained);
    }
  }
}

const MethodList<Solver>::Entry entry{
    {"accurate", "sub-steps by kick, press, drift, kick, relax; impacts at their own times; loads without sinking",
     "soft contacts and relaxation after E. Catto, Soft Constraints (GDC 2011) and Solver2D (2024); velocity Verlet; "
     "time-of-impact events"},
    [] { return std::make_unique<Accurate>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
