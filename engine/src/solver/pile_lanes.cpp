#include "solver/pile_lanes.h"

#include <span>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

const Contact no_contact{};

/// What is the same for all contacts of an island.
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
      rule.strength[web][fixed] = soft.strength;
      rule.rate[web][fixed] = soft.rate;
      rule.relief[web][fixed] = soft.relief;
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
    const std::span<const LanesRun> runs = colouring.runs();
    table_ = {one_.data(),    discs_.data(),        two_.data(), block_.data(),
              smooth_.data(), smooth_discs_.data(), runs.data(), runs.data() + runs.size()};
    passes_.lay_out(table_, input_);
  }

  void begin_late(const BodyRows& bodies) override { passes_.begin_late(table_, bodies); }
  void kick(const BodyRows& bodies) override { passes_.kick(table_, bodies); }
  void press(const BodyRows& bodies, Real h) override { passes_.press(table_, bodies, soft_, h); }
  void relax(const BodyRows& bodies, bool again) override { passes_.relax(table_, bodies, again); }
  void settle(bool settling) override { passes_.settle(table_, soft_, settling); }
  void store() override { passes_.store(table_, input_); }

 private:
  template <class Lanes>
  void make_room(const Colouring& colouring, LanesKind kind, std::vector<Lanes>& all) {
    const std::span<const Slot> slots = colouring.lanes(kind);
    const auto number = static_cast<std::size_t>(kind);
    all.resize(slots.size() / width);
    input_.slots[number] = slots.data();
    input_.groups[number] = static_cast<std::uint32_t>(all.size());
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

}  // namespace

std::unique_ptr<PileLanes> PileLanes::make(const SolverKernels& kernels) {
  if (kernels.contacts_by_sixteen != nullptr) return std::make_unique<PileLanesOf<16>>(*kernels.contacts_by_sixteen);
  return std::make_unique<PileLanesOf<8>>(*kernels.contacts_by_eight);
}

}  // namespace impulse::inline IMPULSE_PRECISION
