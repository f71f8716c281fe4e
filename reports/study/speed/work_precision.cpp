#include "reports/study/speed/work_precision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include "reports/report.h"
#include "reports/statistics.h"
#include "reports/study/job.h"
#include "reports/study/study.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

// Two-sided 95 % quantiles of Student's t for 1, 2, ... degrees of freedom (Abramowitz & Stegun, table 26.10), and of
// the normal distribution for more.
constexpr std::array<double, 10> student{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228};
constexpr double normal = 1.96;

// All steps of one method at one setting in one case.
struct StepSeries {
  const Json* first;
  std::vector<double> steps, errors;  // errors above round-off
  bool exact = true;                  // no error is
};

std::string finding_of(const StepSeries& series, const std::optional<ConvergenceOrder>& order, int stated) {
  if (series.exact) return "exact";
  if (series.steps.size() < 3) return "too few points";
  if (!order) return "not settled";
  if (stated == 0) return "measured";
  return std::abs(order->slope - stated) <= order_tolerance ? "as stated" : "not as stated";
}

Json order_json(const StepSeries& series) {
  const Json& values = *series.first;
  const int stated = values.at("order");
  const auto order = settled_order(series.steps, series.errors);
  return {{"scenario", values.at("scenario")},
          {"variant", values.at("variant")},
          {"engine", engine_label(values)},
          {"option", values.at("option")},
          {"setting", values.at("setting")},
          {"standard", values.at("standard")},
          {"stated", stated > 0 ? Json(stated) : Json(nullptr)},
          {"order", order ? Json(order->slope) : Json(nullptr)},
          {"half_width", order ? Json(order->half_width) : Json(nullptr)},
          {"points", order ? order->points : 0},
          {"finding", finding_of(series, order, stated)}};
}

}  // namespace

std::optional<ConvergenceOrder> order_of(std::span<const double> steps, std::span<const double> errors) {
  const std::size_t n = steps.size();
  if (n < 3) return std::nullopt;
  const auto count = static_cast<double>(n);
  double mean_x = 0;
  double mean_y = 0;
  for (std::size_t i = 0; i < n; ++i) {
    mean_x += std::log(steps[i]) / count;
    mean_y += std::log(errors[i]) / count;
  }
  double xx = 0;
  double xy = 0;
  double yy = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = std::log(steps[i]) - mean_x;
    const double y = std::log(errors[i]) - mean_y;
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  const double slope = xy / xx;
  const double residual = std::max(0.0, yy - slope * xy);  // sum of squares about the line
  const double t = n - 2 <= student.size() ? student[n - 3] : normal;
  return ConvergenceOrder{slope, t * std::sqrt(residual / (count - 2) / xx), static_cast<int>(n)};
}

std::optional<ConvergenceOrder> settled_order(std::span<const double> steps, std::span<const double> errors) {
  constexpr double settled = 0.15;
  double sum = 0;
  double count = 0;
  std::size_t first = steps.size();
  for (std::size_t i = steps.size(); i-- > 1; ++count) {
    const double slope = std::log(errors[i] / errors[i - 1]) / std::log(steps[i] / steps[i - 1]);
    if (count > 0 && std::abs(slope - sum / count) > settled) break;
    sum += slope;
    first = i - 1;
  }
  return order_of(steps.subspan(std::min(first, steps.size())), errors.subspan(std::min(first, errors.size())));
}

Json orders_of(const std::vector<JobResult>& results) {
  std::map<std::string, std::size_t> index;
  std::vector<StepSeries> all;
  for (const JobResult& result : results) {
    if (!has_error(result)) continue;
    const Json& values = result.output.values;
    const std::string name = result.key.substr(0, result.key.rfind("|dt="));
    const auto [entry, added] = index.emplace(name, all.size());
    if (added) all.push_back({.first = &values, .steps = {}, .errors = {}});
    StepSeries& series = all[entry->second];
    const double error = values.at("error");
    const double blur = std::max(values.at("round_off").get<double>(), values.at("truth_error").get<double>());
    if (!(error > blur)) continue;
    series.exact = false;
    series.steps.push_back(values.at("dt"));
    series.errors.push_back(error);
  }
  Json orders = Json::array();
  for (const StepSeries& series : all) orders.push_back(order_json(series));
  return orders;
}

bool has_error(const JobResult& result) {
  const auto error = result.output.values.find("error");
  return result.ending == Ending::done && error != result.output.values.end() && error->is_number();
}

