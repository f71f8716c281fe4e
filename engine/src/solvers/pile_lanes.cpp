#include "solvers/pile_lanes.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <type_traits>

#include "contact_rows.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

void fetch(const std::vector<Contact>& contacts, const Slot& slot) {
  if (slot.tie.contact == Slot::empty) return;
  constexpr std::size_t cache_line = 64;
  const char* begin = reinterpret_cast<const char*>(&contacts[slot.tie.contact]);
  for (std::size_t i = 0; i < sizeof(Contact); i += cache_line) __builtin_prefetch(begin + i);
}

/// What all contacts of a pile are laid out by.
struct Layout {
  const StepData& data;
  const Island& island;
  const std::vector<std::uint32_t>& row_of;
  std::uint32_t nobody;
};

template <std::size_t width>
class PileLanesOf : public PileLanes {
 public:
  explicit PileLanesOf(const ContactPasses<width>& passes) : passes_(passes) {}

  std::uint32_t at_a_time() const override { return width; }

  void lay_out(const StepData& data, const Island& island, const Colouring& colouring,
               const std::vector<std::uint32_t>& row_of, std::uint32_t nobody) override {
    const Layout layout{data, island, row_of, nobody};
    fill_all(layout, colouring.lanes(LanesKind::one), one_);
    fill_all(layout, colouring.lanes(LanesKind::discs), discs_);
    fill_all(layout, colouring.lanes(LanesKind::two), two_);
    fill_all(layout, colouring.lanes(LanesKind::block), block_);
    const std::span<const LanesRun> runs = colouring.runs();
    table_ = {one_.data(), discs_.data(), two_.data(), block_.data(), runs.data(), runs.data() + runs.size()};
  }

  void weigh() override { passes_.weigh(table_); }
  void kick(const BodyRows& bodies) override { passes_.kick(table_, bodies); }
  void press(const BodyRows& bodies, Real h) override { passes_.press(table_, bodies, h); }
  void relax(const BodyRows& bodies, bool again) override { passes_.relax(table_, bodies, again); }
  void settle(bool settling) override { passes_.settle(table_, settling); }

  void store(const StepData& data, const Island& island, const Colouring& colouring) override {
    store_all(data, island, colouring.lanes(LanesKind::one), one_);
    store_all(data, island, colouring.lanes(LanesKind::discs), discs_);
    store_all(data, island, colouring.lanes(LanesKind::two), two_);
    store_all(data, island, colouring.lanes(LanesKind::block), block_);
  }

 private:
  // Lane by lane: what is written stays in the first cache, and what is read ahead is asked for in time.
  template <class Lanes>
  void fill_all(const Layout& layout, std::span<const Slot> slots, std::vector<Lanes>& all) {
    all.resize(slots.size() / width);
    for (std::size_t at = 0; at < slots.size(); ++at) {
      Lanes& lanes = all[at / width];
      const std::size_t lane = at % width;
      if (lane == 0) {
        lanes.any_fresh = false;
        if (slots[at + width - 1].tie.contact == Slot::empty) clear(lanes, layout.nobody);
      }
      if (at + ahead < slots.size()) fetch(layout.data.contacts, slots[at + ahead]);
      if (slots[at].tie.contact != Slot::empty) fill(layout, slots[at], lane, lanes);
    }
  }

  template <class Lanes>
  static void clear(Lanes& lanes, std::uint32_t nobody) {
    lanes = {};
    std::fill_n(lanes.a, width, nobody);
    std::fill_n(lanes.b, width, nobody);
  }

  template <class Lanes>
  static void fill(const Layout& layout, const Slot& slot, std::size_t lane, Lanes& lanes) {
    const Island& island = layout.island;
    const BodySet& bodies = layout.data.bodies;
    const Contact& contact = layout.data.contacts[slot.tie.contact];
    const InverseMass& mass_a = bodies.inverse_mass[slot.tie.a];
    const InverseMass& mass_b = bodies.inverse_mass[slot.tie.b];
    const Softness& soft = island.softness(slot.web, mass_a, mass_b);
    const auto put = [lane](Row<width>& to, Real value) { to.lane[lane] = value; };
    lanes.a[lane] = layout.row_of[slot.tie.a];
    lanes.b[lane] = layout.row_of[slot.tie.b];
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
    if constexpr (std::is_same_v<Lanes, DiscLanes<width>>) {
      const Vec2 between = bodies.pose[slot.tie.b].p - bodies.pose[slot.tie.a].p;
      put(lanes.between_x, between.x);
      put(lanes.between_y, between.y);
      put(lanes.distance, contact.radius_a + contact.radius_b);
    }
    const Real share = 1 / static_cast<Real>(island.substeps);
    for (std::size_t i = 0; i < std::size(lanes.point); ++i) {
      PointLanes<width>& to = lanes.point[i];
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

  template <class Lanes>
  static void store_all(const StepData& data, const Island& island, std::span<const Slot> slots,
                        const std::vector<Lanes>& all) {
    for (std::size_t at = 0; at < slots.size(); ++at) {
      if (at + ahead < slots.size()) fetch(data.contacts, slots[at + ahead]);
      if (slots[at].tie.contact == Slot::empty) continue;
      store_one(island, all[at / width], at % width, data.contacts[slots[at].tie.contact]);
    }
  }

  template <class Lanes>
  static void store_one(const Island& island, const Lanes& lanes, std::size_t lane, Contact& contact) {
    const auto substeps = static_cast<Real>(island.substeps);
    for (std::size_t i = 0; i < std::size(lanes.point); ++i) {
      const PointLanes<width>& from = lanes.point[i];
      ContactPoint& to = contact.points[i];
      to.normal_impulse = from.normal_impulse.lane[lane] * substeps;
      to.tangent_impulse = from.tangent_impulse.lane[lane] * substeps;
      to.total_normal_impulse = from.total_normal.lane[lane];
      to.total_tangent_impulse = from.total_tangent.lane[lane];
    }
    contact.offset = lanes.offset.lane[lane];
  }

  static constexpr std::size_t ahead = 8;  // lanes, by which contacts are fetched before they are needed

  const ContactPasses<width>& passes_;
  std::vector<ContactLanes<1, width>> one_;
  std::vector<DiscLanes<width>> discs_;
  std::vector<ContactLanes<2, width>> two_;
  std::vector<ContactLanes<2, width>> block_;
  ContactTable<width> table_{};
};

}  // namespace

std::unique_ptr<PileLanes> PileLanes::make(const Kernels& kernels) {
  if (kernels.contacts_by_sixteen != nullptr) return std::make_unique<PileLanesOf<16>>(*kernels.contacts_by_sixteen);
  return std::make_unique<PileLanesOf<8>>(*kernels.contacts_by_eight);
}

}  // namespace impulse::inline IMPULSE_PRECISION
