#include "solver/resting_piles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "contacts/contact_search.h"
#include "contacts/lanes/persistence.h"
#include "solver/lanes/kernels.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Steps between two looks at the motion of bodies. A body is calm if it moves so little between two that it would stay
/// within the tolerance for sixteen times as long; and at two consecutive looks, so that a turning point does not
/// count.
constexpr int look_every = 8;
constexpr Real calm_way = RestingPile::tremor / 16;
constexpr std::uint8_t long_calm = 2;

/// Whether keeping this many contacts pays, with this many others that are laid out in every step.
constexpr std::size_t least_kept = 64;
bool pays(std::size_t kept, std::size_t others) { return kept >= least_kept && kept >= 3 * others; }

/// A pile is rebuilt with more contacts if 1/16 as many others have become calm. In between there are up to look_every
/// steps without a pile at rest.
constexpr std::size_t worth_beginning_anew = 16;

/// m, bound of the displacement of any point of a body between two poses.
Real way(const Pose& then, const Pose& now, Real reach) {
  return length(now.p - then.p) + std::abs((now.q * then.q.inverse()).s) * reach;
}

std::vector<std::uint32_t> bodies_of(std::span<const Tie> ties) {
  std::vector<std::uint32_t> bodies;
  for (const Tie& tie : ties) {
    if (tie.pushes_a) bodies.push_back(tie.a);
    if (tie.pushes_b) bodies.push_back(tie.b);
  }
  std::sort(bodies.begin(), bodies.end());
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  return bodies;
}

bool something_drives(const BodySet& bodies) {
  bool drives = false;
  for (std::size_t i = 0; i < bodies.size(); ++i) drives |= !bodies.pushable(i) && bodies.moves(i);
  return drives;
}

/// Recomputes the point of two discs, which lies on the line of their centres.
void meet_again(Contact& contact, const BodySet& bodies) {
  const Vec2 between = bodies.pose[contact.body_b].p - bodies.pose[contact.body_a].p;
  const Real distance = length(between);
  if (distance == 0) return;
  ContactPoint& point = contact.points[0];
  contact.normal = between / distance;
  point.separation = distance - (contact.radius_a + contact.radius_b);
  point.arm_a = (contact.radius_a + point.separation / 2) * contact.normal;
  point.arm_b = -(contact.radius_b + point.separation / 2) * contact.normal;
}

}  // namespace

RestingPile::RestingPile(const StepData& data, const Partition& parts, const Island& island, std::vector<Tie> kept,
                         std::vector<Tie> others, Pile::RowOf& row_of)
    : members_(bodies_of(kept)),
      ties_(std::move(kept)),
      others_(std::move(others)),
      last_(members_.size()),
      pile_(solver_kernels()),
      substeps_(island.substeps),
      offset_scale_(island.offset_scale),
      webbed_(island.webbed),
      heap_(island.heap),
      two_frictions_(island.two_frictions) {
  for (Tie& tie : ties_) {
    contacts_.push_back(data.contacts[tie.contact]);
    contacts_.back().offset *= offset_scale_;
    tie.contact = static_cast<std::uint32_t>(contacts_.size() - 1);
  }
  numbers_.resize(contacts_.size());
  std::iota(numbers_.begin(), numbers_.end(), 0U);
  persistent_.resize(contacts_.size());
  Island own = island;
  own.bodies = members_;
  own.contacts = ties_;
  pile_.keep(contacts_, data.bodies, parts, own, row_of);
}

RestingPile::RestingPile(const RestingPile& other)
    : members_(other.members_),
      contacts_(other.contacts_),
      ties_(other.ties_),
      others_(other.others_),
      numbers_(other.numbers_),
      persistent_(other.persistent_),
      last_(other.last_),
      pile_(other.pile_, contacts_),
      substeps_(other.substeps_),
      offset_scale_(other.offset_scale_),
      webbed_(other.webbed_),
      heap_(other.heap_),
      two_frictions_(other.two_frictions_),
      steps_(other.steps_),
      rests_(other.rests_) {}

