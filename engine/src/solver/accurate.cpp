#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "contacts/contact_rows.h"
#include "core/method_list.h"
#include "core/stages.h"
#include "solver/colouring.h"
#include "solver/direct_island.h"
#include "solver/energy_bound.h"
#include "solver/impacts.h"
#include "solver/island.h"
#include "solver/partition.h"
#include "solver/pile.h"
#include "solver/press_and_relax.h"
#include "solver/resting_piles.h"
#include "solver/scalar_contacts.h"
#include "solver/solver.h"
#include "solver/turning.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// The working storage of one worker.
struct Workspace {
  Impacts impacts;
  JointWorkspace joints;
  EnergyBound bound;
  Pile pile{solver_kernels()};
  Pile::RowOf row_of;
  Colouring colouring;
  Turning turning;
  Unpushed unpushed;
  PressAndRelax::Storage solves;
  std::vector<Island> alike;  // waiting to be stepped as one
  DirectIsland direct;
};

/// Fraction of its kinetic energy that an island with joints may gain in a sub-step, because RATTLE's energy oscillates
/// about the true one: 1e-5 for a pendulum, 1e-2 and more for chains too fast for the sub-step.
constexpr Real ideal_gain = static_cast<Real>(1e-4);

/// Most contacts of an island that is solved as one system in a blow: its cost grows with their third power.
constexpr std::size_t most_solved = 12;
/// Most contacts of an island that is solved as one system, and most joints. In single precision, rounding leaves more
/// of gaps than Newton's method can tell from an overlap.
constexpr std::size_t most_direct = sizeof(Real) == 8 ? 24 : 0;

/// Most contacts of islands that are stepped as one: their rows stay in the first-level cache.
constexpr std::size_t most_together = 64;

bool driven(const IslandJoints& joints) {
  return std::any_of(joints.all().begin(), joints.all().end(),
                     [](const ActiveJoint* joint) { return joint->block.driven; });
}
bool has_stops(const IslandJoints& joints) {
  return driven(joints) || std::any_of(joints.all().begin(), joints.all().end(),
                                       [](const ActiveJoint* joint) { return joint->block.stops > 0; });
}

/// Whether one of the two is a disc and the other stands still: then no rotation by friction changes the gap.
bool rolls(const Contact& contact, const ImpactRow& row) {
  return (contact.disc_a && !row.stirs_b) || (contact.disc_b && !row.stirs_a);
}

/// From the start of one span to the end of a later one.
template <class T>
std::span<T> from_to(std::span<T> first, std::span<T> last) {
  return {first.data(), last.data() + last.size()};
}

/// The default method, which makes flight and impacts exact up to rounding. A step of dt is divided into N sub-steps of
/// h, each kick, press, drift, kick, relax:
///
///   impacts  of contacts with restitution, at their own times (impacts.h)
///   kick     integrate velocities: v += h/2 a, and half of the contact impulses of the last sub-step
///   press    solve with bias, contacts as soft constraints: velocities that correct positions too
///   drift    integrate positions: x += h v
///   kick     the other halves, with the forces at the new positions
///   relax    solve rigid contacts with friction: removes the velocity of the correction
///
/// Kick-drift-kick (velocity Verlet) is exact for a parabola and second order for any smooth force; applying contact
/// impulses half before and half after the drift, too, keeps a resting body where it is.
class Accurate : public Solver {
 public:
  explicit Accurate(bool lanes) : lanes_(lanes) {}
  void step(StepData& data) override;
  void state(const Settings& settings, StatedErrors& errors) const override {
    errors.h = settings.dt / static_cast<Real>(settings.substeps);
    errors.drift = 0;
    errors.order = 2;
    errors.order_in_contact = 2;
    errors.impact_lag = 0;
    errors.gap = tolerated_sink;  // until the offset has corrected it
    errors.joint_gap = tolerated_joint_gap;
    errors.creep = 0;
    errors.joints = true;
    errors.joint_omega = softness_of_swept(errors.h).omega;
    errors.restitution_threshold = slow_impact(length(settings.gravity), errors.h);
  }
  bool contact_persistence() const override { return true; }
  RestingPiles* resting() override { return lanes_ ? &resting_ : nullptr; }
  /// Everything that may be hit within the step, including the effect of gravity.
  Margin margin(const Settings& settings) const override {
    return {static_cast<Real>(0.02) + 2 * length(settings.gravity) * settings.dt * settings.dt, settings.dt};
  }

