#include "reports/study/stability/row.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

class RowSearch {
 public:
  RowSearch(const StabilityMap& map, double y, const EngineConfig& config) : map_(map), y_(y), config_(config) {}

  // The worst outcome of its trials.
  TrialOutcome cell(double x) const {
    TrialOutcome worst{.mode = FailureMode::not_supported};
    for (const Trial& trial : map_.trials(x, y_, config_)) {
      const TrialOutcome outcome = run_trial(trial, config_);
      if (outcome.mode >= worst.mode) worst = outcome;
    }
    return worst;
  }

  Bracket bracket(const Boundary& of, const std::vector<double>& xs, const std::vector<TrialOutcome>& cells) const {
    const auto bad = static_cast<std::size_t>(
        std::find_if(cells.begin(), cells.end(), [&](const TrialOutcome& cell) { return of.fails(cell.mode); }) -
        cells.begin());
    const auto good =
        std::find_if(std::make_reverse_iterator(cells.begin() + static_cast<std::ptrdiff_t>(bad)), cells.rend(),
                     [](const TrialOutcome& cell) { return cell.mode != FailureMode::not_supported; });
    Bracket found;
    if (good != cells.rend()) found.low = xs[static_cast<std::size_t>(cells.rend() - good) - 1];
    if (bad == cells.size()) return found;
    found.high = xs[bad];
    found.outcome = cells[bad];
    if (found.low) bisect(of, found);
    return found;
  }

 private:
  void bisect(const Boundary& of, Bracket& found) const {
    while (!is_narrow(of, *found.low, *found.high)) {
      const double x = map_.x.between(*found.low, *found.high);
      if (x == *found.low) return;
      const TrialOutcome outcome = cell(x);
      if (outcome.mode == FailureMode::not_supported) return;
      if (of.fails(outcome.mode)) {
        found.high = x;
        found.outcome = outcome;
      } else {
        found.low = x;
      }
    }
  }

  bool is_narrow(const Boundary& of, double low, double high) const {
    if (map_.x.whole) return false;  // bisect until no integer is left between
    const double width = std::abs(high - low);
    return width <= (map_.x.logarithmic ? of.resolution * std::min(low, high) : of.resolution);
  }

  const StabilityMap& map_;
  double y_;
  const EngineConfig& config_;
};

Json number_or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

// JSON has no infinity: "never" stands for a method that always holds.
Json theory_json(const std::optional<double>& theory) {
  return theory && std::isinf(*theory) ? Json("never") : number_or_null(theory);
}

}  // namespace

MapRow measure_row(const StabilityMap& map, const std::vector<double>& xs, double y, const EngineConfig& config) {
  const RowSearch search(map, y, config);
  MapRow row;
  for (const double x : xs) row.cells.push_back(search.cell(x));
  for (const Boundary& boundary : map.boundaries) row.brackets.push_back(search.bracket(boundary, xs, row.cells));
  return row;
}

Agreement agreement_of(const Axis& x, const Boundary& boundary, const std::optional<double>& low,
                       const std::optional<double>& high, double theory) {
  // Whether theory has the boundary at this value or farther, in the direction from x.from to x.to.
  const double sign = x.to > x.from ? 1 : -1;
  const auto at_or_beyond = [&](double value) { return sign * (theory - value) >= 0; };
  const auto difference_at = [&](double value) {
    const double difference = std::abs(value - theory);
    return x.logarithmic ? difference / theory : difference;
  };
  if (low && high) {
    const double difference = difference_at((*low + *high) / 2);
    return {difference <= boundary.agreement, difference};
  }
  const double edge = low ? *low : *high;  // the measured boundary is somewhere on the other side of it
  const bool agrees = low ? at_or_beyond(edge) : !at_or_beyond(edge);
  if (agrees) return {true, std::nullopt};
  const double difference = difference_at(edge);
  return {difference <= boundary.agreement, std::isfinite(difference) ? std::optional(difference) : std::nullopt};
}

Json row_values(const StabilityMap& map, const std::vector<double>& xs, const RowSetting& setting,
                const std::string& method) {
  const MapRow row = measure_row(map, xs, setting.y, setting.config);
  std::string outcomes;
  Json since = Json::array();
  Json bodies = Json::array();
  std::string why;
  for (const TrialOutcome& cell : row.cells) {
    outcomes += letter_of(cell.mode);
    since.push_back(is_failure(cell.mode) ? Json(cell.time) : Json(nullptr));
    bodies.push_back(cell.body);
    if (why.empty() || cell.mode == FailureMode::fails) why = cell.why;
  }
  Json values{{"map", map.name},      {"engine", setting.config.engine->name},
              {"method", method},     {"option", setting.option},
              {"y", setting.y},       {"typical", setting.typical},
              {"outcomes", outcomes}, {"why", why},
              {"since", since},       {"bodies", bodies}};
  for (std::size_t i = 0; i < map.boundaries.size(); ++i) {
    const Boundary& boundary = map.boundaries[i];
    const Bracket& bracket = row.brackets[i];
    const auto theory = boundary.theory ? boundary.theory(setting.config, setting.y) : std::nullopt;
    values[boundary.name + "_low"] = number_or_null(bracket.low);
    values[boundary.name + "_high"] = number_or_null(bracket.high);
    values[boundary.name + "_outcome"] = bracket.high ? name_of(bracket.outcome.mode) : "";
    values[boundary.name + "_time"] = bracket.high ? Json(bracket.outcome.time) : Json(nullptr);
    values[boundary.name + "_body"] = bracket.outcome.body;
    values[boundary.name + "_theory"] = theory_json(theory);
    if (!theory || !(bracket.low || bracket.high)) continue;
    const Agreement agreement = agreement_of(map.x, boundary, bracket.low, bracket.high, *theory);
    values[boundary.name + "_agrees"] = agreement.agrees;
    values[boundary.name + "_off"] = number_or_null(agreement.difference);
  }
  return values;
}

Json agreement_json(const std::string& engine, const std::vector<const Json*>& rows, const std::string& boundary) {
  int with_theory = 0;
  int agreeing = 0;
  int measured = 0;
  double worst = 0;
  for (const Json* row : rows) {
    const auto agrees = row->find(boundary + "_agrees");
    if (agrees == row->end()) continue;
    ++with_theory;
    if (*agrees) ++agreeing;
    const Json& difference = row->at(boundary + "_off");
    if (!difference.is_number()) continue;
    ++measured;
    worst = std::max(worst, difference.get<double>());
  }
  if (with_theory == 0) return nullptr;
  return {{"engine", engine},  {"boundary", boundary}, {"rows", with_theory},
          {"agree", agreeing}, {"measured", measured}, {"worst", measured > 0 ? Json(worst) : Json(nullptr)}};
}

Json limit_json(const std::string& engine, const std::vector<const Json*>& rows, const std::string& boundary) {
  const auto typical =
      std::find_if(rows.begin(), rows.end(), [](const Json* row) { return row->at("typical") == true; });
  Json limit{{"engine", engine}};
  if (typical == rows.end()) return limit;
  const Json& row = **typical;
  for (const char* what : {"low", "high", "outcome", "theory"}) limit[what] = row.at(boundary + "_" + what);
  limit["agrees"] = row.value(boundary + "_agrees", false);
  limit["y"] = row.at("y");
  limit["option"] = row.at("option");
  limit["why"] = row.at("why");
  return limit;
}

}  // namespace plumb
