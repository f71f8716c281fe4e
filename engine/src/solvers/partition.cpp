#include "solvers/partition.h"

#include <algorithm>
#include <numeric>

namespace impulse::inline IMPULSE_PRECISION {

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
  const BodySet& bodies = data.bodies;
  const auto pushable = [&](std::uint32_t body) {
    return bodies.inverse_mass[body].m + bodies.inverse_mass[body].i > 0;
  };
  const auto tie = [&](std::uint32_t a, std::uint32_t b) {
    if (bodies.stirs(a) && bodies.stirs(b)) islands_.tie(a, b);
  };
  islands_.clear(bodies.size());
  crowd_.assign(bodies.size(), 0);
  tied_.clear();
  for (std::uint32_t c = 0; c < data.contacts.size(); ++c) {
    const Contact& contact = data.contacts[c];
    const std::uint32_t a = contact.body_a;
    const std::uint32_t b = contact.body_b;
    const bool pushes_a = pushable(a);
    const bool pushes_b = pushable(b);
    if (contact.count == 0 || !(pushes_a || pushes_b)) continue;
    tied_.push_back({c, a, b, pushes_a, pushes_b, static_cast<std::uint8_t>(contact.count), contact.discs});
    tie(a, b);
    if (pushes_a) crowd_[a] = static_cast<std::uint8_t>(std::min(crowd_[a] + 1, 3));
    if (pushes_b) crowd_[b] = static_cast<std::uint8_t>(std::min(crowd_[b] + 1, 3));
  }
  all_joints_.clear();
  for (ActiveJoint& joint : data.joints) {
    all_joints_.push_back(&joint);
    tie(joint.block.a, joint.block.b);
  }
  if (together) {
    for (std::uint32_t body = 1; body < bodies.size(); ++body) islands_.tie(0, body);
  }
  islands_.number();

  contacts_.sort(tied_, islands_.size(), [&](const Tie& tied) { return islands_.of(tied.pushes_a ? tied.a : tied.b); });
  joints_.sort(all_joints_, islands_.size(), [&](const ActiveJoint* joint) {
    return islands_.of(pushable(joint->block.a) ? joint->block.a : joint->block.b);
  });
}

}  // namespace impulse::inline IMPULSE_PRECISION