 private:
  void prepare(StepData& data);
  Island island(StepData& data, std::size_t number, Workspace& space);
  void make_rows(StepData& data, Island& island, std::size_t number);
  void step_island(StepData& data, std::size_t number, Workspace& space);
  void step_pile(StepData& data, std::size_t number, Island& island, Workspace& space);
  void step_alike(StepData& data, Workspace& space);
  void fly(StepData& data, const Island& island);
  void fly_all(StepData& data);
  void substep(StepData& data, Island& island, Workspace& space);
  void find_collisions(const StepData&, Island&);
  Real find_impacts(StepData& data, Island& island, Workspace& space);
  bool hold_those_that_meet(StepData& data, Island& island, Workspace& space);
  /// m/s^2, the largest acceleration of a body by forces.
  Real pressing(const Island& island) const;
  void kick(BodySet& bodies, Island& island);
  void drift(StepData& data, const Island& island);
  void note_loads(const Island& island);
  /// Marks only bodies that can be pushed: the others are shared among islands.
  void note_load(const ImpactRow& row) {
    if (pushable(row.mass_a)) loaded_[row.a] = 1;
    if (pushable(row.mass_b)) loaded_[row.b] = 1;
  }
  void note_load(const JointBlock& block) {
    if (pushable(block.inv_mass_a)) loaded_[block.a] = 1;
    if (pushable(block.inv_mass_b)) loaded_[block.b] = 1;
  }

  std::vector<std::uint32_t> meets_;  // by body: its contacts and joints, in an island
  bool lanes_;                        // large islands are solved by kernels
  Partition parts_;
  RestingPiles resting_;
  std::vector<std::unique_ptr<RestingPile>> begun_;  // in this step, of each island
  std::uint64_t contact_changes_ = 0;                // when rows were made
  std::vector<ImpactRow> rows_;                      // island by island; those of persistent contacts are kept
  std::vector<Motion> motion_;                       // of each body since the start of the step
  std::vector<Pose> start_;                          // of each body
  std::vector<Velocity> acceleration_;               // of each body, by the force field
  std::vector<Velocity> flight_;                     // the same, but 0 for a body that rests on a contact
  std::vector<Velocity> kicks_;                      // of each body, see ScalarContacts::halve
  std::vector<Velocity> held_;                       // of each body, half a sub-step later but for forces
  std::vector<Velocity> later_;                      // of each body, half a sub-step later
  std::vector<Velocity> changes_;                    // of each body, see LineSearch
  std::vector<std::uint8_t> loaded_;                 // a contact pushed the body in the last sub-step
  std::vector<Workspace> spaces_;                    // of each worker
};

void Accurate::step(StepData& data) {
  const bool free = data.contacts.empty() && data.joints.empty() && resting_.empty();
  if (free && !data.forces.vary(data.bodies)) return fly_all(data);
  prepare(data);
  end_stage("prepare");
  const auto workers = static_cast<std::size_t>(data.workers.count());
  if (spaces_.size() != workers) spaces_.clear();
  while (spaces_.size() < workers) spaces_.emplace_back();
  // Small islands are distributed in batches; an island's bits do not depend on others.
  constexpr std::size_t batch = 32;
  const std::size_t batches = (parts_.size() + batch - 1) / batch;
  const auto step_batch = [&](std::size_t piece, std::size_t worker) {
    const std::size_t end = std::min((piece + 1) * batch, parts_.size());
    for (std::size_t number = piece * batch; number < end; ++number) step_island(data, number, spaces_[worker]);
    step_alike(data, spaces_[worker]);
  };
  data.workers.share_out(batches, std::ref(step_batch));  // a copy would allocate memory
  for (Workspace& space : spaces_) {
    if (space.turning.counts_changed()) parts_.forget_points();
    if (space.direct.counts_changed()) parts_.forget_points();
  }
  for (std::unique_ptr<RestingPile>& pile : begun_) {
    if (pile != nullptr) resting_.add(std::move(pile), data.bodies);
  }
  end_stage("islands");
  place(data.bodies, start_, motion_);
  end_stage("place");
}