namespace {

constexpr double least_error = 1e-12;  // m; smaller errors are round-off of doubles and count as this
// Every method is read off at the same errors, which no method's own runs decide.
constexpr double error_targets[] = {1e-2, 1e-3, 1e-4};             // m
constexpr double scale_targets[] = {1e-1, 1e-2, 1e-3};             // of the case's scale
constexpr double time_targets[] = {1e-5, 1e-4, 1e-3, 1e-2, 1e-1};  // s per simulated second

double power_law(double x, double x0, double y0, double x1, double y1) {
  return y0 * std::pow(y1 / y0, std::log(x / x0) / std::log(x1 / x0));
}

// A run that has both an error and a time.
struct TimedRun {
  const JobResult* result;
  WorkPoint point;
};

// The runs of one engine and method in one case.
struct MethodRuns {
  std::string engine;
  std::string execution;
  std::vector<TimedRun> runs;
  std::vector<WorkPoint> front;
  std::vector<std::string> front_keys;
};

struct CaseRuns {
  std::string scenario, variant;
  double scale = 0;  // m
  std::vector<MethodRuns> methods;
};

template <class Items, class Same>
auto& find_or_add(Items& items, typename Items::value_type item, Same same) {
  const auto found = std::find_if(items.begin(), items.end(), same);
  if (found != items.end()) return *found;
  return items.emplace_back(std::move(item));
}

// Returns the front of the runs and appends the keys of its jobs.
std::vector<WorkPoint> front_of(const std::vector<TimedRun>& runs, std::vector<std::string>& keys) {
  std::vector<WorkPoint> all;
  for (const TimedRun& run : runs) all.push_back(run.point);
  std::vector<WorkPoint> front;
  for (const std::size_t i : pareto_front(all)) {
    front.push_back(all[i]);
    keys.push_back(runs[i].result->key);
  }
  return front;
}

// Cases and methods keep the plan's order. A method that fails in a case has no runs there.
std::vector<CaseRuns> by_case(const std::vector<JobResult>& results) {
  std::vector<CaseRuns> cases;
  for (const JobResult& result : results) {
    const Json& values = result.output.values;
    const bool timed = has_error(result) && result.output.times.contains("median");
    if (!timed && values.value("status", "") != name_of(Status::failed)) continue;
    const std::string scenario = values.at("scenario");
    const std::string variant = values.at("variant");
    CaseRuns& of_case = find_or_add(cases, {scenario, variant, values.at("scale"), {}}, [&](const CaseRuns& one) {
      return one.scenario == scenario && one.variant == variant;
    });
    const std::string engine = engine_label(values);
    MethodRuns& of_method = find_or_add(of_case.methods, {engine, values.at("execution"), {}, {}, {}},
                                        [&](const MethodRuns& one) { return one.engine == engine; });
    if (!timed) continue;
    const double error =
        std::max({values.at("error").get<double>(), values.at("truth_error").get<double>(), least_error});
    of_method.runs.push_back({&result, {result.output.times.at("median"), error}});
  }
  for (CaseRuns& one : cases) {
    for (MethodRuns& method : one.methods) method.front = front_of(method.runs, method.front_keys);
  }
  return cases;
}

Json json_of(const std::optional<FrontReading>& reading) {
  if (!reading) return nullptr;
  return {{"value", reading->value}, {"bound", reading->bound}};
}

Json readings_of(const std::vector<WorkPoint>& front, std::span<const double> targets, double unit) {
  Json readings = Json::array();
  for (const double target : targets) readings.push_back(json_of(time_to_reach(front, target * unit)));
  return readings;
}

Json case_json(const CaseRuns& runs) {
  Json engines = Json::array();
  std::vector<TimedRun> all;
  for (const MethodRuns& method : runs.methods) {
    Json errors = Json::array();
    for (const double target : time_targets) errors.push_back(json_of(error_within(method.front, target)));
    const auto least = std::min_element(method.runs.begin(), method.runs.end(),
                                        [](const auto& a, const auto& b) { return a.point.error < b.point.error; });
    engines.push_back({{"engine", method.engine},
                       {"execution", method.execution},
                       {"front", method.front_keys},
                       {"time_for_error", readings_of(method.front, error_targets, 1)},
                       {"time_for_scale", readings_of(method.front, scale_targets, runs.scale)},
                       {"error_for_time", errors},
                       {"least_error", least == method.runs.end() ? Json(nullptr) : Json(least->point.error)}});
    all.insert(all.end(), method.runs.begin(), method.runs.end());
  }
  std::vector<std::string> keys;
  front_of(all, keys);
  return {{"scenario", runs.scenario},
          {"variant", runs.variant},
          {"scale", runs.scale},
          {"front", keys},
          {"engines", engines}};
}

// s per simulated second for one target; nullopt if the engine does not run the case or is never that accurate.
std::optional<double> time_of(const Json& one, const std::string& engine, const char* kind, std::size_t target) {
  for (const Json& method : one.at("engines")) {
    if (method.at("engine") != engine) continue;
    const Json& reading = method.at(kind)[target];
    if (reading.is_object()) return reading.at("value").get<double>();
  }
  return std::nullopt;
}

struct NamedMethod {
  std::string engine, execution;
};

// What each method does for one target over all cases, those that it does not run or reach included.
Json target_json(const Json& cases, const std::vector<NamedMethod>& engines, const char* kind, std::size_t target) {
  std::map<std::string, std::vector<double>> factors;  // time over the fastest method's, by method
  std::map<std::string, int> fastest;
  int reached_by_any = 0;
  for (const Json& one : cases) {
    std::vector<std::pair<double, std::string>> times;
    for (const auto& [engine, execution] : engines) {
      if (const auto time = time_of(one, engine, kind, target)) times.emplace_back(*time, engine);
    }
    if (times.empty()) continue;
    ++reached_by_any;
    const auto& [least, best] = *std::min_element(times.begin(), times.end());
    ++fastest[best];
    for (const auto& [time, engine] : times) factors[engine].push_back(time / least);
  }
  Json rows = Json::array();
  for (const auto& [engine, execution] : engines) {
    const Quartiles of = quartiles(factors[engine]);
    const bool any = !factors[engine].empty();
    rows.push_back({{"engine", engine},
                    {"execution", execution},
                    {"reached", factors[engine].size()},
                    {"fastest", fastest[engine]},
                    {"median", any ? Json(of.median) : Json(nullptr)},
                    {"low", any ? Json(of.low) : Json(nullptr)},
                    {"high", any ? Json(of.high) : Json(nullptr)}});
  }
  return {{"cases", cases.size()}, {"reached_by_any", reached_by_any}, {"engines", rows}};
}

Json targets_json(const Json& cases) {
  std::vector<NamedMethod> engines;
  for (const Json& one : cases) {
    for (const Json& method : one.at("engines")) {
      find_or_add(engines, {method.at("engine"), method.at("execution")},
                  [&](const NamedMethod& other) { return other.engine == method.at("engine"); });
    }
  }
  Json all = Json::array();
  for (std::size_t i = 0; i < std::size(error_targets); ++i) {
    Json target = target_json(cases, engines, "time_for_error", i);
    target.update({{"error", error_targets[i]}, {"unit", "m"}});
    all.push_back(std::move(target));
  }
  for (std::size_t i = 0; i < std::size(scale_targets); ++i) {
    Json target = target_json(cases, engines, "time_for_scale", i);
    target.update({{"error", scale_targets[i]}, {"unit", "scale"}});
    all.push_back(std::move(target));
  }
  return all;
}

}  // namespace

