#include <cmath>

#include "reports/find/judge.h"
#include "reports/find/shrink.h"
#include "scenarios/catalog.h"

namespace plumb::cuts::time {
namespace {

// Ending a few steps after the failure, or earlier: a converged reference is asked at the latest time at which it
// tells anything, so the failure may move with the end.
std::vector<Scene> shorter(const Scene& scene, const Complaint& at) {
  std::vector<Scene> all;
  const double steps = std::ceil(scene.duration / search_step - 1e-9);
  const double failing = std::isfinite(at.time) ? std::ceil(at.time / search_step - 1e-9) : steps;
  for (const double wanted : {failing + 1, failing + 6, std::floor(steps / 2), std::floor(steps * 3 / 4)}) {
    // In hundredths of a second, as a person would write it.
    const double duration = std::ceil(wanted * search_step * 100 - 1e-9) / 100;
    if (wanted < 1 || !(duration < scene.duration)) continue;
    all.push_back(scene);
    all.back().duration = duration;
  }
  return all;
}

const Catalog<Cut>::Entry entry{{.name = "shorten", .order = 0, .simpler = shorter}};

}  // namespace
}  // namespace plumb::cuts::time
