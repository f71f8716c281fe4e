#include "reports/find/isolated.h"

#include <array>
#include <limits>

#include "reports/study/runner.h"

namespace plumb {
namespace {

Opinion opinion_apart(const Scene& scene, Posed posed, const EngineConfig& config, const Known& known,
                      const RunLimits& limits) {
  const std::array jobs{
      Job{.key = scene.name, .run = [&] { return JobOutput{.values = as_json(judged(scene, posed, config, known))}; }}};
  const std::array<std::span<const Job>, 1> units{std::span<const Job>(jobs)};
  Opinion opinion;
  execute(units, {.parallel = 1, .limits = {limits.seconds, limits.mebibytes}},
          [&](std::span<const JobResult> results) {
            const JobResult& result = results.front();
            if (result.ending == Ending::done) {
              opinion = opinion_of(result.output.values);
              return;
            }
            opinion = {.status = "failed", .note = result.reason};
            opinion.complaints.push_back(
                {.judge = "run", .what = name_of(result.ending), .ratio = std::numeric_limits<double>::infinity()});
          });
  return opinion;
}

}  // namespace

Opinion judged_apart(const Scene& scene, Posed posed, const Suspect& suspect, const Known& known,
                     const RunLimits& limits) {
  Opinion opinion = opinion_apart(scene, posed, suspect.config, known, limits);
  if (!suspect.right || opinion.complaints.empty()) return opinion;
  const Opinion right = opinion_apart(scene, posed, *suspect.right, known, limits);
  std::erase_if(opinion.complaints, [&](const Complaint& one) { return right.of(one.reason()) != nullptr; });
  return opinion;
}

}  // namespace plumb
