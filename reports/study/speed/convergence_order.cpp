#include "reports/study/speed/convergence_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>

#include "reports/study/job.h"
#include "reports/study/selection.h"

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

}  // namespace plumb
