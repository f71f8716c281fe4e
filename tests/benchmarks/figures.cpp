#include "figures.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace plumb::benchmarks {
namespace {

double time_of(const Lap& lap, Basis basis) { return basis == Basis::cpu ? lap.cpu : lap.wall; }

Quartiles a_step(std::span<const Lap> laps, int steps, Basis basis) {
  std::vector<double> times;
  for (const Lap& lap : laps) times.push_back(time_of(lap, basis) / steps);
  return quartiles(times);
}

}  // namespace

bool disturbed(const Lap& lap) { return std::abs(lap.wall - lap.cpu) > 0.1 * lap.wall; }

Figures figures(std::span<const Lap> laps, std::span<const Lap> reference, int steps, Basis basis) {
  Figures all{.wall = a_step(laps, steps, Basis::wall),
              .cpu = a_step(laps, steps, Basis::cpu),
              .disturbed = static_cast<int>(std::count_if(laps.begin(), laps.end(), disturbed))};
  if (laps.empty() || reference.empty()) return all;
  if (laps.size() != reference.size()) throw std::invalid_argument("figures: rounds without their reference");
  std::vector<double> speeds;
  for (std::size_t i = 0; i < laps.size(); ++i) {
    speeds.push_back(time_of(reference[i], basis) / time_of(laps[i], basis));
  }
  all.speed = quartiles(speeds);
  return all;
}

}  // namespace plumb::benchmarks
