#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Groups connected bodies by union-find (R. E. Tarjan 1975, with path halving). Islands are numbered in order of their
/// lowest body, and the bodies of an island are sorted, so nothing depends on the order of the connections.
class Islands {
 public:
  /// Starts over with every body an island of its own.
  void clear(std::size_t bodies);
  void connect(std::uint32_t a, std::uint32_t b);
  /// Numbers the islands. Call it before any of the functions below.
  void number();

  std::size_t size() const { return start_.size() - 1; }
  /// The island of a body.
  std::uint32_t of(std::uint32_t body) const { return island_[body]; }
  std::span<const std::uint32_t> bodies(std::size_t island) const {
    return std::span(order_).subspan(start_[island], start_[island + 1] - start_[island]);
  }

 private:
  std::uint32_t root(std::uint32_t body);

  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> island_;  // of each body
  std::vector<std::uint32_t> order_;   // bodies, island by island
  std::vector<std::uint32_t> start_;   // of each island in order_, and the end
  std::vector<std::uint32_t> next_;    // scratch: the next free index of each island in order_
};

}  // namespace impulse::inline IMPULSE_PRECISION
