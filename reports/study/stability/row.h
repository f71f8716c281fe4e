#pragma once

#include <optional>
#include <vector>

#include "reports/study/stability/map.h"

namespace plumb {

/// Between which two values of x a method ceased to hold, seen from x.from. Without `low` it failed at the first value,
/// without `high` at none; without both nothing was found out, as it cannot run there.
struct Bracket {
  std::optional<double> low, high;
  Seen seen;  // at `high`
};

/// A map along x, at one y.
struct MapRow {
  std::vector<Seen> cells;        // by x
  std::vector<Bracket> brackets;  // by boundary
};

MapRow row_of(const StabilityMap&, const std::vector<double>& xs, double y, const EngineConfig&);

/// How a theory stands to what was measured.
struct Agreement {
  bool agrees = false;
  std::optional<double> off;  // of the bracket's middle from the theory; nothing where either is beyond the axis
};

/// Of a theory's boundary, which may be 0 or infinite.
Agreement agreement_of(const Axis& x, const Boundary&, const std::optional<double>& low,
                       const std::optional<double>& high, double theory);

}  // namespace plumb
