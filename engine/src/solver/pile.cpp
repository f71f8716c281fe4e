#include "solver/pile.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "core/stages.h"
#include "solver/descent.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr std::uint32_t nowhere = ~std::uint32_t{0};
constexpr std::size_t block = 16;  // rows that kernels take at a time at most

std::size_t rounded_up(std::size_t count) { return (count + block - 1) / block * block; }

}  // namespace

void Pile::keep(std::span<Contact> contacts, const BodySet& bodies, const Partition& parts, const Island& island,
                RowOf& row_of) {
  take_bodies(bodies, island, row_of);
  present_.push_back(nowhere);
  kept_rows_ = present_.size();
  kept_ = PileLanes::make(*kernels_);
  kept_colouring_.assign(parts, island, kept_->at_a_time());
  kept_->lay_out(contacts, bodies, island, kept_colouring_, row_of, static_cast<std::uint32_t>(kept_rows_ - 1));
  forget_rows(row_of);
}

void Pile::step(const StepData& data, const Partition& parts, const Island& island,
                const std::vector<Velocity>& acceleration, std::vector<Motion>& motion, RowOf& row_of) {
  take_bodies(data.bodies, island, row_of);
  take_motions(data.bodies, acceleration);
  end_stage("pile: bodies");
  const std::uint32_t first = island.bodies.front();
  if (version_ != parts.version() || first_body_ != first) {
    colouring_.assign(parts, island, lanes_->at_a_time());
    version_ = parts.version();
    first_body_ = first;
  }
  end_stage("pile: colour");
  lanes_->lay_out(data.contacts, data.bodies, island, colouring_, row_of, static_cast<std::uint32_t>(present_.size()));
  if (kept_ != nullptr) lanes_->begin_late(rows_);
  end_stage("pile: lay out");
  kernels_->kick_by_forces(rows_, island.h);
  for_both([this](PileLanes& lanes) { lanes.kick(rows_); });
  if (island.more_sweeps > 0) weigh(data, island, row_of);
  for (int i = 0; i < island.substeps; ++i) substep(island, i == 0);
  end_stage("pile: sub-steps");
  if (!island.settling) {
    for_both([](PileLanes& lanes) { lanes.settle(false); });
  }
  leave(data, island, row_of, motion);
  forget_rows(row_of);
  end_stage("pile: leave");
}

void Pile::give_row(std::uint32_t body, RowOf& row_of) {
  if (row_of[body] != nowhere) return;
  row_of[body] = static_cast<std::uint32_t>(present_.size());
  present_.push_back(body);
}

void Pile::forget_rows(RowOf& row_of) const {
  for (const std::uint32_t body : present_) {
    if (body != nowhere) row_of[body] = nowhere;
  }
}

/// What is kept has its rows. Then bodies of the island, then those that it touches and does not move, then at least
/// one row of no body.
void Pile::take_bodies(const BodySet& bodies, const Island& island, RowOf& row_of) {
  row_of.resize(bodies.size(), nowhere);
  present_.resize(kept_rows_);
  for (std::uint32_t i = 0; i < present_.size(); ++i) {
    if (present_[i] != nowhere) row_of[present_[i]] = i;
  }
  for (const std::uint32_t body : island.bodies) give_row(body, row_of);
  for (const Tie& tie : island.contacts) {
    if (!tie.pushes_a) give_row(tie.a, row_of);
    if (!tie.pushes_b) give_row(tie.b, row_of);
  }
}

