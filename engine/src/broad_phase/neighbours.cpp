#include "broad_phase/neighbours.h"

#include <algorithm>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// m, added to each side of the bounds: many steps of motion for a body that hardly moves, and small next to the margin
/// of contacts.
constexpr Real fat_margin = static_cast<Real>(0.02);

/// With fewer proxies, a search costs no more than keeping pairs.
constexpr std::size_t least_proxies = 64;

/// One moved proxy costs about .15 ns for each proxy, a new search 30 to 40 ns for each.
constexpr std::size_t most_moved = 64;

constexpr int soon = 4;    // steps: fat AABBs that did not last so long did not pay
constexpr int pause = 16;  // steps until they are tried again

}  // namespace

void Neighbours::find(BroadPhase& broad_phase, std::span<const Proxy> proxies, std::uint64_t version,
                      std::vector<Pair>& pairs) {
  if (proxies.size() < least_proxies) return broad_phase.find_pairs(proxies, pairs);
  if (!keep_near(proxies, version)) {
    if (version == version_ && steps_with_fat_ < soon) steps_without_ = pause;
    if (steps_without_ > 0) {
      --steps_without_;
      version_ = 0;
      return broad_phase.find_pairs(proxies, pairs);
    }
    search_again(broad_phase, proxies);
    version_ = version;
    steps_with_fat_ = 0;
  }
  ++steps_with_fat_;
  pairs.resize(near_.size());
  pairs.resize(broad_phase_kernels().filter_pairs(proxies.data(), near_.data(),
                                                  static_cast<std::uint32_t>(near_.size()), pairs.data()));
}

/// Brings `near_` up to date; false if that needs a new search.
bool Neighbours::keep_near(std::span<const Proxy> proxies, std::uint64_t version) {
  if (version != version_) return false;
  moved_.clear();
  for (std::uint32_t i = 0; i < proxies.size(); ++i) {
    if (within(proxies[i].bounds, fat_[i].bounds)) continue;
    if (moved_.size() == most_moved) return false;
    moved_.push_back(i);
  }
  if (!moved_.empty()) update_moved(proxies);
  return true;
}

void Neighbours::set_fat(std::span<const Proxy> proxies, std::uint32_t i) {
  fat_[i] = proxies[i];
  fat_[i].bounds = grown(proxies[i].bounds, fat_margin);
  fat_[i].displacement = {};
  table_.set(i, fat_[i].bounds, fat_[i].displacement);
}

void Neighbours::search_again(BroadPhase& broad_phase, std::span<const Proxy> proxies) {
  fat_.resize(proxies.size());
  moved_flag_.assign(proxies.size(), 0);
  table_.resize(proxies.size());
  for (std::uint32_t i = 0; i < proxies.size(); ++i) set_fat(proxies, i);
  broad_phase.find_pairs(fat_, near_);
}

/// Replaces the pairs of the moved proxies in `near_` by those of their new fat AABBs.
void Neighbours::update_moved(std::span<const Proxy> proxies) {
  for (const std::uint32_t i : moved_) {
    set_fat(proxies, i);
    moved_flag_[i] = 1;
  }
  list_near_moved();
  next_near_.clear();
  auto next = near_moved_.begin();
  for (const Pair& pair : near_) {
    if ((moved_flag_[pair.first] | moved_flag_[pair.second]) != 0) continue;
    while (next != near_moved_.end() && *next < pair) next_near_.push_back(*next++);
    next_near_.push_back(pair);
  }
  next_near_.insert(next_near_.end(), next, near_moved_.end());
  near_.swap(next_near_);
  for (const std::uint32_t i : moved_) moved_flag_[i] = 0;
}

void Neighbours::list_near_moved() {
  near_moved_.clear();
  const auto count = static_cast<std::uint32_t>(fat_.size());
  for (const std::uint32_t i : moved_) {
    for (const std::uint32_t other : table_.within_reach(fat_[i].bounds, {}, {{0, count}})) {
      // A pair of two moved proxies is listed by the first of them.
      if (moved_flag_[other] != 0 && other < i) continue;
      if (may_collide(fat_[i], fat_[other])) near_moved_.push_back({std::min(i, other), std::max(i, other)});
    }
  }
  std::sort(near_moved_.begin(), near_moved_.end());
}

}  // namespace impulse::inline IMPULSE_PRECISION