std::vector<std::size_t> pareto_front(std::span<const WorkPoint> points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a].time < points[b].time || (points[a].time == points[b].time && points[a].error < points[b].error);
  });
  std::vector<std::size_t> front;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order) {
    if (!(points[i].error < least)) continue;
    least = points[i].error;
    front.push_back(i);
  }
  return front;
}

std::optional<FrontReading> time_to_reach(std::span<const WorkPoint> front, double error) {
  const auto good = std::find_if(front.begin(), front.end(), [&](const WorkPoint& one) { return one.error <= error; });
  if (good == front.end()) return std::nullopt;
  if (good == front.begin()) return FrontReading{good->time, good->error < error};
  const WorkPoint& before = *(good - 1);
  return FrontReading{power_law(error, before.error, before.time, good->error, good->time)};
}

std::optional<FrontReading> error_within(std::span<const WorkPoint> front, double time) {
  const auto slower = std::find_if(front.begin(), front.end(), [&](const WorkPoint& one) { return one.time > time; });
  if (slower == front.begin()) return std::nullopt;
  const WorkPoint& before = *(slower - 1);
  if (slower == front.end()) return FrontReading{before.error, before.time < time};
  return FrontReading{power_law(time, before.time, before.error, slower->time, slower->error)};
}

Json work_precision_of(const std::vector<JobResult>& results) {
  Json cases = Json::array();
  for (const CaseRuns& one : by_case(results)) cases.push_back(case_json(one));
  Json targets = targets_json(cases);
  return {{"error_targets", error_targets},
          {"scale_targets", scale_targets},
          {"time_targets", time_targets},
          {"cases", std::move(cases)},
          {"targets", std::move(targets)}};
}

}  // namespace plumb
