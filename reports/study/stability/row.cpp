#include "reports/study/stability/row.h"

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

class RowFinder {
 public:
  RowFinder(const StabilityMap& map, double y, const EngineConfig& config) : map_(map), y_(y), config_(config) {}

  // The worst of its runs.
  Seen cell(double x) const {
    Seen worst{.fate = Fate::not_supported};
    for (const Trial& trial : map_.trials(x, y_, config_)) {
      const Seen seen = see(trial, config_);
      if (seen.fate >= worst.fate) worst = seen;
    }
    return worst;
  }

  Bracket bracket(const Boundary& of, const std::vector<double>& xs, const std::vector<Seen>& cells) const {
    const auto bad = static_cast<std::size_t>(
        std::find_if(cells.begin(), cells.end(), [&](const Seen& seen) { return of.fails(seen.fate); }) -
        cells.begin());
    const auto good = std::find_if(std::make_reverse_iterator(cells.begin() + static_cast<std::ptrdiff_t>(bad)),
                                   cells.rend(), [](const Seen& seen) { return seen.fate != Fate::not_supported; });
    Bracket found;
    if (good != cells.rend()) found.low = xs[static_cast<std::size_t>(cells.rend() - good) - 1];
    if (bad == cells.size()) return found;
    found.high = xs[bad];
    found.seen = cells[bad];
    if (found.low) narrow(of, found);
    return found;
  }

 private:
  void narrow(const Boundary& of, Bracket& found) const {
    while (!is_narrow(of, *found.low, *found.high)) {
      const double x = map_.x.between(*found.low, *found.high);
      if (x == *found.low) return;
      const Seen seen = cell(x);
      if (seen.fate == Fate::not_supported) return;
      if (of.fails(seen.fate)) {
        found.high = x;
        found.seen = seen;
      } else {
        found.low = x;
      }
    }
  }

  bool is_narrow(const Boundary& of, double low, double high) const {
    if (map_.x.whole) return false;  // until nothing is between them
    const double width = std::abs(high - low);
    return width <= (map_.x.logarithmic ? of.grain * std::min(low, high) : of.grain);
  }

  const StabilityMap& map_;
  double y_;
  const EngineConfig& config_;
};

}  // namespace

MapRow row_of(const StabilityMap& map, const std::vector<double>& xs, double y, const EngineConfig& config) {
  const RowFinder finder(map, y, config);
  MapRow row;
  for (const double x : xs) row.cells.push_back(finder.cell(x));
  for (const Boundary& boundary : map.boundaries) row.brackets.push_back(finder.bracket(boundary, xs, row.cells));
  return row;
}

Agreement agreement_of(const Axis& x, const Boundary& boundary, const std::optional<double>& low,
                       const std::optional<double>& high, double theory) {
  // On which side of a value theory has the boundary, counted from x.from to x.to.
  const double sign = x.to > x.from ? 1 : -1;
  const auto beyond = [&](double value) { return sign * (theory - value) >= 0; };
  const auto apart = [&](double value) {
    const double off = std::abs(value - theory);
    return x.logarithmic ? off / theory : off;
  };
  if (low && high) {
    const double off = apart((*low + *high) / 2);
    return {off <= boundary.agreement, off};
  }
  const double edge = low ? *low : *high;  // all that is known: the boundary is on the other side of it
  const bool agrees = low ? beyond(edge) : !beyond(edge);
  if (agrees) return {true, std::nullopt};
  const double off = apart(edge);
  return {off <= boundary.agreement, std::isfinite(off) ? std::optional(off) : std::nullopt};
}

}  // namespace plumb