void RestingPile::step(StepData& data, const Partition& parts, Island island, const std::vector<Velocity>& acceleration,
                       std::vector<Motion>& motion, Pile::RowOf& row_of) {
  island.webbed = webbed_;
  island.heap = heap_;
  island.cut(data.settings, substeps_);
  island.two_frictions = two_frictions_;
  rub(island, acceleration);
  relax_blows(data, island);
  step_as_pile(data, parts, island, acceleration, motion, pile_, row_of);
  ++steps_;
  rests_ = pays(contacts_.size(), island.contacts.size());
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const std::uint32_t body = members_[i];
    const Motion now = motion[body];
    const Motion then = std::exchange(last_[i], now);
    motion[body].d = now.d - then.d;
    motion[body].turn = now.turn - then.turn;
    const Velocity& v = data.bodies.velocity[body];
    const Real reach = data.bodies.bounding_radius[body];
    const Real next = data.settings.dt * (length(v.v) + std::abs(v.w) * reach);
    rests_ &= length(now.d) + std::abs(now.turn) * reach + next <= tremor;
  }
}

void RestingPile::append(const BodySet& bodies, std::vector<Contact>& to) {
  pile_.store_kept();
  const std::size_t before = to.size();
  to.insert(to.end(), contacts_.begin(), contacts_.end());
  const std::span<Contact> now = std::span(to).subspan(before);
  constexpr Real infinity = std::numeric_limits<Real>::infinity();
  contact_kernels().persist_points(now.data(), numbers_.data(), static_cast<std::uint32_t>(now.size()),
                                   bodies.pose.data(), bodies.bounding_radius.data(), {infinity, infinity},
                                   persistent_.data());
  for (Contact& contact : now) {
    contact.offset /= offset_scale_;
    contact.age += steps_ - 1;  // one was counted when they were measured
    if (contact.discs()) meet_again(contact, bodies);
  }
}

void RestingPiles::copy(const RestingPiles& from) {
  piles_.clear();
  for (const std::unique_ptr<RestingPile>& pile : from.piles_) {
    piles_.push_back(pile == nullptr ? nullptr : std::make_unique<RestingPile>(*pile));
  }
  count_ = from.count_;
  steps_ = from.steps_;
  due_ = from.due_;
  seen_ = from.seen_;
  calm_ = from.calm_;
}

// A body that moves without being pushable may hit bodies that the search treats as fixed: no pile may rest then.
void RestingPiles::rouse(BodySet& bodies, std::vector<Contact>& to) {
  if (empty()) return;
  if (something_drives(bodies)) return let_go(bodies, to);
  for (std::uint32_t i = 0; i < piles_.size(); ++i) {
    if (piles_[i] != nullptr && !piles_[i]->rests()) let_go(i + 1, bodies, to);
  }
}

void RestingPiles::let_go(std::uint32_t pile, BodySet& bodies, std::vector<Contact>& to) {
  std::unique_ptr<RestingPile>& gone = piles_[pile - 1];
  if (gone == nullptr) return;
  gone->append(bodies, to);
  for (const std::uint32_t body : gone->members()) bodies.pile[body] = 0;
  ++bodies.pile_changes;
  gone = nullptr;
  --count_;
}

void RestingPiles::let_go(BodySet& bodies, std::vector<Contact>& to) {
  for (std::uint32_t i = 0; i < piles_.size(); ++i) let_go(i + 1, bodies, to);
}

void RestingPiles::append(const BodySet& bodies, std::vector<Contact>& to) const {
  for (const std::unique_ptr<RestingPile>& pile : piles_) {
    if (pile != nullptr) pile->append(bodies, to);
  }
}

void RestingPiles::watch(const StepData& data) {
  const BodySet& bodies = data.bodies;
  due_ = false;
  if (data.contacts.size() < least_kept && empty()) return calm_.clear();
  if (++steps_ % look_every != 0) return;
  seen_.resize(bodies.size());
  calm_.resize(bodies.size());
  due_ = data.may_rest && !something_drives(bodies);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Pose then = std::exchange(seen_[i], bodies.pose[i]);
    const bool calm = way(then, bodies.pose[i], bodies.bounding_radius[i]) <= calm_way;
    calm_[i] = calm ? static_cast<std::uint8_t>(std::min(calm_[i] + 1, int{long_calm})) : std::uint8_t{0};
  }
}

