#include "solver/accurate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "contacts/contact_rows.h"
#include "core/method_list.h"
#include "core/stages.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Fraction of its kinetic energy that an island with joints may gain in a sub-step, because RATTLE's energy oscillates
/// about the true one: 1e-5 for a pendulum, 1e-2 and more for chains too fast for the sub-step.
constexpr Real ideal_gain = static_cast<Real>(1e-4);

/// Most joints of an island that is solved as one system, and most contacts that may bear something; most contacts in
/// all, unless it is a single body: eight composite bodies that fly about have 200; and the most that more joints may
/// cost, as much as 24 hinges that all act on each other: chains of 1000 links do.
constexpr std::size_t most_direct = 24;
constexpr std::uint64_t most_joint_cost = 20000;
constexpr std::size_t most_known = 240;

/// Whether two bodies are near each other within the step, as they move now.
bool come_near(const Contact& contact, const BodySet& bodies, const std::vector<Velocity>& acceleration, Real dt) {
  const Velocity& a = bodies.velocity[contact.body_a];
  const Velocity& b = bodies.velocity[contact.body_b];
  const Vec2 falls = (dt * dt / 2) * (acceleration[contact.body_b].v - acceleration[contact.body_a].v);
  return std::any_of(contact.points.begin(), contact.points.begin() + contact.count, [&](const ContactPoint& p) {
    const Vec2 moves = dt * (b.v - a.v + cross(b.w, p.arm_b) - cross(a.w, p.arm_a)) + falls;
    return p.separation + std::min(dot(contact.normal, moves), Real{0}) <= near_by;
  });
}

/// Whether an island is solved as one system: if its joints form chains or are few, and few of its contacts bring
/// bodies near each other within the step. Of two bodies that are pushed no more than two count: parts of compound
/// bodies meet at many places, and what these two do to each other has three components.
bool is_direct(const StepData& data, const Island& island, const std::vector<Velocity>& acceleration) {
  if (island.joints.all().size() > most_direct && island.joints.cost() > most_joint_cost) return false;
  if (island.contacts.size() <= most_direct) return true;
  if (island.contacts.size() > most_known && island.bodies.size() > 1) return false;
  std::array<std::pair<std::uint32_t, std::uint32_t>, most_known> pairs;
  auto end = pairs.begin();
  std::size_t count = 0;
  for (const Tie& tie : island.contacts) {
    if (!come_near(data.contacts[tie.contact], data.bodies, acceleration, data.settings.dt)) continue;
    ++count;
    if (tie.pushes_a && tie.pushes_b) *end++ = std::minmax(tie.a, tie.b);
  }
  std::sort(pairs.begin(), end);
  for (auto pair = pairs.begin(); pair < end; ++pair) {
    if (end - pair > 2 && pair[2] == *pair) --count;
  }
  return count <= most_direct;
}

/// Whether bodies of some contact move so fast that they may be driven into each other. Discs must be hit: their
/// normals rotate in lanes, too, or stay as they are.
bool may_drive_deep(const StepData& data, const Island& island) {
  const bool stirs = std::any_of(island.contacts.begin(), island.contacts.end(), [&](const Tie& tie) {
    const Contact& contact = data.contacts[tie.contact];
    const Stir stir = stir_of(contact, data.bodies);
    const bool turns = stir.turning > 0 || !(contact.disc_a || contact.disc_b);
    return turns && stir.moves(data.settings.dt);
  });
  return stirs || is_struck(data, island);
}

