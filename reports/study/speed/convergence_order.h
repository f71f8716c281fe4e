#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <vector>

namespace plumb {

struct JobResult;

/// A measured order of convergence: the slope of log error over log step, by least squares, with the half-width of its
/// 95 % confidence interval (Student's t).
struct ConvergenceOrder {
  double slope = 0;
  double half_width = 0;
  int points = 0;
};

/// Steps and errors must be above 0. Returns nullopt for fewer than three.
std::optional<ConvergenceOrder> order_of(std::span<const double> steps, std::span<const double> errors);

/// The order that holds for small steps. It is fitted to the finest steps at which the order has settled: each slope
/// between neighbouring steps is within 0.15 of the mean of those at finer steps. Steps must descend. Returns nullopt
/// if fewer than three remain.
std::optional<ConvergenceOrder> settled_order(std::span<const double> steps, std::span<const double> errors);

constexpr double order_tolerance = 0.2;  // by which a measured order may differ from the stated one

/// For each method, setting and case of the speed study: the order measured over its steps, the order that the method
/// states, and whether they agree.
nlohmann::ordered_json orders_of(const std::vector<JobResult>&);

/// Whether a job of the speed study has measured an error.
bool has_error(const JobResult&);

}  // namespace plumb
