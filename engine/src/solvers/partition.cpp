#include "solvers/partition.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

bool pushable(const BodySet& bodies, std::size_t i) { return bodies.inverse_mass[i].m + bodies.inverse_mass[i].i > 0; }

/// Whether nothing that the contact gives can turn a body, and no turning is felt by it.
bool smooth(const BodySet& bodies, const Contact& contact) {
  return contact.static_friction == 0 && (contact.disc_a || !bodies.stirs(contact.body_a)) &&
         (contact.disc_b || !bodies.stirs(contact.body_b));
}

}  // namespace

template <class Item>
template <class Source, class IslandOf>
void Partition::ByIsland<Item>::sort(const Source& source, std::size_t islands, IslandOf island_of) {
  start.assign(islands + 1, 0);
  for (const Item& item : source) ++start[island_of(item) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  next.assign(start.begin(), start.end() - 1);
  items.resize(source.size());
  for (const Item& item : source) items[next[island_of(item)]++] = item;
}

void Partition::split(const StepData& data, bool together) {
  const bool only_contacts = data.joints.empty() && !together;
  if (nothing_changed(data) && only_contacts && only_contacts_) return;
  std::swap(tied_, last_tied_);
  list_ties(data);
  const bool same_bodies = crowd_.size() == data.bodies.size();
  if (same_bodies && only_contacts && only_contacts_ && tied_ == last_tied_) return;
  only_contacts_ = only_contacts;
  ++version_;
  find_islands(data, together);
}

/// Whether ties listed now would be those of the last step.
bool Partition::nothing_changed(const StepData& data) {
  std::swap(kinds_, last_kinds_);
  kinds_.resize(data.bodies.size());
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    kinds_[i] = static_cast<std::uint8_t>((data.bodies.stirs(i) ? 1 : 0) | (pushable(data.bodies, i) ? 2 : 0));
  }
  const std::uint64_t before = std::exchange(contact_changes_, data.contact_changes);
  return before != 0 && before == contact_changes_ && kinds_ == last_kinds_;
}

void Partition::list_ties(const StepData& data) {
  const BodySet& bodies = data.bodies;
  tied_.clear();
  for (std::uint32_t c = 0; c < data.contacts.size(); ++c) {
    const Contact& contact = data.contacts[c];
    const std::uint32_t a = contact.body_a;
    const std::uint32_t b = contact.body_b;
    const bool pushes_a = pushable(bodies, a);
    const bool pushes_b = pushable(bodies, b);
    if (contact.count == 0 || !(pushes_a || pushes_b)) continue;
    tied_.push_back({c, a, b, pushes_a, pushes_b, bodies.stirs(a) && bodies.stirs(b),
                     static_cast<std::uint8_t>(contact.count), contact.discs(), smooth(bodies, contact)});
  }
}

void Partition::find_islands(const StepData& data, bool together) {
  const BodySet& bodies = data.bodies;
  islands_.clear(bodies.size());
  crowd_.assign(bodies.size(), 0);
  const auto add = [this](std::uint32_t body) {
    crowd_[body] = static_cast<std::uint8_t>(std::min(crowd_[body] + 1, 3));
  };
  for (const Tie& tie : tied_) {
    if (tie.moves_both) islands_.tie(tie.a, tie.b);
    if (tie.pushes_a) add(tie.a);
    if (tie.pushes_b) add(tie.b);
  }
  all_joints_.clear();
  for (ActiveJoint& joint : data.joints) {
    all_joints_.push_back(&joint);
    if (bodies.stirs(joint.block.a) && bodies.stirs(joint.block.b)) islands_.tie(joint.block.a, joint.block.b);
  }
  if (together) {
    for (std::uint32_t body = 1; body < bodies.size(); ++body) islands_.tie(0, body);
  }
  islands_.number();

  contacts_.sort(tied_, islands_.size(), [&](const Tie& tied) { return islands_.of(tied.pushes_a ? tied.a : tied.b); });
  joints_.sort(all_joints_, islands_.size(), [&](const ActiveJoint* joint) {
    return islands_.of(pushable(bodies, joint->block.a) ? joint->block.a : joint->block.b);
  });
}

}  // namespace impulse::inline IMPULSE_PRECISION
