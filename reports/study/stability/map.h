#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reports/study/stability/trial.h"
#include "scenarios/catalog.h"

namespace plumb {

/// One of the two numbers that a map is drawn over.
struct Axis {
  std::string name;  // "dt"
  std::string unit;  // "" where it has none
  double from = 0;   // along x: where methods should hold
  double to = 0;     // and where they should fail
  bool logarithmic = false;
  bool whole = false;

  /// n values from one end to the other, evenly spread, both ends included; fewer where whole numbers fall together.
  std::vector<double> values(int n) const;

  /// Half-way between two values; where whole numbers have nothing between them, the first.
  double between(double a, double b) const;
};

/// Where a method ceases to hold, along x.
struct Boundary {
  std::string name;           // "stands"
  std::vector<Fate> failing;  // these fates; none: all failures
  double grain = 0;           // bracket's final width; of a logarithmic axis, relative; of whole numbers 1
  /// Theory's boundary for a method at a y; nothing where it has none. May be 0 or infinite: fails, or holds, always.
  std::function<std::optional<double>(const EngineConfig&, double y)> theory = nullptr;
  std::string source = {};  // of the theory
  /// Of the measured boundary from the theory's, that counts as agreeing: relative on a logarithmic axis.
  double agreement = 0;
  /// It is nature's own: to hold beyond it is as wrong as to fail before. Else it is the method's, and farther is
  /// better.
  bool natural = false;

  bool fails(Fate) const;
};

/// Where methods fail over two parameters; it joins Catalog<StabilityMap> from its own file in reports/stability/maps/.
struct StabilityMap {
  std::string name;
  std::string question;
  Axis x;
  /// Nothing: the option that makes a method work harder, as it states (WorkLadder), or none if it has none.
  std::optional<Axis> y;
  double typical = 0;  // y where methods are compared over all maps; without y it is the method's default
  /// The runs of a cell; its fate is the worst among theirs.
  std::function<std::vector<Trial>(double x, double y, const EngineConfig&)> trials;
  std::vector<Boundary> boundaries;  // the first is the one that methods are compared by
  /// The forms of a method that the map tries; by default the method as it is.
  std::function<std::vector<EngineConfig>(const EngineConfig&)> variants = nullptr;
};

/// A scene's gap, m: by which the method says that a resting contact may stand off.
double stated_gap(const EngineConfig&, double dt);

constexpr double usual_dt = 1.0 / 60;  // s, of maps that do not vary it

}  // namespace plumb