bool RestingPiles::let_go_hindered(StepData& data, const Partition& parts) {
  BodySet& bodies = data.bodies;
  std::vector<Contact> contacts;
  if (!data.may_rest) let_go(bodies, contacts);
  for (std::size_t island = 0; island < parts.size() && !empty(); ++island) {
    std::vector<std::uint32_t> held;
    for (const std::uint32_t body : parts.bodies(island)) {
      const std::uint32_t pile = bodies.pile[body];
      if (pile != 0 && std::find(held.begin(), held.end(), pile) == held.end()) held.push_back(pile);
    }
    if (held.empty()) continue;
    const std::span<const Tie> met = parts.contacts(island);
    const bool rebounds =
        std::any_of(met.begin(), met.end(), [&](const Tie& tie) { return data.contacts[tie.contact].restitution > 0; });
    const bool cut_finer = !met.empty() && !is_large(parts.bodies(island).size(), data.settings);
    const bool only_contacts = parts.joints(island).empty() && !parts.varies(island);
    if (held.size() == 1 && only_contacts && !rebounds && !cut_finer) continue;
    for (const std::uint32_t pile : held) let_go(pile, bodies, contacts);
  }
  if (contacts.empty()) return false;
  data.contacts.insert(data.contacts.end(), contacts.begin(), contacts.end());
  std::sort(data.contacts.begin(), data.contacts.end(), comes_before);
  data.contact_changes = 0;
  return true;
}

bool RestingPiles::calm(const BodySet& bodies, const Tie& tie) const {
  const auto still = [&](std::uint32_t body) { return calm_[body] == long_calm || !bodies.pushable(body); };
  return still(tie.a) && still(tie.b);
}

bool RestingPiles::may_grow(const StepData& data, const Island& island, const RestingPile& pile) const {
  if (!due_) return false;
  const auto calm_ones = std::count_if(island.contacts.begin(), island.contacts.end(), [&](const Tie& tie) {
    return calm(data.bodies, tie) && data.contacts[tie.contact].age >= OffsetRule::from_age;
  });
  return static_cast<std::size_t>(calm_ones) * worth_beginning_anew > pile.size();
}

RestingPile* RestingPiles::of(const BodySet& bodies, std::span<const std::uint32_t> island) const {
  if (empty()) return nullptr;
  const auto member =
      std::find_if(island.begin(), island.end(), [&](std::uint32_t body) { return bodies.pile[body] != 0; });
  return member == island.end() ? nullptr : piles_[bodies.pile[*member] - 1].get();
}

std::unique_ptr<RestingPile> RestingPiles::part_at_rest(const StepData& data, const Partition& parts,
                                                        const Island& island, Pile::RowOf& row_of) {
  if (!due_ || island.settling || island.more_sweeps > 0) return nullptr;
  const BodySet& bodies = data.bodies;
  for (const Tie& tie : island.contacts) {
    const Contact& contact = data.contacts[tie.contact];
    if (contact.age >= OffsetRule::from_age) continue;
    if (tie.pushes_a) calm_[tie.a] = 0;
    if (tie.pushes_b) calm_[tie.b] = 0;
  }
  std::vector<Tie> kept;
  std::vector<Tie> others;
  for (const Tie& tie : island.contacts) (calm(bodies, tie) ? kept : others).push_back(tie);
  if (!pays(kept.size(), others.size())) return nullptr;
  if (!others.empty() && !is_large(island.bodies.size(), data.settings)) return nullptr;
  return std::make_unique<RestingPile>(data, parts, island, std::move(kept), std::move(others), row_of);
}

void RestingPiles::add(std::unique_ptr<RestingPile> pile, BodySet& bodies) {
  auto place = std::find(piles_.begin(), piles_.end(), nullptr);
  if (place == piles_.end()) place = piles_.insert(place, nullptr);
  const auto number = static_cast<std::uint32_t>(place - piles_.begin() + 1);
  for (const std::uint32_t body : pile->members()) bodies.pile[body] = number;
  *place = std::move(pile);
  ++count_;
  ++bodies.pile_changes;
}

}  // namespace impulse::inline IMPULSE_PRECISION
