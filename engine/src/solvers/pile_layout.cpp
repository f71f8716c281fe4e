#include <algorithm>
#include <array>
#include <iterator>
#include <type_traits>

#include "solvers/pile.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr std::size_t width = 8;
constexpr std::uint32_t nowhere = ~std::uint32_t{0};

std::size_t rounded_up(std::size_t count) { return (count + width - 1) / width * width; }

bool pushable(const InverseMass& mass) { return mass.m + mass.i > 0; }

}  // namespace

void Pile::give_row(std::uint32_t body) {
  if (row_[body] != nowhere) return;
  row_[body] = static_cast<std::uint32_t>(present_.size());
  present_.push_back(body);
}

/// Bodies of the island, then those that it touches and does not move, then at least one row of no body.
void Pile::take_bodies(const StepData& data, const Island& island, const std::vector<Velocity>& acceleration) {
  const BodySet& bodies = data.bodies;
  row_.resize(bodies.size(), nowhere);
  present_.clear();
  for (const std::uint32_t body : island.bodies) give_row(body);
  for (const Tie& tie : island.contacts) {
    if (!tie.pushes_a) give_row(tie.a);
    if (!tie.pushes_b) give_row(tie.b);
  }
  const std::size_t count = rounded_up(present_.size() + 1);
  for (auto* rows : {&velocity_, &before_, &kick_, &motion_, &acceleration_}) rows->assign(4 * count, 0);
  turn_.assign(count, 0);
  for (std::size_t i = 0; i < present_.size(); ++i) {
    const std::uint32_t body = present_[i];
    const Velocity& v = bodies.velocity[body];
    std::copy_n(std::array{v.v.x, v.v.y, v.w}.begin(), 3, &velocity_[4 * i]);
    const Velocity& a = acceleration[body];
    std::copy_n(std::array{a.v.x, a.v.y, a.w}.begin(), 3, &acceleration_[4 * i]);
  }
  rows_ = {static_cast<std::uint32_t>(count),
           velocity_.data(),
           before_.data(),
           kick_.data(),
           motion_.data(),
           turn_.data(),
           acceleration_.data()};
}

void Pile::lay_out(const StepData& data, const Island& island) {
  fill_all(data, island, LanesKind::one, one_);
  fill_all(data, island, LanesKind::discs, discs_);
  fill_all(data, island, LanesKind::two, two_);
  fill_all(data, island, LanesKind::block, block_);
  const std::span<const LanesRun> runs = colouring_.runs();
  table_ = {one_.data(), discs_.data(), two_.data(), block_.data(), runs.data(), runs.data() + runs.size()};
}

// Lane by lane: what is written stays in the first cache, and what is read ahead is asked for in time.
template <class Lanes>
void Pile::fill_all(const StepData& data, const Island& island, LanesKind kind, std::vector<Lanes>& all) {
  const std::span<const Slot> slots = colouring_.lanes(kind);
  all.resize(slots.size() / width);
  for (std::size_t at = 0; at < slots.size(); ++at) {
    Lanes& lanes = all[at / width];
    const std::size_t lane = at % width;
    if (lane == 0) {
      lanes.any_fresh = false;
      if (slots[at + width - 1].tie.contact == Slot::empty) clear(lanes);
    }
    if (at + width < slots.size()) fetch(data.contacts, slots[at + width]);
    if (slots[at].tie.contact != Slot::empty) fill(data, island, slots[at], lane, lanes);
  }
}

void Pile::fetch(const std::vector<Contact>& contacts, const Slot& slot) {
  if (slot.tie.contact == Slot::empty) return;
  constexpr std::size_t cache_line = 64;
  const char* begin = reinterpret_cast<const char*>(&contacts[slot.tie.contact]);
  for (std::size_t i = 0; i < sizeof(Contact); i += cache_line) __builtin_prefetch(begin + i);
}

template <class Lanes>
void Pile::clear(Lanes& lanes) const {
  lanes = {};
  const auto nobody = static_cast<std::uint32_t>(present_.size());
  std::fill_n(lanes.a, width, nobody);
  std::fill_n(lanes.b, width, nobody);
}

