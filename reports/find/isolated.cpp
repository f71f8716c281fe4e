#include "reports/find/isolated.h"

#include <array>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "reports/study/runner.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

// Times the processor's seconds, until one that waits instead of computing is ended.
constexpr double patience = 10;

// Does some work in a process of its own.
JobResult done_apart(const std::string& key, const RunLimits& limits, const std::function<Json()>& work) {
  const std::array jobs{Job{.key = key, .run = [&] { return JobOutput{.values = work()}; }}};
  const std::array<std::span<const Job>, 1> units{std::span<const Job>(jobs)};
  JobResult result;
  execute(units, {.parallel = 1, .limits = {patience * limits.seconds, limits.mebibytes, limits.seconds}},
          [&](std::span<const JobResult> results) { result = results.front(); });
  return result;
}

Complaint lost(const JobResult& result, const std::string& judge) {
  return {.judge = judge, .what = name_of(result.ending), .ratio = std::numeric_limits<double>::infinity()};
}

// What is known of a scene, found out when an engine has run it.
class LazyKnown {
 public:
  LazyKnown(const Scene& scene, Posed posed, const Judges& judges) : scene_(scene), posed_(posed), judges_(judges) {}

  const Known& get() {
    if (!known_) known_.emplace(scene_, posed_, judges_);
    return *known_;
  }

 private:
  const Scene& scene_;
  Posed posed_;
  Judges judges_;
  std::optional<Known> known_;
};

Opinion opinion_apart(const Scene& scene, Posed posed, const EngineConfig& config, LazyKnown& lazy,
                      const RunLimits& limits) {
  const JobResult alone = done_apart(scene.name, limits, [&] { return as_json(judged_by_laws(scene, posed, config)); });
  if (alone.ending != Ending::done) {
    Opinion opinion{.status = "failed", .note = alone.reason};
    opinion.complaints.push_back(lost(alone, "run"));
    return opinion;
  }
  Opinion opinion = opinion_of(alone.output.values);
  if (opinion.status != name_of(Status::ok)) return opinion;
  const Known& known = lazy.get();
  if (known.empty()) return opinion;
  const JobResult more = done_apart(scene.name, limits, [&] {
    Json all = Json::array();
    for (const Complaint& one : judged_by(known, scene, config)) all.push_back(as_json(one));
    return Json{{"complaints", std::move(all)}};
  });
  // Many images of a slow scene take long: that is not the engine's fault.
  opinion.by_laws_alone = more.ending == Ending::timed_out;
  if (more.ending != Ending::done && !opinion.by_laws_alone) opinion.complaints.push_back(lost(more, "relation"));
  if (more.ending == Ending::done) {
    for (const Json& one : more.output.values.at("complaints")) opinion.complaints.push_back(complaint_of(one));
  }
  return opinion;
}

Opinion judged_with(LazyKnown& known, const Scene& scene, Posed posed, const Suspect& suspect,
                    const RunLimits& limits) {
  Opinion opinion = opinion_apart(scene, posed, suspect.config, known, limits);
  if (!suspect.right || opinion.complaints.empty()) return opinion;
  const Opinion right = opinion_apart(scene, posed, *suspect.right, known, limits);
  std::erase_if(opinion.complaints, [&](const Complaint& one) { return right.of(one.reason()) != nullptr; });
  return opinion;
}

Json judged_by_all(const Judges& judges, const Scene& scene, Posed posed, std::span<const Suspect> suspects,
                   const RunLimits& limits) {
  LazyKnown known(scene, posed, judges);
  Json opinions = Json::array();
  for (const Suspect& suspect : suspects) {
    opinions.push_back(as_json(judged_with(known, scene, posed, suspect, limits)));
  }
  return {{"opinions", std::move(opinions)}};
}

}  // namespace

std::vector<Opinion> judged_apart(const Scene& scene, Posed posed, std::span<const Suspect> suspects,
                                  const Judges& judges, const RunLimits& limits) {
  // What is known comes from engines as well, which may crash or hang in such a scene. Beside it, each suspect and its
  // right engine run twice, each within the limit.
  const RunLimits all{.seconds = limits.seconds * (1 + 4 * static_cast<double>(suspects.size())),
                      .mebibytes = limits.mebibytes};
  const JobResult informed =
      done_apart(scene.name, all, [&] { return judged_by_all(judges, scene, posed, suspects, limits); });
  const Json found = informed.ending == Ending::done ? informed.output.values
                                                     : judged_by_all(Judges::laws(), scene, posed, suspects, limits);
  std::vector<Opinion> opinions;
  for (const Json& one : found.at("opinions")) opinions.push_back(opinion_of(one));
  if (informed.ending != Ending::done) {
    for (Opinion& one : opinions) one.by_laws_alone = true;
  }
  return opinions;
}

std::vector<BodyState> states_apart(const Scene& scene, const Suspect& suspect, double time, const RunLimits& limits) {
  const JobResult reached = done_apart(scene.name, limits, [&] {
    Json states = Json::array();
    const Outcome outcome = run(scene, suspect.config, search_step);
    const bool there = outcome.trace != nullptr && outcome.time >= time;
    for (std::size_t i = 0; there && i < scene.bodies.size(); ++i) {
      const BodyState state = outcome.trace->state_at(i, time);
      states.push_back({state.position.x, state.position.y, state.angle, state.velocity.x, state.velocity.y,
                        state.angular_velocity});
    }
    return Json{{"states", std::move(states)}};
  });
  std::vector<BodyState> states;
  if (reached.ending != Ending::done) return states;
  for (const Json& one : reached.output.values.at("states")) {
    states.push_back({{one[0], one[1]}, one[2], {one[3], one[4]}, one[5]});
  }
  return states;
}

FailingRun shown_apart(const Scene& scene, const Complaint& complaint, const Suspect& suspect,
                       std::span<const Suspect> others, const RunLimits& limits) {
  const JobResult shown =
      done_apart(scene.name, limits, [&] { return as_json(run_to_show(scene, complaint, suspect, others)); });
  return shown.ending == Ending::done ? failing_run_of(shown.output.values) : FailingRun{};
}

}  // namespace plumb
