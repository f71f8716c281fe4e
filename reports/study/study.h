#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "reports/study/point.h"

namespace plumb {

/// What the points of a study come to together.
struct Findings {
  nlohmann::ordered_json findings = nlohmann::ordered_json::object();  // the same in every run
  nlohmann::ordered_json timings = nlohmann::ordered_json::object();   // what hangs on the clock
  std::string summary;                                                 // lines for the console
};

struct StudyPlan {
  std::vector<Point> points;  // in the order in which they are run and shown
  /// From the results of all of them, in that order.
  std::function<Findings(const std::vector<PointResult>&)> conclude;
};

/// Many runs that answer one question together; it joins Catalog<Study> from its own file in reports/studies/.
struct Study {
  std::string name;
  std::string about;     // one line
  std::string examples;  // shown under --help
  /// Adds its options; what is returned gives, after they are read, everything that its results hang on: results of
  /// different configurations are never mixed. Both throw std::invalid_argument for what the user should put right.
  std::function<std::function<nlohmann::ordered_json()>(CLI::App&)> attach;
  /// The same plan for the same configuration, wherever it is asked for.
  std::function<StudyPlan(const nlohmann::ordered_json& configuration)> plan;
  /// Options of its short form, which a report shows; none: reports leave it out.
  std::optional<std::vector<std::string>> brief = std::nullopt;
};

}  // namespace plumb
