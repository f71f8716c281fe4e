#include "reports/study/speed/speed_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "reports/report.h"
#include "reports/statistics.h"
#include "reports/study/speed/work_precision.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr double least_error = 1e-12;      // m; what is less is the round-off of doubles, and no merit
constexpr double order_tolerance = 0.2;    // by which a measured order may miss the stated one
constexpr const char* standard = "box2d";  // whose time the others' are multiples of
constexpr double error_targets[] = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6};  // m
constexpr double time_targets[] = {1e-5, 1e-4, 1e-3, 1e-2, 1e-1};         // s per simulated second

struct Mark {
  const PointResult* point;
  WorkPoint at;
};

struct Curve {
  std::string engine;
  std::vector<Mark> marks;  // that have both an error and a time
  std::vector<WorkPoint> front;
  std::vector<std::string> front_keys;
};

struct Place {
  std::string scenario, variant;
  std::vector<Curve> curves;
};

std::string engine_of(const Json& values) { return label_of(values.at("engine"), values.at("method")); }

bool measured(const PointResult& point) {
  const auto error = point.row.values.find("error");
  return point.ending == Ending::done && error != point.row.values.end() && error->is_number();
}

template <class Items, class Same>
auto& found_or_added(Items& items, typename Items::value_type item, Same same) {
  const auto found = std::find_if(items.begin(), items.end(), same);
  if (found != items.end()) return *found;
  return items.emplace_back(std::move(item));
}

std::vector<WorkPoint> set_front(const std::vector<Mark>& marks, std::vector<std::string>& keys) {
  std::vector<WorkPoint> all;
  for (const Mark& mark : marks) all.push_back(mark.at);
  std::vector<WorkPoint> front;
  for (const std::size_t i : pareto_front(all)) {
    front.push_back(all[i]);
    keys.push_back(marks[i].point->key);
  }
  return front;
}

// Points in the plan's order stay in it.
std::vector<Place> places_of(const std::vector<PointResult>& results) {
  std::vector<Place> places;
  for (const PointResult& point : results) {
    if (!measured(point) || !point.row.times.contains("median")) continue;
    const Json& values = point.row.values;
    const std::string scenario = values.at("scenario");
    const std::string variant = values.at("variant");
    Place& place = found_or_added(places, {scenario, variant, {}},
                                  [&](const Place& one) { return one.scenario == scenario && one.variant == variant; });
    const std::string engine = engine_of(values);
    Curve& curve =
        found_or_added(place.curves, {engine, {}, {}, {}}, [&](const Curve& one) { return one.engine == engine; });
    const double error =
        std::max({values.at("error").get<double>(), values.at("truth_error").get<double>(), least_error});
    curve.marks.push_back({&point, {point.row.times.at("median"), error}});
  }
  for (Place& place : places) {
    for (Curve& curve : place.curves) curve.front = set_front(curve.marks, curve.front_keys);
  }
  return places;
}

// All steps of one method at one setting in one case.
struct Series {
  const Json* first;
  std::vector<double> steps, errors;  // those above round-off
  bool exact = true;                  // none is
};

std::string finding_of(const Series& series, const std::optional<Order>& order, int stated) {
  if (series.exact) return "exact";
  if (series.steps.size() < 3) return "too few points";
  if (!order) return "not settled";
  if (stated == 0) return "measured";
  return std::abs(order->slope - stated) <= order_tolerance ? "as stated" : "not as stated";
}

Json order_row(const Series& series) {
  const Json& values = *series.first;
  const int stated = values.at("order");
  const auto order = settled_order(series.steps, series.errors);
  return {{"scenario", values.at("scenario")},
          {"variant", values.at("variant")},
          {"engine", engine_of(values)},
          {"option", values.at("option")},
          {"setting", values.at("setting")},
          {"standard", values.at("standard")},
          {"stated", stated > 0 ? Json(stated) : Json(nullptr)},
          {"order", order ? Json(order->slope) : Json(nullptr)},
          {"half_width", order ? Json(order->half_width) : Json(nullptr)},
          {"points", order ? order->points : 0},
          {"finding", finding_of(series, order, stated)}};
}

Json orders_of(const std::vector<PointResult>& results) {
  std::map<std::string, std::size_t> index;
  std::vector<Series> all;
  for (const PointResult& point : results) {
    if (!measured(point)) continue;
    const Json& values = point.row.values;
    const std::string name = point.key.substr(0, point.key.rfind("|dt="));
    const auto [place, added] = index.emplace(name, all.size());
    if (added) all.push_back({.first = &values, .steps = {}, .errors = {}});
    Series& series = all[place->second];
    const double error = values.at("error");
    const double blur = std::max(values.at("round_off").get<double>(), values.at("truth_error").get<double>());
    if (!(error > blur)) continue;
    series.exact = false;
    series.steps.push_back(values.at("dt"));
    series.errors.push_back(error);
  }
  Json rows = Json::array();
  for (const Series& series : all) rows.push_back(order_row(series));
  return rows;
}

Json json_of(const std::optional<Reading>& reading) {
  if (!reading) return nullptr;  // not reached
  return {{"value", reading->value}, {"bound", reading->bound}};
}

// How many times the standard's time a method takes to be as accurate: at errors along the standard's own front, evenly
// on a logarithmic scale. Only what was measured counts: where the method never is so accurate, it has no factor.
struct Factor {
  std::optional<double> median;
  double reached = 0;  // share of the standard's errors that the method reaches, too
};