void Accurate::step_island(StepData& data, std::size_t number, Workspace& space) {
  Island now = island(data, number, space);
  if (RestingPile* pile = resting_.of(data.bodies, now.bodies)) {
    pile->step(data, parts_, now, acceleration_, motion_, space.row_of);
    if (resting_.may_grow(data, now, *pile)) pile->begin_anew();
    return;
  }
  if (now.contacts.empty() && now.joints.empty() && !now.varies) return fly(data, now);
  if (now.contacts.size() <= most_direct && now.joints.all().size() <= most_direct && !now.joints.swept()) {
    DirectStep step{data, start_, motion_, acceleration_, flight_, later_, held_};
    space.direct.step(step, {now.bodies, now.contacts, now.joints.all(), now.pulls, now.varies});
    for (std::size_t i = 0; i < now.contacts.size(); ++i) rows_[parts_.first_contact(number) + i].made = false;
    return;
  }
  now.pile = !now.varies && is_pile(data, now);
  if (now.pile) {
    if (lanes_) return step_pile(data, number, now, space);
    space.colouring.assign(parts_, now, 1);
    now.contacts = space.colouring.order();
  }
  make_rows(data, now, number);
  if (!space.alike.empty()) {
    const Island& first = space.alike.front();
    const Island& last = space.alike.back();
    const bool goes_on = plain(now) && now.substeps == last.substeps && now.varies == last.varies &&
                         now.bodies.data() == last.bodies.data() + last.bodies.size() &&
                         now.rows.data() == last.rows.data() + last.rows.size();
    if (!goes_on || from_to(first.rows, now.rows).size() > most_together) step_alike(data, space);
  }
  space.alike.push_back(now);
  if (!plain(now)) step_alike(data, space);
}

void Accurate::step_pile(StepData& data, std::size_t number, Island& island, Workspace& space) {
  plan_pile(data, island, acceleration_);
  std::unique_ptr<RestingPile>& begun = begun_[number];
  begun = resting_.part_at_rest(data, parts_, island, space.row_of);
  if (begun == nullptr) return step_as_pile(data, parts_, island, acceleration_, motion_, space.pile, space.row_of);
  island.contacts = begun->others();
  begun->step(data, parts_, island, acceleration_, motion_, space.row_of);
}

/// Steps consecutive islands with the same number of sub-steps as if they were one, which changes no bit: they are
/// independent, so a processor overlaps their computations.
void Accurate::step_alike(StepData& data, Workspace& space) {
  if (space.alike.empty()) return;
  Island all = space.alike.front();
  all.bodies = from_to(all.bodies, space.alike.back().bodies);
  all.rows = from_to(all.rows, space.alike.back().rows);
  all.pulls = from_to(all.pulls, space.alike.back().pulls);
  const auto substeps = static_cast<Real>(all.substeps);
  all.share(1 / substeps);
  for (const Island& one : space.alike) {
    if (one.webbed) all.web = one.web;
  }
  if (!all.joints.empty()) all.joints.write();
  space.turning.begin(all, data);
  for (int i = 0; i < all.substeps; ++i) substep(data, all, space);
  for (const Island& one : space.alike) {
    if (!one.settling) ScalarContacts(data.bodies, motion_).settle_offsets(one);
  }
  all.share(substeps);
  for (ImpactRow& row : all.rows) write_back(row, all.offset_scale, data.contacts);
  space.alike.clear();
}

/// Free flight under constant forces: x += v t + a t^2/2 is exact, whatever the step.
void Accurate::fly(StepData& data, const Island& island) {
  const Real t = data.settings.dt;
  for (const std::uint32_t body : island.bodies) {
    if (data.bodies.moves(body)) motion_[body].advance(flown(data.bodies.velocity[body], acceleration_[body], t), t);
  }
}

/// A step without contacts and joints: the same, to the bit, without islands.
void Accurate::fly_all(StepData& data) {
  BodySet& bodies = data.bodies;
  const Real t = data.settings.dt;
  data.forces.accelerations(bodies, 0, acceleration_);
  motion_.assign(bodies.size(), {});
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies.moves(i)) continue;
    const Velocity mean = flown(bodies.velocity[i], acceleration_[i], t);
    motion_[i].d = t * mean.v;
    motion_[i].turn = t * mean.w;
  }
  place(bodies, bodies.pose, motion_);
}

