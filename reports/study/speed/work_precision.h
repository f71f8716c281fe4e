#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// Error against step and against cost: orders of convergence, fronts of runs, and what they say about methods.
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

/// One run. Both numbers are above 0.
struct WorkPoint {
  double time = 0;   // s per simulated second
  double error = 0;  // m
};

/// The indices of the points that no other beats in both numbers, the cheapest first; of equal points the first. Errors
/// decrease along the front.
std::vector<std::size_t> pareto_front(std::span<const WorkPoint>);

/// A value read off a measured front.
struct FrontReading {
  double value = 0;
  bool bound =
      false;  // upper bound only: the front ends before the requested value, with a run that is at least as good
};

/// s per simulated second, to reach an error of at most `error`; nullopt if no run does. `front`: in the order of
/// pareto_front. Between two runs it follows a power law; it never extrapolates.
std::optional<FrontReading> time_to_reach(std::span<const WorkPoint> front, double error);

/// The error that `time` buys; nullopt if no run was that fast. Same interpolation.
std::optional<FrontReading> error_within(std::span<const WorkPoint> front, double time);

/// What the timed runs of the speed study show: fronts, the times to fixed errors (1 cm, 1 mm, 0.1 mm, and 10, 1, 0.1 %
/// of the case's scale) and errors at equal time in each case; and over all cases, for each of these errors, how often
/// each method gets there, how often it is the fastest, and its time over the fastest method's ("targets"). Each method
/// bears how its engine's code runs ("execution"): a factor between two kinds is one of code, too.
nlohmann::ordered_json work_precision_of(const std::vector<JobResult>&);

/// The result of the speed study for the console: who is the fastest to an error, in a sentence, then a table of the
/// times, of the columns that fit. `timings`: as work_precision_of returns them; width: columns.
std::string times_text(const nlohmann::ordered_json& timings, std::size_t width);

}  // namespace plumb
