#include "solver/pile.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "contacts/contact_rows.h"
#include "core/stages.h"
#include "solver/energy_bound.h"
#include "solver/turning.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

const Contact no_contact{};

/// The layout input common to all contacts of an island.
LayoutInput input_of(std::span<Contact> contacts, const BodySet& bodies, const Island& island,
                     const std::vector<std::uint32_t>& row_of, std::uint32_t no_row) {
  LayoutInput input{};
  input.contacts = contacts.data();
  input.no_contact = &no_contact;
  input.masses = bodies.inverse_mass.data();
  input.poses = bodies.pose.data();
  input.row_of = row_of.data();
  input.nobody = no_row;
  input.offset_from_age = OffsetRule::from_age;
  input.substeps = static_cast<Real>(island.substeps);
  return input;
}

SoftRule rule_of(const Island& island) {
  SoftRule rule{};
  for (const std::size_t web : {0, 1}) {
    for (const std::size_t fixed : {0, 1}) {
      const Island::Softnesses& softnesses = web == 1 ? island.web : island.column;
      const Softness& soft = fixed == 1 ? softnesses.fixed : softnesses.movable;
      rule.strength[web][fixed] = soft.mass_scale;
      rule.rate[web][fixed] = soft.bias_rate;
      rule.relief[web][fixed] = soft.impulse_scale;
      rule.give[web][fixed] = 1 / (2 * island.h * soft.omega * soft.omega);
      rule.gain[web][fixed] = island.offsets.gain(soft);
    }
  }
  rule.leak = island.offsets.leak();
  return rule;
}

template <std::size_t width>
class PileLanesOf : public PileLanes {
 public:
  explicit PileLanesOf(const ContactPasses<width>& passes) : passes_(passes) {}

  std::unique_ptr<PileLanes> copy(std::span<Contact> contacts, const Colouring& colouring) const override {
    auto made = std::make_unique<PileLanesOf>(*this);
    made->input_.contacts = contacts.data();
    made->refer_to(colouring);
    return made;
  }

  std::uint32_t at_a_time() const override { return width; }

  void lay_out(std::span<Contact> contacts, const BodySet& bodies, const Island& island, const Colouring& colouring,
               const std::vector<std::uint32_t>& row_of, std::uint32_t no_row) override {
    input_ = input_of(contacts, bodies, island, row_of, no_row);
    soft_ = rule_of(island);
    make_room(colouring, LanesKind::one, one_);
    make_room(colouring, LanesKind::discs, discs_);
    make_room(colouring, LanesKind::two, two_);
    make_room(colouring, LanesKind::block, block_);
    make_room(colouring, LanesKind::smooth, smooth_);
    make_room(colouring, LanesKind::smooth_discs, smooth_discs_);
    refer_to(colouring);
    passes_.lay_out(table_, input_);
  }

  void begin_late(const BodyRows& bodies) override { passes_.begin_late(table_, bodies); }
  void kick(const BodyRows& bodies) override { passes_.kick(table_, bodies); }
  void press(const BodyRows& bodies, Real h) override { passes_.press(table_, bodies, soft_, h); }
  void relax(const BodyRows& bodies, bool again) override { passes_.relax(table_, bodies, again); }
  void meet(const BodyRows& bodies, Real slow) override { passes_.meet(table_, bodies, slow); }
  bool stick_or_slip(const BodyRows& bodies, Real slow_in_web) override {
    return passes_.stick_or_slip(table_, bodies, no_slip, slow_in_web);
  }
  void settle(bool settling) override { passes_.settle(table_, soft_, settling); }
  void store() override { passes_.store(table_, input_); }

 private:
  template <class Lanes>
  static void make_room(const Colouring& colouring, LanesKind kind, std::vector<Lanes>& all) {
    all.resize(colouring.lanes(kind).size() / width);
  }