void Accurate::substep(StepData& data, Island& island, Workspace& space) {
  space.turning.find_again(data, start_, motion_);
  Real hit_at = 0;
  if (island.bounces) {
    space.turning.follow(island, motion_);
    hit_at = find_impacts(data, island, space);
  }
  space.turning.lead(island, data.bodies, motion_);
  if (!island.joints.empty()) island.joints.halve();
  if (island.two_frictions) ScalarContacts(data.bodies, motion_).meet(island, slow_impact(pressing(island), island.h));
  ScalarContacts::halve(island, kicks_);
  if (!island.joints.empty() || island.more_sweeps > 0) space.bound.note(island.bodies, data.bodies, motion_);
  if (island.press_sweeps > 0) space.unpushed.note(island, data.bodies, acceleration_);
  kick(data.bodies, island);
  PressAndRelax solve(data.bodies, island, motion_, changes_, space.solves);
  solve.press(false);
  if (island.bounces && hold_those_that_meet(data, island, space)) solve.press(false);
  const int pressed = solve.press_through();
  drift(data, island);
  const bool joints_fit = island.joints.fit();
  if (!island.joints.empty()) island.joints.write();
  kick(data.bodies, island);
  const bool borne = island.single && hit_at > 0;
  if (borne) ScalarContacts(data.bodies, motion_).keep_borne(island, hit_at / island.h);
  solve.relax(island.settling ? std::max(settling_sweeps_for(island.bodies.size()), island.sweeps)
                              : island.sweeps + pressed);
  solve.relax_through();
  if (island.two_frictions && ScalarContacts::stick_or_slip(island)) solve.relax(island.sweeps);
  if (island.more_sweeps > 0) solve.relax_until_bounded(space.bound, acceleration_);
  ScalarContacts(data.bodies, motion_).turn_back(island);
  if (!joints_fit || island.ideal) {
    // Compliant joints must return their energy as height, not as speed.
    const Real gain = joints_fit && !island.joints.swept() ? ideal_gain : Real{0};
    const bool slowed = space.bound.keep(island.bodies, island.held, data.bodies, motion_, acceleration_, gain);
    if (slowed && !joints_fit) island.joints.forget();
  }
  if (island.settling) ScalarContacts(data.bodies, motion_).settle_offsets(island);
  note_loads(island);
  if (island.press_sweeps > 0 && !island.varies && !borne) space.unpushed.restore(island, loaded_, data.bodies);
  if (island.press_sweeps > 0) space.solves.search.temper(island, data.bodies, acceleration_, kicks_, changes_);
}

void Accurate::prepare(StepData& data) {
  BodySet& bodies = data.bodies;
  start_ = bodies.pose;
  motion_.assign(bodies.size(), {});
  kicks_.resize(bodies.size());
  held_.resize(bodies.size());
  later_ = bodies.velocity;  // of those that no island moves
  changes_.resize(bodies.size());
  meets_.resize(bodies.size());
  loaded_.assign(bodies.size(), 0);
  // The first half kick of a step is explicit and the last implicit: together they are of second order.
  const Real half = data.settings.dt / static_cast<Real>(2 * data.settings.substeps);
  data.forces.accelerations(bodies, 0, acceleration_, half);
  flight_ = acceleration_;

  const std::uint64_t parted = parts_.version();
  resting_.watch(data);
  parts_.split(data);
  if (!resting_.empty() && resting_.let_go_hindered(data, parts_)) parts_.split(data);
  begun_.resize(parts_.size());
  rows_.resize(parts_.contact_count());
  const std::uint64_t before = std::exchange(contact_changes_, data.contact_changes);
  const bool same = parted == parts_.version() && before != 0 && before == contact_changes_;
  if (same) return;
  for (ImpactRow& row : rows_) row.made = false;
}

