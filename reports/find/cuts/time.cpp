#include <cmath>

#include "reports/find/judge.h"
#include "reports/find/shrink.h"
#include "scenarios/catalog.h"

namespace plumb::cuts::time {
namespace {

// In hundredths of a second, as a person would write it, and no shorter.
double written(double time) { return std::ceil(time * 100 - 1e-9) / 100; }

double steps_to(double time) { return std::ceil(time / search_step - 1e-9); }

// Ending a few steps after the failure, or earlier: a converged reference is asked at the latest time at which it
// tells anything, so the failure may move with the end.
std::vector<Scene> shorter(const Scene& scene, const Failure& at) {
  std::vector<Scene> all;
  const double steps = steps_to(scene.duration);
  const double failing = std::isfinite(at.complaint.time) ? steps_to(at.complaint.time) : steps;
  for (const double wanted : {failing + 1, failing + 6, std::floor(steps / 2), std::floor(steps * 3 / 4)}) {
    const double duration = written(wanted * search_step);
    if (wanted < 1 || !(duration < scene.duration)) continue;
    all.push_back(scene);
    all.back().duration = duration;
  }
  return all;
}

// Starting from what the run reaches a few steps before the failure, or earlier, in numbers of few digits.
std::vector<Scene> later(const Scene& scene, const Failure& at) {
  std::vector<Scene> all;
  if (!std::isfinite(at.complaint.time)) return all;
  const double failing = steps_to(at.complaint.time);
  for (const double wanted : {failing - 2, failing - 6, failing / 2, failing / 4}) {
    const double time = std::floor(wanted) * search_step;
    if (time < search_step || time >= scene.duration) continue;
    const std::vector<BodyState> states = at.states(time);
    if (states.empty()) continue;
    Scene from_there = started_at(scene, states, time);
    from_there.duration = written(from_there.duration);
    for (const int digits : {3, 5}) {
      if (auto one = with_digits(from_there, digits)) all.push_back(std::move(*one));
    }
  }
  return all;
}

const Catalog<Cut>::Entry of_end{{.name = "shorten", .order = 0, .simpler = shorter}};
const Catalog<Cut>::Entry of_start{{.name = "start later", .order = 6, .simpler = later, .from_run = true}};

}  // namespace
}  // namespace plumb::cuts::time