  void refer_to(const Colouring& colouring) {
    for (std::size_t number = 0; number < lanes_kinds; ++number) {
      const std::span<const Slot> slots = colouring.lanes(static_cast<LanesKind>(number));
      input_.slots[number] = slots.data();
      input_.groups[number] = static_cast<std::uint32_t>(slots.size() / width);
    }
    const std::span<const LanesRun> runs = colouring.runs();
    table_ = {one_.data(),    discs_.data(),        two_.data(), block_.data(),
              smooth_.data(), smooth_discs_.data(), runs.data(), runs.data() + runs.size()};
  }

  const ContactPasses<width>& passes_;
  LayoutInput input_{};
  SoftRule soft_{};
  std::vector<ContactLanes<1, width>> one_;
  std::vector<DiscLanes<width>> discs_;
  std::vector<ContactLanes<2, width>> two_;
  std::vector<ContactLanes<2, width>> block_;
  std::vector<SmoothLanes<width>> smooth_;
  std::vector<SmoothDiscLanes<width>> smooth_discs_;
  ContactTable<width> table_{};
};

/// Contacts from which laying them out in lanes pays.
constexpr std::size_t least_pile = 64;

void scale_offsets(const StepData& data, const Island& island, Real by) {
  if (by == 1) return;
  for (const Tie& tie : island.contacts) data.contacts[tie.contact].offset *= by;
}

constexpr std::uint32_t nowhere = ~std::uint32_t{0};
constexpr std::size_t block = 16;  // the most rows that kernels process at a time

std::size_t rounded_up(std::size_t count) { return (count + block - 1) / block * block; }

}  // namespace

std::unique_ptr<PileLanes> PileLanes::make(const SolverKernels& kernels) {
  if (kernels.contacts_by_sixteen != nullptr) return std::make_unique<PileLanesOf<16>>(*kernels.contacts_by_sixteen);
  return std::make_unique<PileLanesOf<8>>(*kernels.contacts_by_eight);
}

Pile::Pile(const Pile& other, std::span<Contact> contacts)
    : kernels_(other.kernels_),
      lanes_(PileLanes::make(*kernels_)),
      kept_colouring_(other.kept_colouring_),
      kept_rows_(other.kept_rows_),
      present_(other.present_),
      motion_(other.motion_),
      turn_(other.turn_) {
  if (other.kept_ != nullptr) kept_ = other.kept_->copy(contacts, kept_colouring_);
}

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

/// Assigns rows: first the bodies of kept contacts, then bodies of the island, then those that it touches and does not
/// move, then at least one unused row.
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

/// Motions of kept rows continue; the others start at 0.
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
  if (island.two_frictions) {
    for_both([&](PileLanes& lanes) { lanes.meet(rows_, slow_impact(island.pressing, island.h)); });
  }
  kernels_->kick_bodies(rows_, first);
  for_both([&](PileLanes& lanes) { lanes.press(rows_, island.h); });
  if (kernels_->drift_bodies(rows_, island.h)) turn_far();
  for (int sweep = 0; sweep < island.sweeps; ++sweep) {
    for_both([&](PileLanes& lanes) { lanes.relax(rows_, sweep > 0); });
  }
  if (island.two_frictions) {
    bool broke = false;
    for_both([&](PileLanes& lanes) { broke |= lanes.stick_or_slip(rows_, no_slip_in_web(island.pressing, island.h)); });
    if (broke) for_both([&](PileLanes& lanes) { lanes.relax(rows_, true); });
  }
  if (island.more_sweeps > 0) relax_until_bounded(island);
  if (island.settling) lanes_->settle(true);
}

/// Like Accurate::relax_until_bounded.
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

/// Recomputes sine and cosine of bodies that have rotated too far for the series of the kernel.
void Pile::turn_far() {
  for (std::size_t i = 0; i < turn_.size(); ++i) {
    Motion turned;
    turned.turn_by(turn_[i]);
    motion_[4 * i + 2] = turned.sine;
    motion_[4 * i + 3] = turned.drop;
  }
}

