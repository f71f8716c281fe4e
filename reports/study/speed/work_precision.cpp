#include "reports/study/speed/work_precision.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include "reports/statistics.h"
#include "reports/study/job.h"
#include "reports/study/selection.h"
#include "reports/study/speed/convergence_order.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr double least_error = 1e-12;      // m; smaller errors are round-off of doubles and count as this
constexpr const char* standard = "box2d";  // the engine whose time is 1
constexpr double error_targets[] = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6};  // m
constexpr double time_targets[] = {1e-5, 1e-4, 1e-3, 1e-2, 1e-1};         // s per simulated second

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
  std::vector<TimedRun> runs;
  std::vector<WorkPoint> front;
  std::vector<std::string> front_keys;
};

struct CaseRuns {
  std::string scenario, variant;
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

// Cases and methods keep the plan's order.
std::vector<CaseRuns> by_case(const std::vector<JobResult>& results) {
  std::vector<CaseRuns> cases;
  for (const JobResult& result : results) {
    if (!has_error(result) || !result.output.times.contains("median")) continue;
    const Json& values = result.output.values;
    const std::string scenario = values.at("scenario");
    const std::string variant = values.at("variant");
    CaseRuns& of_case = find_or_add(cases, {scenario, variant, {}}, [&](const CaseRuns& one) {
      return one.scenario == scenario && one.variant == variant;
    });
    const std::string engine = engine_label(values);
    MethodRuns& of_method =
        find_or_add(of_case.methods, {engine, {}, {}, {}}, [&](const MethodRuns& one) { return one.engine == engine; });
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

// A method's time over the standard's, at equal error.
struct TimeFactor {
  std::optional<double> median;  // nullopt if the method reaches none of the errors
  double reached = 0;            // fraction of the errors on the standard's front that the method reaches, too
};

// Takes errors evenly on a logarithmic scale along the standard's own front. Only errors that the method itself was
// measured to reach count.
TimeFactor factor_of(const MethodRuns& method, const MethodRuns& base) {
  constexpr int samples = 9;
  const double low = std::log(base.front.back().error);
  const double high = std::log(base.front.front().error);
  std::vector<double> factors;
  for (int i = 0; i < samples; ++i) {
    const double error = i + 1 == samples ? base.front.front().error : std::exp(low + (high - low) * i / (samples - 1));
    const auto own = time_to_reach(method.front, error);
    const auto others = time_to_reach(base.front, error);
    if (own && others) factors.push_back(own->value / others->value);
  }
  if (factors.empty()) return {};
  return {quartiles(factors).median, static_cast<double>(factors.size()) / samples};
}

const MethodRuns* standard_of(const CaseRuns& runs) {
  const auto found = std::find_if(runs.methods.begin(), runs.methods.end(),
                                  [](const MethodRuns& one) { return one.engine == standard; });
  return found == runs.methods.end() ? nullptr : &*found;
}

Json case_json(const CaseRuns& runs) {
  Json engines = Json::array();
  std::vector<TimedRun> all;
  const MethodRuns* base = standard_of(runs);
  for (const MethodRuns& method : runs.methods) {
    Json times = Json::array();
    for (const double target : error_targets) times.push_back(json_of(time_to_reach(method.front, target)));
    Json errors = Json::array();
    for (const double target : time_targets) errors.push_back(json_of(error_within(method.front, target)));
    const TimeFactor factor = base == nullptr ? TimeFactor{} : factor_of(method, *base);
    engines.push_back({{"engine", method.engine},
                       {"front", method.front_keys},
                       {"time_for_error", times},
                       {"error_for_time", errors},
                       {"factor", factor.median ? Json(*factor.median) : Json(nullptr)},
                       {"reached", factor.reached}});
    all.insert(all.end(), method.runs.begin(), method.runs.end());
  }
  std::vector<std::string> keys;
  front_of(all, keys);
  return {{"scenario", runs.scenario}, {"variant", runs.variant}, {"front", keys}, {"engines", engines}};
}

// Each method's factors over all cases.
Json factors_json(const Json& cases) {
  std::vector<std::pair<std::string, std::vector<double>>> found;
  std::map<std::string, int> cases_with;
  for (const Json& one : cases) {
    for (const Json& method : one.at("engines")) {
      const std::string engine = method.at("engine");
      auto& entry = find_or_add(found, {engine, {}}, [&](const auto& other) { return other.first == engine; });
      ++cases_with[engine];
      if (method.at("factor").is_number()) entry.second.push_back(method.at("factor"));
    }
  }
  Json all = Json::array();
  for (const auto& [engine, factors] : found) {
    const Quartiles of = quartiles(factors);
    const bool any = !factors.empty();
    all.push_back({{"engine", engine},
                   {"median", any ? Json(of.median) : Json(nullptr)},
                   {"low", any ? Json(of.low) : Json(nullptr)},
                   {"high", any ? Json(of.high) : Json(nullptr)},
                   {"cases", cases_with.at(engine)},
                   {"reached", factors.size()}});
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
  Json factors = factors_json(cases);
  return {{"standard", standard},
          {"error_targets", error_targets},
          {"time_targets", time_targets},
          {"cases", std::move(cases)},
          {"factors", std::move(factors)}};
}

}  // namespace plumb
