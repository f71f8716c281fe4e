#include <fmt/format.h>

#include <string>

#include "reports/judge/poses.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/scene.h"

namespace plumb::relations::halves {
namespace {

// A method of order p is off by about C h^p: a run with half the step differs from the run by no more than both are off
// by, and so does one with a quarter from the one with half, with what the method states for those steps (see
// judge/method_error.h): terms in h and h^2, and thresholds that do not shrink.
RelationCheck differing(const RelationRun& run, std::span<const RelationRun> images, std::size_t coarse,
                        std::size_t fine) {
  const RelationRun* runs[] = {&run, &images[0], &images[1]};
  const auto state = [&](std::size_t which, std::size_t moment, std::size_t body) {
    return runs[which]->trace.states(moment << which)[body];
  };
  Trace trace(run.scene.bodies.size());
  for (std::size_t moment = 0; moment < run.trace.size(); ++moment) {
    const std::size_t there = moment << coarse;
    if (there >= runs[coarse]->trace.size() || (moment << fine) >= runs[fine]->trace.size()) break;
    trace.record(run.trace.time(moment), runs[coarse]->trace.states(there), runs[coarse]->trace.contacts(there));
  }
  const RelationRun sampled{run.scene, trace, run.stepping, run.amplification};
  std::vector<double> rounding;
  const std::vector<double> of_coarse = pose_rounding(*runs[coarse]);
  const std::vector<double> of_fine = pose_rounding(*runs[fine]);
  for (std::size_t moment = 0; moment < trace.size(); ++moment) {
    rounding.push_back(of_coarse[moment << coarse] + of_fine[moment << fine]);
  }
  return compare_poses(
      sampled, trace.size(), [&](std::size_t moment, std::size_t body) { return state(fine, moment, body); },
      explained_by_method(sampled, rounding, runs[coarse]->stepping, runs[fine]->stepping));
}

RelationCheck compare(const RelationRun& run, std::span<const RelationRun> images) {
  const RelationCheck first = differing(run, images, 0, 1);
  const RelationCheck second = differing(run, images, 1, 2);
  RelationCheck result = worse(first, second);
  if (!first.why_not.empty() || !second.why_not.empty()) return result;
  result.check.detail += fmt::format("; dt and dt/2 differ by {:.2g} m at most, dt/2 and dt/4 by {:.2g}",
                                     first.check.value, second.check.value);
  return result;
}

// What hits a body on a path meets the mean velocity of its step.
std::string excludes(const Scene& scene, const Stepping&) {
  return has_paths(scene) ? "bodies on paths go straight within a step, whatever its length" : "";
}

const Catalog<MetamorphicRelation>::Entry entry{
    {.name = "halves",
     .unit = "m",
     .definition = "runs with half and a quarter of the step differ from it, and each other, by no more than the "
                   "method's stated errors for these steps, as the scene amplifies them",
     .excludes = excludes,
     .images = [](const Scene& scene, const Trace&, double dt) -> std::vector<Image> {
       return {{scene, dt / 2}, {scene, dt / 4}};
     },
     .compare = compare}};

}  // namespace
}  // namespace plumb::relations::halves