Factor factor_of(const Curve& curve, const Curve& base) {
  constexpr int samples = 9;
  const double low = std::log(base.front.back().error);
  const double high = std::log(base.front.front().error);
  std::vector<double> factors;
  for (int i = 0; i < samples; ++i) {
    const double error = i + 1 == samples ? base.front.front().error : std::exp(low + (high - low) * i / (samples - 1));
    const auto own = time_to_reach(curve.front, error);
    const auto others = time_to_reach(base.front, error);
    if (own && others) factors.push_back(own->value / others->value);
  }
  if (factors.empty()) return {};
  return {quartiles(factors).median, static_cast<double>(factors.size()) / samples};
}

const Curve* standard_of(const Place& place) {
  const auto found =
      std::find_if(place.curves.begin(), place.curves.end(), [](const Curve& one) { return one.engine == standard; });
  return found == place.curves.end() ? nullptr : &*found;
}

Json case_row(const Place& place) {
  Json engines = Json::array();
  std::vector<Mark> all;
  const Curve* base = standard_of(place);
  for (const Curve& curve : place.curves) {
    Json times = Json::array();
    for (const double target : error_targets) times.push_back(json_of(time_to_reach(curve.front, target)));
    Json errors = Json::array();
    for (const double target : time_targets) errors.push_back(json_of(error_within(curve.front, target)));
    const Factor factor = base == nullptr ? Factor{} : factor_of(curve, *base);
    engines.push_back({{"engine", curve.engine},
                       {"front", curve.front_keys},
                       {"time_for_error", times},
                       {"error_for_time", errors},
                       {"factor", factor.median ? Json(*factor.median) : Json(nullptr)},
                       {"reached", factor.reached}});
    all.insert(all.end(), curve.marks.begin(), curve.marks.end());
  }
  std::vector<std::string> keys;
  set_front(all, keys);
  return {{"scenario", place.scenario}, {"variant", place.variant}, {"front", keys}, {"engines", engines}};
}

Json factors_of(const Json& cases) {
  std::vector<std::pair<std::string, std::vector<double>>> found;
  std::map<std::string, int> asked;
  for (const Json& place : cases) {
    for (const Json& one : place.at("engines")) {
      const std::string engine = one.at("engine");
      auto& entry = found_or_added(found, {engine, {}}, [&](const auto& other) { return other.first == engine; });
      ++asked[engine];
      if (one.at("factor").is_number()) entry.second.push_back(one.at("factor"));
    }
  }
  Json rows = Json::array();
  for (const auto& [engine, factors] : found) {
    const Quartiles of = quartiles(factors);
    const bool any = !factors.empty();
    rows.push_back({{"engine", engine},
                    {"median", any ? Json(of.median) : Json(nullptr)},
                    {"low", any ? Json(of.low) : Json(nullptr)},
                    {"high", any ? Json(of.high) : Json(nullptr)},
                    {"cases", asked.at(engine)},
                    {"reached", factors.size()}});
  }
  return rows;
}

std::string summary_of(const Json& orders, const Json& factors, const std::vector<PointResult>& results) {
  std::map<std::string, int> told;
  for (const Json& row : orders) {
    if (row.at("stated").is_number()) ++told[row.at("finding")];
  }
  std::string text = "Stated orders of convergence:";
  for (const auto& [finding, count] : told)
    text += fmt::format("{} {} {}", &finding == &told.begin()->first ? "" : ",", count, finding);
  text += told.empty() ? " none.\n" : ".\n";
  for (const Json& row : orders) {
    if (row.at("finding") != "not as stated") continue;
    text += fmt::format("  {} {}: {} {}{}{}: measured {:.2f} +- {:.2f}, stated {}\n",
                        row.at("scenario").get<std::string>(), row.at("variant").get<std::string>(),
                        row.at("engine").get<std::string>(), row.at("option").get<std::string>(),
                        row.at("option").empty() ? "" : "=", row.at("setting").get<std::string>(),
                        row.at("order").get<double>(), row.at("half_width").get<double>(), row.at("stated").get<int>());
  }
  text += fmt::format("\nTime at equal error, {} = 1\n  {:<56}{:>10}{:>20}{:>10}\n", standard, "", "median",
                      "middle half", "cases");
  for (const Json& row : factors) {
    const bool any = row.at("median").is_number();
    text +=
        fmt::format("  {:<56}{:>10}{:>20}{:>10}\n", row.at("engine").get<std::string>(),
                    any ? fmt::format("{:.2g}", row.at("median").get<double>()) : "-",
                    any ? fmt::format("{:.2g} ... {:.2g}", row.at("low").get<double>(), row.at("high").get<double>())
                        : "not reached",
                    fmt::format("{}/{}", row.at("reached").get<std::size_t>(), row.at("cases").get<int>()));
  }
  const auto broken = std::count_if(results.begin(), results.end(),
                                    [](const PointResult& point) { return point.ending != Ending::done; });
  const auto unsteady = std::count_if(results.begin(), results.end(), [](const PointResult& point) {
    return point.row.times.contains("wide") && point.row.times.at("wide").get<bool>();
  });
  return text + fmt::format("\n{} points; {} crashed or went beyond their limits; {} were timed with a wide spread.\n",
                            results.size(), broken, unsteady);
}

}  // namespace

Findings speed_findings(const std::vector<PointResult>& results) {
  const Json orders = orders_of(results);
  Json cases = Json::array();
  for (const Place& place : places_of(results)) cases.push_back(case_row(place));
  const Json factors = factors_of(cases);
  Findings found;
  found.findings = {{"order_tolerance", order_tolerance}, {"orders", orders}};
  found.timings = {{"standard", standard},
                   {"error_targets", error_targets},
                   {"time_targets", time_targets},
                   {"cases", std::move(cases)},
                   {"factors", factors}};
  found.summary = summary_of(orders, factors, results);
  return found;
}

}  // namespace plumb