/// Notes which rows take part in what is solved next.
void list_acting(Island& island, std::vector<std::uint32_t>& acting) {
  acting.clear();
  for (std::size_t i = 0; i < island.rows.size(); ++i) {
    if (island.rows[i].active) acting.push_back(static_cast<std::uint32_t>(i));
  }
  island.acting = acting;
}

}  // namespace

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
  };
  data.workers.share_out(batches, std::ref(step_batch));  // a copy would allocate memory
  for (AccurateWorkspace& space : spaces_) {
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

void Accurate::step_island(StepData& data, std::size_t number, AccurateWorkspace& space) {
  Island now = island(data, number, space);
  if (RestingPile* pile = resting_.of(data.bodies, now.bodies)) {
    pile->step(data, parts_, now, acceleration_, motion_, space.row_of);
    if (resting_.may_grow(data, now, *pile)) pile->begin_anew();
    return;
  }
  if (now.contacts.empty() && now.joints.empty() && !now.varies) return fly(data, now);
  if (is_direct(data, now, acceleration_)) {
    DirectStep step{data, start_, motion_, acceleration_, flight_, later_, held_};
    space.direct.step(step, {now.bodies, now.contacts, now.joints.all(), now.pulls, now.varies});
    return;
  }
  now.pile = !now.varies && is_pile(data, now);
  if (now.pile) return step_pile(data, number, now, space);
  step_swept(data, number, now, space);
}

void Accurate::step_pile(StepData& data, std::size_t number, Island& pile, AccurateWorkspace& space) {
  const bool may = !is_large(pile.bodies.size(), data.settings) && may_drive_deep(data, pile);
  if (may) space.before.keep(data, pile, acceleration_);
  if (lanes_) {
    step_in_lanes(data, number, pile, space);
  } else {
    space.colouring.assign(parts_, pile, 1);
    pile.contacts = space.colouring.order();
    make_rows(data, pile, number);
    go_through(data, pile, space);
  }
  if (!may || !space.before.drove_deep(data, start_, motion_, 0)) return;
  // Lanes keep normals and arms within a step.
  begun_[number] = nullptr;
  Island again = island(data, number, space);
  begin_again(data, number, again, space);
  step_swept(data, number, again, space);
}

void Accurate::step_in_lanes(StepData& data, std::size_t number, Island& pile, AccurateWorkspace& space) {
  plan_pile(data, parts_, pile, acceleration_);
  std::unique_ptr<RestingPile>& begun = begun_[number];
  begun = resting_.part_at_rest(data, parts_, pile, space.row_of);
  if (begun == nullptr) return step_as_pile(data, parts_, pile, acceleration_, motion_, space.pile, space.row_of);
  pile.contacts = begun->others();
  begun->step(data, parts_, pile, acceleration_, motion_, space.row_of);
}

void Accurate::step_swept(StepData& data, std::size_t number, Island& island, AccurateWorkspace& space) {
  make_rows(data, island, number);
  const bool moves = (island.turning || island.struck) && island.joints.empty();
  if (moves && may_halve(island.bodies.size(), island.substeps)) space.before.keep(data, island, acceleration_);
  go_through(data, island, space);
  // Where sweeps never suffice, as of bodies that start in each other, shorter sub-steps have no solution either.
  const auto jammed = [&] { return island.unsolved == island.substeps; };
  while (moves && may_halve(island.bodies.size(), island.substeps) && !jammed() &&
         space.before.drove_deep(data, start_, motion_, not_felt)) {
    island.least_substeps = 2 * island.substeps;
    begin_again(data, number, island, space);
    make_rows(data, island, number);
    go_through(data, island, space);
  }
}

/// Takes an island back to the start of the step.
void Accurate::begin_again(StepData& data, std::size_t number, const Island& island, AccurateWorkspace& space) {
  space.before.restore(data, island, acceleration_);
  for (const std::uint32_t body : island.bodies) {
    if (island.varies) data.bodies.pose[body] = start_[body];
    motion_[body] = {};
    loaded_[body] = 0;
  }
  for (std::size_t i = 0; i < island.contacts.size(); ++i) rows_[parts_.first_contact(number) + i].made = false;
}

void Accurate::go_through(StepData& data, Island& island, AccurateWorkspace& space) {
  const auto substeps = static_cast<Real>(island.substeps);
  island.share(1 / substeps);
  island.unsolved = 0;
  if (!island.joints.empty()) island.joints.write();
  space.turning.begin(island, data);
  for (int i = 0; i < island.substeps; ++i) substep(data, island, space);
  if (!island.settling) ScalarContacts(data.bodies, motion_).settle_offsets(island);
  island.share(substeps);
  for (ImpactRow& row : island.rows) write_back(row, island.offset_scale, data.contacts);
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

void Accurate::substep(StepData& data, Island& island, AccurateWorkspace& space) {
  ScalarContacts contacts(data.bodies, motion_);
  space.turning.find_again(data, start_, motion_);
  if (island.bounces) {
    space.turning.follow(island, motion_);
    find_impacts(data, island, space);
  }
  space.turning.lead(island, data.bodies, motion_);
  if (island.bounces) space.impacts.note_paths(island.rows, motion_, island.h);
  if (!island.joints.empty()) island.joints.halve();
  const Real pressed_by = island.two_frictions ? pressing(island) : 0;
  if (island.two_frictions) contacts.meet(island, slow_impact(pressed_by, island.h));
  contacts.halve(island, kicks_);
  if (!island.joints.empty() || island.more_sweeps > 0)
    space.bound.note(island.bodies, island.held, data.bodies, motion_);
  if (island.press_sweeps > 0) space.unpushed.note(island, data.bodies, acceleration_);
  kick(data.bodies, island);
  PressAndRelax solve(data.bodies, island, motion_, changes_, space.search, space.local);
  contacts.measure(island);
  if (island.press_sweeps > 0) contacts.leave_out_far(island);
  list_acting(island, space.acting);
  const bool some_wait = island.bounces || island.press_sweeps > 0;
  solve.press(false);
  while (some_wait && hold_those_that_meet(data, island, space)) solve.press(false);
  int pressed = solve.press_through();
  while (some_wait && hold_those_that_meet(data, island, space)) pressed += solve.press_through();
  if (island.press_sweeps > 0 && pressed >= island.press_sweeps) {
    ++island.unsolved;
    if (island.jammed) island.press_sweeps = std::max(island.press_sweeps / 2, 1);
  }
  drift(data, island);
  if (island.bounces) Impacts::forget_paths(island.rows);
  const bool joints_fit = island.joints.fit();
  if (!island.joints.empty()) island.joints.write();
  kick(data.bodies, island);
  contacts.measure(island);
  solve.relax(island.settling ? std::max(settling_sweeps_for(island.bodies.size()), island.sweeps)
                              : island.sweeps + pressed);
  solve.relax_through();
  if (island.two_frictions && contacts.stick_or_slip(island, no_slip_in_web(pressed_by, island.h))) {
    solve.relax(island.sweeps);
  }
  if (island.more_sweeps > 0) solve.relax_until_bounded(space.bound, acceleration_);
  contacts.turn_back(island);
  if (!joints_fit || island.ideal) {
    // Compliant joints must return their energy as height, not as speed.
    const Real gain = joints_fit && !island.joints.swept() ? ideal_gain : Real{0};
    const bool slowed = space.bound.keep(data.bodies, start_, motion_, acceleration_, gain);
    if (slowed && !joints_fit) island.joints.forget();
  }
  if (island.settling) contacts.settle_offsets(island);
  note_loads(island);
  if (island.press_sweeps > 0 && !island.varies) space.unpushed.restore(island, loaded_, data.bodies);
  if (island.press_sweeps > 0) space.search.temper(island, data.bodies, acceleration_, kicks_, changes_);
}

void Accurate::find_impacts(StepData& data, Island& island, AccurateWorkspace& space) {
  for (const std::uint32_t body : island.bodies) {
    flight_[body] = loaded_[body] != 0 ? Velocity{} : acceleration_[body];
  }
  const auto find_at = [&](const ImpactRow& row, const Motion& a, const Motion& b) {
    return space.turning.find_at(data, island, start_, motion_, row, {a, b});
  };
  space.impacts.resolve(island.rows, island.joints, island.bodies, data.bodies, motion_, flight_, island.h,
                        slow_impact(pressing(island), island.h), std::ref(find_at));
}

bool Accurate::hold_those_that_meet(StepData& data, Island& island, AccurateWorkspace& space) {
  const auto find_at = [&](const ImpactRow& row, const Motion& a, const Motion& b) {
    return space.turning.find_at(data, island, start_, motion_, row, {a, b});
  };
  const bool any = space.impacts.hold_those_that_meet(island.rows, data.bodies, motion_, island.h,
                                                      not_felt / static_cast<Real>(island.substeps), std::ref(find_at));
  if (!any) return false;
  ScalarContacts(data.bodies, motion_).measure(island);  // those that were found again
  list_acting(island, space.acting);
  return true;
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
    for (RowPoint& p : row.points) row.note(p, p, row.normal, {p.normal_impulse, p.tangent_impulse});
  }
  if (!island.bounces && island.press_sweeps == 0) return;  // not needed
  for (const std::uint32_t body : island.bodies) loaded_[body] = 0;
  for (const ActiveJoint* joint : island.joints.all()) note_load(joint->block);
  for (const ImpactRow& row : island.rows) {
    if (row.points[0].normal_impulse > 0 || row.points[1].normal_impulse > 0) note_load(row);
  }
}

namespace {

const MethodList<Solver>::Entry accurate_entry{
    {"accurate", "sub-steps by kick, press, drift, kick, relax; impacts at their own times; loads without sinking",
     accurate_source},
    [] { return make_accurate(true); }};

}  // namespace

std::unique_ptr<Solver> make_accurate(bool lanes) { return std::make_unique<Accurate>(lanes); }

}  // namespace impulse::inline IMPULSE_PRECISION
