#include <algorithm>
#include <array>
#include <iterator>

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
  one_.resize(std::max(one_.size(), std::size_t{colouring_.count(LanesKind::one)}));
  discs_.resize(std::max(discs_.size(), std::size_t{colouring_.count(LanesKind::discs)}));
  two_.resize(std::max(two_.size(), std::size_t{colouring_.count(LanesKind::two)}));
  block_.resize(std::max(block_.size(), std::size_t{colouring_.count(LanesKind::block)}));
  // Only the last of a run may have lanes without a contact.
  const auto clear = [nobody = static_cast<std::uint32_t>(present_.size())](auto& lanes) {
    lanes = {};
    std::fill_n(lanes.a, width, nobody);
    std::fill_n(lanes.b, width, nobody);
  };
  for (const LanesRun& run : colouring_.runs()) {
    switch (run.kind) {
      case LanesKind::one:
        clear(one_[run.end - 1]);
        break;
      case LanesKind::discs:
        clear(discs_[run.end - 1]);
        break;
      case LanesKind::two:
        clear(two_[run.end - 1]);
        break;
      case LanesKind::block:
        clear(block_[run.end - 1]);
        break;
    }
  }
  for (const Slot& slot : colouring_.slots()) {
    const std::size_t lane = slot.at % width;
    switch (slot.kind) {
      case LanesKind::one:
        fill(data, island, slot, lane, one_[slot.at / width]);
        break;
      case LanesKind::discs: {
        DiscLanes& discs = discs_[slot.at / width];
        fill(data, island, slot, lane, discs);
        const Contact& contact = data.contacts[slot.tie.contact];
        const Vec2 between = data.bodies.pose[contact.body_b].p - data.bodies.pose[contact.body_a].p;
        discs.between_x.lane[lane] = between.x;
        discs.between_y.lane[lane] = between.y;
        discs.distance.lane[lane] = contact.radius_a + contact.radius_b;
        break;
      }
      case LanesKind::two:
        fill(data, island, slot, lane, two_[slot.at / width]);
        break;
      case LanesKind::block:
        fill(data, island, slot, lane, block_[slot.at / width]);
        break;
    }
  }
  const std::span<const LanesRun> runs = colouring_.runs();
  table_ = {one_.data(), discs_.data(), two_.data(), block_.data(), runs.data(), runs.data() + runs.size()};
}

template <class Lanes>
void Pile::fill(const StepData& data, const Island& island, const Slot& slot, std::size_t lane, Lanes& lanes) {
  const Contact& contact = data.contacts[slot.tie.contact];
  const InverseMass& mass_a = data.bodies.inverse_mass[contact.body_a];
  const InverseMass& mass_b = data.bodies.inverse_mass[contact.body_b];
  const Softness& soft = island.softness(slot.web, mass_a, mass_b);
  const auto put = [lane](Eight& to, Real value) { to.lane[lane] = value; };
  lanes.a[lane] = row_[contact.body_a];
  lanes.b[lane] = row_[contact.body_b];
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
  // Lanes are filled in order.
  lanes.any_fresh = fresh || (lane > 0 && lanes.any_fresh);
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
  for (const Slot& slot : colouring_.slots()) {
    Contact& contact = data.contacts[slot.tie.contact];
    const std::size_t lane = slot.at % width;
    switch (slot.kind) {
      case LanesKind::one:
        store(island, one_[slot.at / width], lane, contact);
        break;
      case LanesKind::discs:
        store(island, discs_[slot.at / width], lane, contact);
        break;
      case LanesKind::two:
        store(island, two_[slot.at / width], lane, contact);
        break;
      case LanesKind::block:
        store(island, block_[slot.at / width], lane, contact);
        break;
    }
  }
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