template <class Lanes>
void Pile::fill(const StepData& data, const Island& island, const Slot& slot, std::size_t lane, Lanes& lanes) {
  const Contact& contact = data.contacts[slot.tie.contact];
  const InverseMass& mass_a = data.bodies.inverse_mass[slot.tie.a];
  const InverseMass& mass_b = data.bodies.inverse_mass[slot.tie.b];
  const Softness& soft = island.softness(slot.web, mass_a, mass_b);
  const auto put = [lane](Eight& to, Real value) { to.lane[lane] = value; };
  lanes.a[lane] = row_[slot.tie.a];
  lanes.b[lane] = row_[slot.tie.b];
  put(lanes.normal_x, contact.normal.x);
  put(lanes.normal_y, contact.normal.y);
  put(lanes.mass_a, mass_a.m);
  put(lanes.inertia_a, mass_a.i);
  put(lanes.mass_b, mass_b.m);
  put(lanes.inertia_b, mass_b.i);
  put(lanes.static_friction, contact.static_friction);
  put(lanes.dynamic_friction, contact.dynamic_friction);
  put(lanes.strength, soft.strength);
  put(lanes.rate, soft.rate);
  put(lanes.relief, soft.relief);
  put(lanes.give, 1 / (2 * island.h * soft.omega * soft.omega));
  put(lanes.offset, contact.offset);
  put(lanes.offset_rate, island.offset_rate(contact.age));
  const bool fresh = contact.age == 0;
  put(lanes.fresh, fresh ? Real{1} : Real{0});
  lanes.any_fresh |= fresh;
  if constexpr (std::is_same_v<Lanes, DiscLanes>) {
    const Vec2 between = data.bodies.pose[slot.tie.b].p - data.bodies.pose[slot.tie.a].p;
    put(lanes.between_x, between.x);
    put(lanes.between_y, between.y);
    put(lanes.distance, contact.radius_a + contact.radius_b);
  }
  const Real share = 1 / static_cast<Real>(island.substeps);
  for (std::size_t i = 0; i < std::size(lanes.point); ++i) {
    PointLanes& to = lanes.point[i];
    const PointPlace place = place_of(contact, i);
    put(to.cross_a, place.cross_a);
    put(to.cross_b, place.cross_b);
    put(to.dot_a, place.dot_a);
    put(to.dot_b, place.dot_b);
    put(to.turn_a, place.turn_a);
    put(to.turn_b, place.turn_b);
    put(to.separation, place.separation - contact.offset);
    put(to.gap, place.separation - contact.offset);
    put(to.normal_impulse, contact.points[i].normal_impulse * share);
    put(to.tangent_impulse, contact.points[i].tangent_impulse * share);
    put(to.total_normal, 0);
    put(to.total_tangent, 0);
  }
}

void Pile::leave(const StepData& data, const Island& island, std::vector<Motion>& motion) {
  store_all(data, island, LanesKind::one, one_);
  store_all(data, island, LanesKind::discs, discs_);
  store_all(data, island, LanesKind::two, two_);
  store_all(data, island, LanesKind::block, block_);
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const std::uint32_t body = island.bodies[i];
    motion[body] = {{motion_[4 * i], motion_[4 * i + 1]}, turn_[i], motion_[4 * i + 2], motion_[4 * i + 3]};
    if (pushable(data.bodies.inverse_mass[body])) {
      data.bodies.velocity[body] = {{velocity_[4 * i], velocity_[4 * i + 1]}, velocity_[4 * i + 2]};
    }
  }
  for (const std::uint32_t body : present_) row_[body] = nowhere;
}

template <class Lanes>
void Pile::store_all(const StepData& data, const Island& island, LanesKind kind, const std::vector<Lanes>& all) {
  const std::span<const Slot> slots = colouring_.lanes(kind);
  for (std::size_t at = 0; at < slots.size(); ++at) {
    if (at + width < slots.size()) fetch(data.contacts, slots[at + width]);
    if (slots[at].tie.contact == Slot::empty) continue;
    store(island, all[at / width], at % width, data.contacts[slots[at].tie.contact]);
  }
}

template <class Lanes>
void Pile::store(const Island& island, const Lanes& lanes, std::size_t lane, Contact& contact) {
  const auto substeps = static_cast<Real>(island.substeps);
  for (std::size_t i = 0; i < std::size(lanes.point); ++i) {
    const PointLanes& from = lanes.point[i];
    ContactPoint& to = contact.points[i];
    to.normal_impulse = from.normal_impulse.lane[lane] * substeps;
    to.tangent_impulse = from.tangent_impulse.lane[lane] * substeps;
    to.total_normal_impulse = from.total_normal.lane[lane];
    to.total_tangent_impulse = from.total_tangent.lane[lane];
  }
  contact.offset = lanes.offset.lane[lane];
}

/// Sine and cosine of bodies that have turned too far for the series of the kernel.
void Pile::turn_far() {
  for (std::size_t i = 0; i < turn_.size(); ++i) {
    Motion turned;
    turned.turn_by(turn_[i]);
    motion_[4 * i + 2] = turned.sine;
    motion_[4 * i + 3] = turned.drop;
  }
}

/// J, of the bodies that can be pushed.
Real Pile::kinetic_energy(const StepData& data, const Island& island) const {
  Real sum = 0;
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const InverseMass& inverse = data.bodies.inverse_mass[island.bodies[i]];
    const Real* v = &velocity_[4 * i];
    if (inverse.m > 0) sum += (v[0] * v[0] + v[1] * v[1]) / (2 * inverse.m);
    if (inverse.i > 0) sum += v[2] * v[2] / (2 * inverse.i);
  }
  return sum;
}

/// J, that the forces gave in this sub-step.
Real Pile::work(const StepData& data, const Island& island) const {
  Real sum = 0;
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const InverseMass& inverse = data.bodies.inverse_mass[island.bodies[i]];
    const Real* a = &acceleration_[4 * i];
    const Real* now = &motion_[4 * i];
    const Real* then = &start_motion_[4 * i];
    if (inverse.m > 0) sum += (a[0] * (now[0] - then[0]) + a[1] * (now[1] - then[1])) / inverse.m;
    if (inverse.i > 0) sum += a[2] * (turn_[i] - start_turn_[i]) / inverse.i;
  }
  return sum;
}

}  // namespace impulse::inline IMPULSE_PRECISION