/// Sets the masses of the bodies that can be pushed; others do not count in an island's energy.
void Pile::weigh(const StepData& data, const Island& island, const RowOf& row_of) {
  mass_.assign(velocity_.size(), 0);
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const InverseMass& inverse = data.bodies.inverse_mass[island.bodies[i]];
    Real* mass = &mass_[std::size_t{4} * row_of[island.bodies[i]]];
    if (inverse.m > 0) mass[0] = mass[1] = 1 / inverse.m;
    if (inverse.i > 0) mass[2] = 1 / inverse.i;
  }
}

/// J. In several partial sums, here and below: in a single one every addition would wait for the one before.
Real Pile::kinetic_energy() const {
  std::array<Real, block> sums{};
  for (std::size_t i = 0; i < velocity_.size(); i += block) {
    for (std::size_t k = 0; k < block; ++k) sums[k] += mass_[i + k] * velocity_[i + k] * velocity_[i + k];
  }
  return std::accumulate(sums.begin(), sums.end(), Real{0}) / 2;
}

/// J, the work of the forces in this sub-step.
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

bool is_pile(const StepData& data, const Island& island) {
  if (island.contacts.size() < least_pile || !island.joints.empty()) return false;
  const bool is_few = few(island);
  return std::none_of(island.contacts.begin(), island.contacts.end(), [&](const Tie& tie) {
    const Contact& contact = data.contacts[tie.contact];
    return contact.restitution > 0 ||
           (is_few && !contact.discs() && stir_of(contact, data.bodies).moves(data.settings.dt));
  });
}

void plan_pile(const StepData& data, const Partition& parts, Island& island,
               const std::vector<Velocity>& acceleration) {
  Bearing bearing;
  if (may_need_substeps(island.bodies.size(), data.settings)) {
    for (const Tie& tie : island.contacts) {
      const Contact& contact = data.contacts[tie.contact];
      const ContactRow row = make_row(data.bodies, data.contacts, tie.contact);
      bearing.add(row);
      if (contact.age >= OffsetRule::from_age) bearing.add_load(row, parts.in_web(tie), contact.offset, data.settings);
    }
  }
  island.cut(data.settings, substeps_for(island, bearing, data.bodies, acceleration, data.settings));
  end_stage("pile: bearing");
  rub(island, acceleration);
  island.settling = settles(data, island);
  if (island.settling) island.sweeps = settling_sweeps_for(island.bodies.size());
  relax_blows(data, island);
  end_stage("pile: struck");
}

void rub(Island& island, const std::vector<Velocity>& acceleration) {
  island.two_frictions = island.two_frictions || std::any_of(island.contacts.begin(), island.contacts.end(),
                                                             [](const Tie& tie) { return tie.two_frictions; });
  if (!island.two_frictions) return;
  for (const std::uint32_t body : island.bodies) {
    island.pressing = std::max(island.pressing, length(acceleration[body].v));
  }
}

bool is_struck(const StepData& data, const Island& island) {
  return std::any_of(island.contacts.begin(), island.contacts.end(), [&](const Tie& tie) {
    return new_or_deep(data.contacts[tie.contact]) &&
           at_speed(make_row(data.bodies, data.contacts, tie.contact), data.bodies);
  });
}

void relax_blows(const StepData& data, Island& island) {
  const int more_sweeps = closed(data.bodies, island.bodies) ? more_sweeps_for(island.bodies.size()) : 0;
  if (more_sweeps > 0 && is_struck(data, island)) island.more_sweeps = more_sweeps;
}

void step_as_pile(StepData& data, const Partition& parts, const Island& island,
                  const std::vector<Velocity>& acceleration, std::vector<Motion>& motion, Pile& pile,
                  Pile::RowOf& row_of) {
  scale_offsets(data, island, island.offset_scale);
  pile.step(data, parts, island, acceleration, motion, row_of);
  scale_offsets(data, island, 1 / island.offset_scale);
}

}  // namespace impulse::inline IMPULSE_PRECISION
