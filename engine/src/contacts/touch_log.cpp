#include "contacts/touch_log.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

bool touches(const ContactPoint& point) { return point.separation <= 0 || point.total_normal_impulse > 0; }

/// `count` is the number of the contact's points that touch.
TouchingParts touching_parts(const BodySet& bodies, const Contact& contact, int count) {
  TouchingParts pair;
  pair.a = bodies.id(contact.body_a);
  pair.b = bodies.id(contact.body_b);
  pair.part_a = contact.part_a;
  pair.part_b = contact.part_b;
  pair.normal = contact.normal;
  Vec2 arms;
  for (std::size_t p = 0; p < static_cast<std::size_t>(contact.count); ++p) {
    const ContactPoint& point = contact.points[p];
    if (!touches(point)) continue;
    arms += point.arm_a + point.arm_b;
    pair.normal_impulse += point.total_normal_impulse;
    pair.tangent_impulse += point.total_tangent_impulse;
  }
  const Vec2 centers = bodies.pose[contact.body_a].p + bodies.pose[contact.body_b].p;
  pair.point = Real{0.5} * (centers + arms / static_cast<Real>(count));
  return pair;
}

/// The order of contacts. The generation distinguishes a body from an earlier one with the same index.
auto key(const TouchingParts& pair) {
  const auto joined = [](std::uint64_t high, std::uint64_t low) { return high << 32 | low; };
  return std::tuple(joined(pair.a.index, pair.b.index), joined(pair.part_a, pair.part_b),
                    joined(pair.a.generation, pair.b.generation));
}

// A lambda, so that sorting can inline it.
constexpr auto before = [](const TouchingParts& left, const TouchingParts& right) { return key(left) < key(right); };

}  // namespace

void TouchLog::note(const BodySet& bodies, std::span<const Contact> contacts) {
  std::swap(awake_, last_);
  const bool changed = sleep_changes_ != bodies.sleep_changes;
  if (changed) follow_sleep(bodies);
  awake_.clear();
  begun_.clear();
  ended_.clear();
  // One pass over both sorted lists.
  auto old = last_.cbegin();
  for (const Contact& contact : contacts) {
    const auto count = std::count_if(contact.points.begin(), contact.points.begin() + contact.count, touches);
    if (count == 0) continue;
    const TouchingParts& now = awake_.emplace_back(touching_parts(bodies, contact, static_cast<int>(count)));
    while (old != last_.cend() && before(*old, now)) ended_.push_back(*old++);
    if (old != last_.cend() && key(*old) == key(now)) {
      ++old;
    } else {
      begun_.push_back(now);
    }
  }
  ended_.insert(ended_.end(), old, last_.cend());
  if (asleep_.empty() || (!changed && awake_.empty() && last_.empty())) return;
  all_.clear();
  std::merge(awake_.begin(), awake_.end(), asleep_.begin(), asleep_.end(), std::back_inserter(all_), before);
}

/// Pairs that fell asleep keep touching; pairs that woke are compared with this step's again.
void TouchLog::follow_sleep(const BodySet& bodies) {
  sleep_changes_ = bodies.sleep_changes;
  const auto move = [](std::vector<TouchingParts>& from, std::vector<TouchingParts>& to, const auto& stays) {
    const auto gone = std::stable_partition(from.begin(), from.end(), stays);
    to.insert(to.end(), gone, from.end());
    from.erase(gone, from.end());
    std::sort(to.begin(), to.end(), before);
  };
  const auto asleep = [&bodies](const TouchingParts& pair) {
    return bodies.contains(pair.a) && bodies.contains(pair.b) &&
           (bodies.asleep[pair.a.index] != 0 || bodies.asleep[pair.b.index] != 0);
  };
  move(asleep_, last_, asleep);
  move(last_, asleep_, [&](const TouchingParts& pair) { return !asleep(pair); });
}

}  // namespace impulse::inline IMPULSE_PRECISION
