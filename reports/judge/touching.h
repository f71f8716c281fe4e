#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "reference/simulation.h"

namespace plumb {

/// What one step reported of two bodies: their contact points together, whichever of the two an engine calls a.
struct Touching {
  std::vector<ContactState> points;  // a < b
  double push = 0, rub = 0;          // N s, along the normal and along the normal turned by +90 degrees; sums

  /// Whether it acted, or had to: it pushed, or overlapped by more than `slack`, m.
  bool acts(double slack) const;
  /// The least separation, m. There is at least one point.
  double separation() const;
};

/// By Scene indices, the smaller first.
using BodyPair = std::pair<std::size_t, std::size_t>;
using TouchingPairs = std::map<BodyPair, Touching>;

TouchingPairs touching_pairs(std::span<const ContactState> contacts);

}  // namespace plumb
