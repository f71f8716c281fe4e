#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "reports/study/stability/map.h"

/// A row of a map: cells along x at one y, bisected boundaries, and their agreement with theory.
namespace plumb {

/// The two values of x between which a method stops holding, counted from x.from. Without `low` it failed at the first
/// value, without `high` at none. Without both nothing is known, as it cannot run there.
struct Bracket {
  std::optional<double> low, high;
  TrialOutcome outcome;  // at `high`
};

struct MapRow {
  std::vector<TrialOutcome> cells;  // by x
  std::vector<Bracket> brackets;    // by boundary
};

MapRow measure_row(const StabilityMap&, const std::vector<double>& xs, double y, const EngineConfig&);

/// How a measured boundary compares with theory.
struct Agreement {
  bool agrees = false;
  std::optional<double> difference;  // of the bracket's middle from theory; nullopt if either is beyond the axis
};

/// `theory` may be 0 or infinite. At least one of `low` and `high` must be given.
Agreement agreement_of(const Axis& x, const Boundary&, const std::optional<double>& low,
                       const std::optional<double>& high, double theory);

/// A method, and the y of one of its rows.
struct RowSetting {
  std::string option;  // the option that y sets; "" if y is the map's own
  double y = 0;
  bool typical = false;
  EngineConfig config;
};

/// The values of a row's job. `method`: without the option. Per boundary NAME: "NAME_low", "NAME_high", "NAME_outcome",
/// "NAME_time", "NAME_body", "NAME_theory" and, where theory gives a boundary, "NAME_agrees" and "NAME_off".
nlohmann::ordered_json row_values(const StabilityMap&, const std::vector<double>& xs, const RowSetting&,
                                  const std::string& method);

/// How the rows of a method agree with a boundary's theory: their number, how many agree, and the largest difference.
/// Null if theory gives no boundary for any of them.
nlohmann::ordered_json agreement_json(const std::string& engine, const std::vector<const nlohmann::ordered_json*>& rows,
                                      const std::string& boundary);

/// A method's limit in a map: a boundary's bracket in the row at which methods are compared.
nlohmann::ordered_json limit_json(const std::string& engine, const std::vector<const nlohmann::ordered_json*>& rows,
                                  const std::string& boundary);

}  // namespace plumb
