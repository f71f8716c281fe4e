#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "reports/prove/prove.h"

namespace plumb {

/// All that `plumb prove` found.
struct Proven {
  std::vector<Proof> proofs;
  std::vector<CleanRun> clean;
  std::size_t cases = 0;

  std::size_t caught() const;
  std::size_t caught_by_physics() const;
  std::size_t false_alarms() const;  // clean runs with an alarm
  /// Every fault caught and no false alarm.
  bool holds() const;
};

/// The head line, a table of fault, scenario, metric and by how much, then what was missed and the false alarms.
std::string text_of(const Proven&);

nlohmann::ordered_json to_json(const Proven&);

}  // namespace plumb
