#include "islands/islands.h"

#include <numeric>

namespace impulse::inline IMPULSE_PRECISION {

void Islands::clear(std::size_t bodies) {
  parent_.resize(bodies);
  std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
}

std::uint32_t Islands::root(std::uint32_t body) {
  while (parent_[body] != body) {
    parent_[body] = parent_[parent_[body]];
    body = parent_[body];
  }
  return body;
}

void Islands::connect(std::uint32_t a, std::uint32_t b) {
  a = root(a);
  b = root(b);
  // The lowest body becomes the root, so that number() meets the root of an island before its other bodies.
  if (a < b) parent_[b] = a;
  if (b < a) parent_[a] = b;
}

void Islands::number() {
  const auto bodies = static_cast<std::uint32_t>(parent_.size());
  island_.resize(bodies);
  start_.assign(1, 0);
  for (std::uint32_t body = 0; body < bodies; ++body) {
    const std::uint32_t first = root(body);
    if (first == body) {
      island_[body] = static_cast<std::uint32_t>(start_.size() - 1);
      start_.push_back(0);
    } else {
      island_[body] = island_[first];
    }
    ++start_[island_[body] + 1];
  }
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  order_.resize(bodies);
  next_.assign(start_.begin(), start_.end() - 1);
  for (std::uint32_t body = 0; body < bodies; ++body) order_[next_[island_[body]]++] = body;
}

}  // namespace impulse::inline IMPULSE_PRECISION