void Accurate::make_rows(StepData& data, Island& island, std::size_t number) {
  island.rows = std::span(rows_).subspan(parts_.first_contact(number), island.contacts.size());
  Bearing bearing;
  const bool is_few = few(island);
  bool may_turn = false;  // by friction
  for (std::size_t i = 0; i < island.contacts.size(); ++i) {
    const Contact& contact = data.contacts[island.contacts[i].contact];
    ImpactRow& row = island.rows[i];
    renew(row, data.bodies, start_, data.contacts, island.contacts[i].contact);
    // In columns the pair of points is solved as a block, which settles faster; in the web of a pyramid it is worse.
    row.web = parts_.in_web(island.contacts[i]);
    row.block = !row.web && row.count == 2;
    if (row.points[0].normal_impulse > 0 || row.points[1].normal_impulse > 0) note_load(row);
    island.two_frictions |= row.two_frictions();
    island.held = island.held || !pushable(row.mass_a) || !pushable(row.mass_b);
    bearing.add(row);
    if (is_few && row.age >= OffsetRule::from_age) bearing.add_load(row, contact.offset, data.settings);
    const Stir stir = stir_of(contact, data.bodies);
    if (!stir.moves(data.settings.dt)) continue;
    island.struck = island.struck || (new_or_deep(contact) && at_speed(row, data.bodies));
    if (island.pile) continue;  // lanes keep normals and arms within a step
    island.struck = island.struck || closes(row, data.bodies, acceleration_, data.settings.dt);
    island.turning = island.turning || turns(contact, stir, data.bodies, data.settings.dt);
    may_turn = may_turn || !rolls(contact, row);
  }
  for (const ActiveJoint* joint : island.joints.all()) {
    note_load(joint->block);
    island.held = island.held || !pushable(joint->block.inv_mass_a) || !pushable(joint->block.inv_mass_b);
  }
  const auto pushed = [&](std::uint32_t body) { return data.bodies.pushable(body); };
  const bool single = std::count_if(island.bodies.begin(), island.bodies.end(), pushed) == 1;
  island.single = single && island.joints.empty();
  find_collisions(data, island);

  island.cut(data.settings, substeps_for(island.bodies, bearing, data.bodies, acceleration_, data.settings));
  for (ImpactRow& row : island.rows) {
    row.offset = island.offset_scale * data.contacts[row.contact].offset;
    if (row.block && row.pair.strength != island.softness(row).mass_scale) {
      row.pair = ScalarContacts::pair_of(island, row);
    }
  }
  // Joints solved by iteration rely on the sub-steps instead.
  const bool takes_turns =
      !island.joints.empty() && !island.joints.swept() && (!island.rows.empty() || has_stops(island.joints));
  // For a body that slides from one shape of the ground to the next, its load moves over at once, not in several
  // sub-steps.
  if (takes_turns || (island.rows.size() > 1 && single)) island.sweeps = data.settings.iterations;
  island.settling = settles(data, island);
  const bool is_closed = !island.varies && closed(data.bodies, island.bodies);
  island.ideal = is_closed && !island.joints.empty() && !driven(island.joints);
  // Small islands in motion are solved more closely.
  const int more_sweeps = more_sweeps_for(island.bodies.size());
  const bool follows = island.turning || island.struck;
  island.turning = follows && !island.pile;
  if (island.turning || may_turn) island.press_sweeps = press_sweeps_for(island.bodies.size());
  if (is_closed && follows) island.more_sweeps = more_sweeps;
  island.direct = island.press_sweeps > 0 && island.joints.empty() && island.rows.size() <= most_solved;
}

/// Impacts with restitution are events. So is an inelastic one between bodies that meet nothing else, or of one body
/// with several shapes that it can't push: it happens when they touch. Where bodies meet several others its impulse
/// passes on, and the contact solve finds all impulses together.
void Accurate::find_collisions(const StepData& data, Island& island) {
  for (const std::uint32_t body : island.bodies) meets_[body] = 0;
  const auto count = [&](const auto& mass_a, std::uint32_t a, const auto& mass_b, std::uint32_t b) {
    if (pushable(mass_a)) ++meets_[a];
    if (pushable(mass_b)) ++meets_[b];
  };
  for (const ImpactRow& row : island.rows) count(row.mass_a, row.a, row.mass_b, row.b);
  for (const ActiveJoint* joint : island.joints.all()) {
    count(joint->block.inv_mass_a, joint->block.a, joint->block.inv_mass_b, joint->block.b);
  }
  for (ImpactRow& row : island.rows) {
    const auto meets_one = [&](const InverseMass& mass, std::uint32_t body) {
      return !pushable(mass) || meets_[body] == 1;
    };
    const bool alone = island.single || (meets_one(row.mass_a, row.a) && meets_one(row.mass_b, row.b));
    row.collides = row.restitution > 0 || alone;
    island.bounces |= row.restitution > 0 || (alone && closes(row, data.bodies, acceleration_, data.settings.dt));
  }
}