/// Motions go on where they are kept, the others begin.
void Pile::take_motions(const BodySet& bodies, const std::vector<Velocity>& acceleration) {
  const std::size_t count = rounded_up(present_.size() + 1);
  for (auto* rows : {&velocity_, &before_, &kick_, &acceleration_}) rows->assign(4 * count, 0);
  motion_.resize(4 * kept_rows_);
  motion_.resize(4 * count, 0);
  turn_.resize(kept_rows_);
  turn_.resize(count, 0);
  for (std::size_t i = 0; i < present_.size(); ++i) {
    const std::uint32_t body = present_[i];
    if (body == nowhere) continue;
    const Velocity& v = bodies.velocity[body];
    std::copy_n(std::array{v.v.x, v.v.y, v.w, bodies.inverse_mass[body].m}.begin(), 4, &velocity_[4 * i]);
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

void Pile::substep(const Island& island, bool first) {
  if (island.more_sweeps > 0) {
    start_energy_ = kinetic_energy();
    start_motion_ = motion_;
    start_turn_ = turn_;
  }
  kernels_->kick_bodies(rows_, first);
  for_both([&](PileLanes& lanes) { lanes.press(rows_, island.h); });
  if (kernels_->drift_bodies(rows_, island.h)) turn_far();
  for (int sweep = 0; sweep < island.sweeps; ++sweep) {
    for_both([&](PileLanes& lanes) { lanes.relax(rows_, sweep > 0); });
  }
  if (island.more_sweeps > 0) relax_until_bounded(island);
  if (island.settling) lanes_->settle(true);
}

/// As Accurate::relax_until_bounded.
void Pile::relax_until_bounded(const Island& island) {
  const Real rounding = 64 * std::numeric_limits<Real>::epsilon();
  const Real most = start_energy_ + work() + rounding * start_energy_;
  for (Descent descent(island.more_sweeps); descent.goes_on(kinetic_energy() - most);) {
    for_both([this](PileLanes& lanes) { lanes.relax(rows_, true); });
  }
}

void Pile::leave(const StepData& data, const Island& island, const RowOf& row_of, std::vector<Motion>& motion) {
  lanes_->store();
  for (const std::uint32_t body : island.bodies) {
    const std::size_t i = row_of[body];
    motion[body] = {{motion_[4 * i], motion_[4 * i + 1]}, turn_[i], motion_[4 * i + 2], motion_[4 * i + 3]};
    if (data.bodies.pushable(body)) {
      data.bodies.velocity[body] = {{velocity_[4 * i], velocity_[4 * i + 1]}, velocity_[4 * i + 2]};
    }
  }
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

/// Of the bodies that can be pushed; the others do not share in an island's energy.
void Pile::weigh(const StepData& data, const Island& island, const RowOf& row_of) {
  mass_.assign(velocity_.size(), 0);
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const InverseMass& inverse = data.bodies.inverse_mass[island.bodies[i]];
    Real* mass = &mass_[std::size_t{4} * row_of[island.bodies[i]]];
    if (inverse.m > 0) mass[0] = mass[1] = 1 / inverse.m;
    if (inverse.i > 0) mass[2] = 1 / inverse.i;
  }
}

/// J. In several sums at once, here and below: a single one would wait at every body for the body before.
Real Pile::kinetic_energy() const {
  std::array<Real, block> sums{};
  for (std::size_t i = 0; i < velocity_.size(); i += block) {
    for (std::size_t k = 0; k < block; ++k) sums[k] += mass_[i + k] * velocity_[i + k] * velocity_[i + k];
  }
  return std::accumulate(sums.begin(), sums.end(), Real{0}) / 2;
}

/// J, that the forces gave in this sub-step.
Real Pile::work() const {
  std::array<Real, 4> sums{};
  for (std::size_t i = 0; i < turn_.size(); i += sums.size()) {
    for (std::size_t k = 0; k < sums.size(); ++k) {
      const std::size_t body = i + k;
      const Real* a = &acceleration_[4 * body];
      const Real* now = &motion_[4 * body];
      const Real* then = &start_motion_[4 * body];
      const Real* mass = &mass_[4 * body];
      sums[k] += mass[0] * (a[0] * (now[0] - then[0]) + a[1] * (now[1] - then[1])) +
                 mass[2] * (a[2] * (turn_[body] - start_turn_[body]));
    }
  }
  return std::accumulate(sums.begin(), sums.end(), Real{0});
}

}  // namespace impulse::inline IMPULSE_PRECISION
