#include "broad_phase/neighbours.h"

#include <algorithm>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// m, to each side: what a body that is all but still moves in many steps, and little beside the margin of contacts.
constexpr Real room = static_cast<Real>(0.02);

/// From so many proxies on, keeping pays; below, a search costs as little.
constexpr std::size_t least_proxies = 64;

/// One leaver costs about .15 ns for each proxy, a new search 30 to 40 ns.
constexpr std::size_t most_leavers = 64;

constexpr int soon = 4;   // steps: rooms that did not last so long were no use
constexpr int rest = 16;  // steps until they are tried again

}  // namespace

void Neighbours::find(BroadPhase& broad_phase, std::span<const Proxy> proxies, std::uint64_t version,
                      std::vector<Pair>& pairs) {
  if (proxies.size() < least_proxies) return broad_phase.find_pairs(proxies, pairs);
  if (!keep_near(proxies, version)) {
    if (version == version_ && steps_with_rooms_ < soon) steps_without_ = rest;
    if (steps_without_ > 0) {
      --steps_without_;
      version_ = 0;
      return broad_phase.find_pairs(proxies, pairs);
    }
    search_again(broad_phase, proxies);
    version_ = version;
    steps_with_rooms_ = 0;
  }
  ++steps_with_rooms_;
  pairs.resize(near_.size());
  pairs.resize(
      kernels().filter_pairs(proxies.data(), near_.data(), static_cast<std::uint32_t>(near_.size()), pairs.data()));
}

/// Whether `near_` could be kept up to date.
bool Neighbours::keep_near(std::span<const Proxy> proxies, std::uint64_t version) {
  if (version != version_) return false;
  leavers_.clear();
  for (std::uint32_t i = 0; i < proxies.size(); ++i) {
    if (within(proxies[i].bounds, rooms_[i].bounds)) continue;
    if (leavers_.size() == most_leavers) return false;
    leavers_.push_back(i);
  }
  if (!leavers_.empty()) follow_leavers(proxies);
  return true;
}

void Neighbours::give_room(std::span<const Proxy> proxies, std::uint32_t i) {
  rooms_[i] = proxies[i];
  rooms_[i].bounds = grown(proxies[i].bounds, room);
  rooms_[i].way = {};
  table_.set(i, rooms_[i].bounds, rooms_[i].way);
}

void Neighbours::search_again(BroadPhase& broad_phase, std::span<const Proxy> proxies) {
  rooms_.resize(proxies.size());
  left_.assign(proxies.size(), 0);
  table_.resize(proxies.size());
  for (std::uint32_t i = 0; i < proxies.size(); ++i) give_room(proxies, i);
  broad_phase.find_pairs(rooms_, near_);
}

/// Their pairs are taken out of `near_`, and those of their new rooms put in.
void Neighbours::follow_leavers(std::span<const Proxy> proxies) {
  for (const std::uint32_t i : leavers_) {
    give_room(proxies, i);
    left_[i] = 1;
  }
  list_near_leavers();
  next_near_.clear();
  auto next = of_leavers_.begin();
  for (const Pair& pair : near_) {
    if ((left_[pair.first] | left_[pair.second]) != 0) continue;
    while (next != of_leavers_.end() && *next < pair) next_near_.push_back(*next++);
    next_near_.push_back(pair);
  }
  next_near_.insert(next_near_.end(), next, of_leavers_.end());
  near_.swap(next_near_);
  for (const std::uint32_t i : leavers_) left_[i] = 0;
}

void Neighbours::list_near_leavers() {
  of_leavers_.clear();
  const auto count = static_cast<std::uint32_t>(rooms_.size());
  for (const std::uint32_t i : leavers_) {
    for (const std::uint32_t other : table_.within_reach(rooms_[i].bounds, {}, {{0, count}})) {
      // Of two leavers the first reports.
      if (left_[other] != 0 && other < i) continue;
      if (may_collide(rooms_[i], rooms_[other])) of_leavers_.push_back({std::min(i, other), std::max(i, other)});
    }
  }
  std::sort(of_leavers_.begin(), of_leavers_.end());
}

}  // namespace impulse::inline IMPULSE_PRECISION
