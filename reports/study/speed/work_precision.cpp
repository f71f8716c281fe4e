#include "reports/study/speed/work_precision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

namespace plumb {
namespace {

// Two-sided 95 % quantiles of Student's t for 1, 2, ... degrees of freedom (Abramowitz & Stegun, table 26.10); beyond
// them the normal distribution's.
constexpr std::array<double, 10> student{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228};
constexpr double normal = 1.96;

double power_law(double x, double x0, double y0, double x1, double y1) {
  return y0 * std::pow(y1 / y0, std::log(x / x0) / std::log(x1 / x0));
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

std::optional<Reading> time_to_reach(std::span<const WorkPoint> front, double error) {
  const auto good = std::find_if(front.begin(), front.end(), [&](const WorkPoint& one) { return one.error <= error; });
  if (good == front.end()) return std::nullopt;
  if (good == front.begin()) return Reading{good->time, good->error < error};
  const WorkPoint& before = *(good - 1);
  return Reading{power_law(error, before.error, before.time, good->error, good->time)};
}

std::optional<Reading> error_within(std::span<const WorkPoint> front, double time) {
  const auto dear = std::find_if(front.begin(), front.end(), [&](const WorkPoint& one) { return one.time > time; });
  if (dear == front.begin()) return std::nullopt;
  const WorkPoint& before = *(dear - 1);
  if (dear == front.end()) return Reading{before.error, before.time < time};
  return Reading{power_law(time, before.time, before.error, dear->time, dear->error)};
}

std::optional<Order> order_of(std::span<const double> steps, std::span<const double> errors) {
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
  const double left = std::max(0.0, yy - slope * xy);  // sum of squares about the line
  const double t = n - 2 <= student.size() ? student[n - 3] : normal;
  return Order{slope, t * std::sqrt(left / (count - 2) / xx), static_cast<int>(n)};
}

std::optional<Order> settled_order(std::span<const double> steps, std::span<const double> errors) {
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

}  // namespace plumb
