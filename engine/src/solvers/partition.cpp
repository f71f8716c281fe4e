#include "solvers/partition.h"

#include <algorithm>
#include <numeric>

#include "contact_rows.h"

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
    if (!solvable(bodies, contact)) continue;
    tied_.push_back(c);
    tie(contact.body_a, contact.body_b);
    for (const std::uint32_t body : {contact.body_a, contact.body_b}) {
      if (pushable(body)) crowd_[body] = static_cast<std::uint8_t>(std::min(crowd_[body] + 1, 3));
    }
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

  const auto island_of = [&](std::uint32_t a, std::uint32_t b) { return islands_.of(pushable(a) ? a : b); };
  contacts_.sort(tied_, islands_.size(),
                 [&](std::uint32_t c) { return island_of(data.contacts[c].body_a, data.contacts[c].body_b); });
  joints_.sort(all_joints_, islands_.size(),
               [&](const ActiveJoint* joint) { return island_of(joint->block.a, joint->block.b); });
}

}  // namespace impulse::inline IMPULSE_PRECISION
