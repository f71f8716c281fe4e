#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "reports/gate/result.h"

/// The forms of a GateResult.
namespace plumb {

/// A form that other tools read; `plumb check --NAME FILE` writes it.
struct GateWriter {
  std::string name;
  std::string about;  // one line
  std::function<std::string(const GateResult&)> text;
};

/// "worse: bounce e=0.5, impulse: energy_drift: 0.1 J, now 0.2 J, allowed +/- 1e-09; why"
std::string in_words(const Regression&);

/// The verdict, the worst `most` regressions and the notes, one per line.
std::string text_of(const GateResult&, std::size_t most);

/// How a report differs from an accepted baseline, as a study's document for the page: {"study": "baseline",
/// "findings": {"verdict", "notes", "runs", "regressions"}, ...}. Leaves out runs that only one of the two has. Returns
/// nullopt if there is no such file or its time step is another. Throws std::invalid_argument, naming the place, if the
/// file cannot be read.
std::optional<nlohmann::ordered_json> changes_since(const std::string& file, const Report&);

}  // namespace plumb
