#pragma once

#include <stdexcept>

#include "reports/run/selection.h"
#include "reports/study/stability/row.h"

namespace plumb {

/// The bracket of a boundary of an engine in a map, bisected between two values of x.
inline Bracket bracket(const char* map_name, const char* engine, double y, double from, double to,
                       const char* boundary) {
  const StabilityMap& map = *Catalog<StabilityMap>::find(map_name);
  const MapRow row = measure_row(map, {from, to}, y, parse_engine(engine));
  for (std::size_t i = 0; i < map.boundaries.size(); ++i) {
    if (map.boundaries[i].name == boundary) return row.brackets[i];
  }
  throw std::logic_error(boundary);
}

inline double middle(const Bracket& of) { return (of.low.value() + of.high.value()) / 2; }

}  // namespace plumb
