#pragma once

#include <optional>
#include <span>
#include <vector>

/// What runs cost and what they give, without knowing whose they are.
namespace plumb {

/// A run: s per simulated second, and how far it is off. Both above 0.
struct WorkPoint {
  double time = 0;
  double error = 0;
};

/// Those that no other beats in both, the cheapest first; of equal ones the first. Errors fall along it.
std::vector<std::size_t> pareto_front(std::span<const WorkPoint>);

/// A reading off a measured front. `bound`: the front does not reach so far to that side, and its end is at least as
/// good as what was asked for; the value is then a bound from above.
struct Reading {
  double value = 0;
  bool bound = false;
};

/// s, to be off by no more than `error`; nothing where no run was. `front`: as pareto_front orders it. Between two runs
/// a power law, never beyond them.
std::optional<Reading> time_to_reach(std::span<const WorkPoint> front, double error);

/// The error that `time` buys; nothing where no run was so fast.
std::optional<Reading> error_within(std::span<const WorkPoint> front, double time);

/// Measured order of convergence: the slope of log error over log step, by least squares, with the half-width of its
/// 95 % confidence interval (Student's t).
struct Order {
  double slope = 0;
  double half_width = 0;
  int points = 0;
};

/// Nothing of fewer than three; steps and errors above 0.
std::optional<Order> order_of(std::span<const double> steps, std::span<const double> errors);

/// An order is a statement about small steps: that of the finest steps from which on it has settled, each step to the
/// next by the mean of those below, give or take 0.15. Nothing where that leaves fewer than three. Steps descend.
std::optional<Order> settled_order(std::span<const double> steps, std::span<const double> errors);

}  // namespace plumb
