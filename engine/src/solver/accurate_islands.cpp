#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "contacts/contact_rows.h"
#include "solver/accurate.h"

/// What an island is made of, and by what it is solved.
namespace impulse::inline IMPULSE_PRECISION {

namespace {

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

}  // namespace

void Accurate::prepare(StepData& data) {
  BodySet& bodies = data.bodies;
  start_ = bodies.pose;
  motion_.assign(bodies.size(), {});
  kicks_.resize(bodies.size());
  held_.resize(bodies.size());
  later_ = bodies.velocity;  // of those that no island moves
  changes_.resize(bodies.size());
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
    // Joints that are solved at once pass all of a blow on only if it comes at one moment.
    row.strikes = row.restitution > 0 || (!island.joints.empty() && !island.joints.swept());
    island.bounces |= row.strikes;
    island.held = island.held || !pushable(row.mass_a) || !pushable(row.mass_b);
    island.jammed |= is_deep(row.points);
    bearing.add(row);
    if (row.age >= OffsetRule::from_age) bearing.add_load(row, row.web, contact.offset, data.settings);
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

  const int by_load = substeps_for(island, bearing, data.bodies, acceleration_, data.settings);
  const int by_forces = island.varies ? substeps_past(data, island.bodies) : 0;
  island.cut(data.settings, std::max({by_load, by_forces, island.least_substeps}));
  for (ImpactRow& row : island.rows) {
    row.offset = island.offset_scale * data.contacts[row.contact].offset;
    if (row.block && row.pair.strength != island.softness(row).mass_scale) {
      row.pair = ScalarContacts::pair_of(island, row);
    }
  }
  // Joints solved by iteration rely on the sub-steps instead.
  const bool takes_turns =
      !island.joints.empty() && !island.joints.swept() && (!island.rows.empty() || has_stops(island.joints));
  if (takes_turns) island.sweeps = data.settings.iterations;
  island.settling = settles(data, island);
  const bool is_closed = !island.varies && closed(data.bodies, island.bodies);
  island.ideal = is_closed && !island.joints.empty() && !driven(island.joints);
  // Small islands in motion are solved more closely.
  const int more_sweeps = more_sweeps_for(island.bodies.size());
  const bool follows = island.turning || island.struck;
  island.turning = follows && !island.pile;
  if (island.turning || may_turn) island.press_sweeps = press_sweeps_for(island.bodies.size());
  if (is_closed && follows) island.more_sweeps = more_sweeps;
}

Island Accurate::island(StepData& data, std::size_t number, AccurateWorkspace& space) {
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

Real Accurate::pressing(const Island& island) const {
  Real most = 0;
  for (const std::uint32_t body : island.bodies) most = std::max(most, length(acceleration_[body].v));
  return most;
}

}  // namespace impulse::inline IMPULSE_PRECISION