Island Accurate::island(StepData& data, std::size_t number, Workspace& space) {
  const std::span<const Tie> contacts = parts_.contacts(number);
  Island island{
      .bodies = parts_.bodies(number),
      .contacts = contacts,
      .rows = {},
      .joints = IslandJoints(parts_.joints(number), parts_.bodies(number), data.bodies, start_, motion_, space.joints),
      .pulls = parts_.pulls(number),
      .varies = parts_.varies(number),
      .webbed = std::any_of(contacts.begin(), contacts.end(), [&](const Tie& tie) { return parts_.in_web(tie); })};
  island.heap = is_heap(data, island);
  return island;
}

Real Accurate::find_impacts(StepData& data, Island& island, Workspace& space) {
  for (const std::uint32_t body : island.bodies) {
    flight_[body] = loaded_[body] != 0 ? Velocity{} : acceleration_[body];
  }
  const auto find_at = [&](const ImpactRow& row, const Motion& a, const Motion& b) {
    return space.turning.find_at(data, island, start_, motion_, row, {a, b});
  };
  return space.impacts.resolve(island.rows, island.joints, island.bodies, data.bodies, motion_, flight_, island.h,
                               slow_impact(pressing(island), island.h), std::ref(find_at));
}

bool Accurate::hold_those_that_meet(StepData& data, Island& island, Workspace& space) {
  const auto find_at = [&](const ImpactRow& row, const Motion& a, const Motion& b) {
    return space.turning.find_at(data, island, start_, motion_, row, {a, b});
  };
  return space.impacts.hold_those_that_meet(island.rows, data.bodies, motion_, island.h,
                                            not_felt / static_cast<Real>(island.substeps), std::ref(find_at));
}

Real Accurate::pressing(const Island& island) const {
  Real most = 0;
  for (const std::uint32_t body : island.bodies) most = std::max(most, length(acceleration_[body].v));
  return most;
}

/// Half of the forces, half of what contacts and joints bore in the last sub-step.
void Accurate::kick(BodySet& bodies, Island& island) {
  for (const std::uint32_t body : island.bodies) {
    const Velocity& contacts = kicks_[body];
    bodies.velocity[body].v += island.h / 2 * acceleration_[body].v + contacts.v;
    bodies.velocity[body].w += island.h / 2 * acceleration_[body].w + contacts.w;
  }
  ScalarContacts(bodies, motion_).count_halves(island);
  if (!island.joints.empty()) island.joints.kick();
}

void Accurate::drift(StepData& data, const Island& island) {
  BodySet& bodies = data.bodies;
  for (const std::uint32_t body : island.bodies) {
    const Velocity& v = bodies.velocity[body];
    motion_[body].d += island.h * v.v;
    motion_[body].turn_by(island.h * v.w);
  }
  if (!island.varies) return;
  for (const std::uint32_t body : island.bodies) {
    bodies.pose[body] = motion_[body].from(start_[body]);
    held_[body] = bodies.velocity[body];
    held_[body].v += kicks_[body].v;
    held_[body].w += kicks_[body].w;
  }
  island.joints.push_halves(held_);
  for (const std::uint32_t body : island.bodies) {
    later_[body].v = held_[body].v + island.h / 2 * acceleration_[body].v;
    later_[body].w = held_[body].w + island.h / 2 * acceleration_[body].w;
  }
  data.forces.accelerations(bodies, island.bodies, island.pulls, island.h / 2, held_, later_, acceleration_);
}

void Accurate::note_loads(const Island& island) {
  for (ImpactRow& row : island.rows) {
    for (RowPoint& p : row.points) row.note(p, {p.normal_impulse, p.tangent_impulse}, row.normal);
  }
  if (!island.bounces && island.press_sweeps == 0) return;  // not needed
  for (const std::uint32_t body : island.bodies) loaded_[body] = 0;
  for (const ActiveJoint* joint : island.joints.all()) note_load(joint->block);
  for (const ImpactRow& row : island.rows) {
    if (row.points[0].normal_impulse > 0 || row.points[1].normal_impulse > 0) note_load(row);
  }
}

const MethodList<Solver>::Entry accurate_entry{
    {"accurate", "sub-steps by kick, press, drift, kick, relax; impacts at their own times; loads without sinking",
     accurate_source},
    [] { return make_accurate(true); }};

}  // namespace

std::unique_ptr<Solver> make_accurate(bool lanes) { return std::make_unique<Accurate>(lanes); }

}  // namespace impulse::inline IMPULSE_PRECISION
