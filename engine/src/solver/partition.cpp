#include "solver/partition.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr std::uint32_t nobody = ~std::uint32_t{0};

// Bits of the kinds of bodies.
constexpr std::uint8_t stirs = 1;
constexpr std::uint8_t is_pushable = 2;

/// Whether the contact is frictionless and can neither rotate a body nor depend on a rotation.
bool smooth(const Contact& contact, bool stirs_a, bool stirs_b) {
  return contact.static_friction == 0 && (contact.disc_a || !stirs_a) && (contact.disc_b || !stirs_b);
}

}  // namespace

// Neighbours often belong to the same island: they are counted and copied together.
template <class Item>
template <class Source, class IslandOf>
void Partition::ByIsland<Item>::sort(const Source& source, std::size_t islands, IslandOf island_of) {
  const auto for_runs = [&](auto act) {
    for (auto first = source.begin(), end = first; first != source.end(); first = end) {
      const std::size_t island = island_of(*first);
      end = std::find_if(first, source.end(), [&](const Item& item) { return island_of(item) != island; });
      act(island, first, end);
    }
  };
  start.assign(islands + 1, 0);
  for_runs(
      [&](std::size_t island, auto first, auto end) { start[island + 1] += static_cast<std::size_t>(end - first); });
  std::partial_sum(start.begin(), start.end(), start.begin());
  next.assign(start.begin(), start.end() - 1);
  items.resize(source.size());
  for_runs([&](std::size_t island, auto first, auto end) {
    std::copy(first, end, items.begin() + static_cast<std::ptrdiff_t>(next[island]));
    next[island] += static_cast<std::size_t>(end - first);
  });
}

void Partition::split(const StepData& data) {
  const bool only_contacts = data.joints.empty() && data.forces.empty();
  if (!(nothing_changed(data) && only_contacts && only_contacts_)) split_anew(data, only_contacts);
  find_varying(data);
}

void Partition::split_anew(const StepData& data, bool only_contacts) {
  std::swap(tied_, last_tied_);
  list_ties(data);
  const bool same_bodies = crowd_.size() == data.bodies.size() &&
                           std::exchange(pile_changes_, data.bodies.pile_changes) == data.bodies.pile_changes;
  if (same_bodies && only_contacts && only_contacts_ && tied_ == last_tied_) return;
  only_contacts_ = only_contacts;
  ++version_;
  find_islands(data);
}

/// Whether the list of contacts would be that of the last step.
bool Partition::nothing_changed(const StepData& data) {
  std::swap(kinds_, last_kinds_);
  kinds_.resize(data.bodies.size());
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    kinds_[i] =
        static_cast<std::uint8_t>((data.bodies.moves(i) ? stirs : 0) | (data.bodies.pushable(i) ? is_pushable : 0));
  }
  const std::uint64_t before = std::exchange(contact_changes_, data.contact_changes);
  return before != 0 && before == contact_changes_ && kinds_ == last_kinds_;
}

void Partition::list_ties(const StepData& data) {
  tied_.clear();
  for (std::uint32_t c = 0; c < data.contacts.size(); ++c) {
    const Contact& contact = data.contacts[c];
    const std::uint32_t a = contact.body_a;
    const std::uint32_t b = contact.body_b;
    const bool pushes_a = (kinds_[a] & is_pushable) != 0;
    const bool pushes_b = (kinds_[b] & is_pushable) != 0;
    if (contact.count == 0 || !(pushes_a || pushes_b)) continue;
    const bool stirs_a = (kinds_[a] & stirs) != 0;
    const bool stirs_b = (kinds_[b] & stirs) != 0;
    tied_.push_back({c, a, b, pushes_a, pushes_b, stirs_a && stirs_b, static_cast<std::uint8_t>(contact.count),
                     contact.discs(), smooth(contact, stirs_a, stirs_b), contact.two_frictions()});
  }
}

void Partition::find_islands(const StepData& data) {
  const BodySet& bodies = data.bodies;
  islands_.clear(bodies.size());
  crowd_.assign(bodies.size(), 0);
  first_of_.clear();
  for (std::uint32_t body = 0; body < bodies.size(); ++body) {
    const std::uint32_t pile = bodies.pile[body];
    if (pile == 0) continue;
    crowd_[body] = 3;  // has the contacts that the pile keeps
    if (first_of_.size() < pile) first_of_.resize(pile, nobody);
    std::uint32_t& first = first_of_[pile - 1];
    if (first == nobody) first = body;
    islands_.connect(first, body);
  }
  const auto add = [this](std::uint32_t body) {
    crowd_[body] = static_cast<std::uint8_t>(std::min(crowd_[body] + 1, 3));
  };
  for (const Tie& tie : tied_) {
    if (tie.moves_both) islands_.connect(tie.a, tie.b);
    if (tie.pushes_a) add(tie.a);
    if (tie.pushes_b) add(tie.b);
  }
  all_joints_.clear();
  for (ActiveJoint& joint : data.joints) {
    all_joints_.push_back(&joint);
    if (bodies.moves(joint.block.a) && bodies.moves(joint.block.b)) islands_.connect(joint.block.a, joint.block.b);
  }
  // Whether a body comes into the reach of an attraction within the step is not known yet.
  pairs_.clear();
  data.forces.append_pairs(bodies, pairs_, std::numeric_limits<Real>::infinity());
  for (const auto& [a, b] : pairs_) {
    if (bodies.moves(a) && bodies.moves(b)) islands_.connect(a, b);
  }
  islands_.number();

  contacts_.sort(tied_, islands_.size(), [&](const Tie& tied) { return islands_.of(tied.pushes_a ? tied.a : tied.b); });
  joints_.sort(all_joints_, islands_.size(), [&](const ActiveJoint* joint) {
    return islands_.of(bodies.pushable(joint->block.a) ? joint->block.a : joint->block.b);
  });
  data.forces.list_pulls(bodies, all_pulls_);
  pulls_.sort(all_pulls_, islands_.size(), [&](const Pull& pull) { return islands_.of(pull.body); });
}

void Partition::find_varying(const StepData& data) {
  data.forces.find_varying(data.bodies, varying_);
  varies_.assign(islands_.size(), 0);
  for (std::uint32_t body = 0; body < varying_.size(); ++body) {
    if (varying_[body] != 0) varies_[islands_.of(body)] = 1;
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
