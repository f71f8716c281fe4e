#include "reports/study/stability/trial.h"

#include <stdexcept>

#include "scenarios/catalog.h"

namespace plumb {

Seen see(const Trial& trial, const EngineConfig& config) {
  Seen seen;
  const double end = trial.scene->duration - trial.dt / 2;
  const auto name = [&](std::optional<std::size_t> body) { return body ? trial.scene->bodies[*body].name : ""; };
  const Outcome outcome =
      watch(*trial.scene, config, trial.dt, trial.first_step, [&](double time, std::span<const BodyState> states) {
        seen.time = time;
        const Moment moment{time, states, time > end};
        for (const Watch& one : trial.watches) {
          const std::optional<Symptom> symptom = one.look(moment);
          if (!symptom) continue;
          seen.fate = symptom->fate;
          seen.body = name(symptom->body);
          return false;
        }
        return true;
      });
  if (outcome.status == Status::ok) return seen;
  const Fate fate = outcome.status == Status::not_supported ? Fate::not_supported
                    : outcome.lost                          ? Fate::diverges
                                                            : Fate::fails;
  return {fate, outcome.time, name(outcome.lost), outcome.reason};
}

Scene scene_of(const char* scenario, const Parameters& changes) {
  const Scenario* found = Catalog<Scenario>::find(scenario);
  if (found == nullptr) throw std::logic_error(std::string("there is no scenario \"") + scenario + "\"");
  return found->scene(complete(*found, changes));
}

}  // namespace plumb
