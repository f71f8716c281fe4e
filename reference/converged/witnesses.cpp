#include "reference/converged/witnesses.h"

#include <cstddef>
#include <memory>
#include <span>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "reference/plane.h"

namespace plumb {
namespace {

struct OtherEngine {
  std::string name;
  std::string engine;
  Settings settings;
};

// Engines that share no solver with ours, in double precision first. With many iterations, because what they leave
// vanishes only along with the step. Box2D's float reaches less far. The last one shares our collision detection, so it
// is asked only where no other can say anything.
std::vector<OtherEngine> other_engines() {
  return {{"chipmunk", "chipmunk", {{"iterations", "40"}, {"slop", "0.01"}}},
          {"box2d", "box2d", {{"velocity", "40"}, {"position", "20"}}},
          {"impulse:solver=exact", "impulse", {{"solver", "exact"}}}};
}

struct Witness {
  std::string name;
  std::unique_ptr<const Converged> answer;  // null if it cannot run the scene
  std::string reason;                       // why it is null or ends early

  bool knows(double time) const { return answer != nullptr && time <= answer->valid_until(); }
};

Witness hear(const OtherEngine& candidate, const Scene& scene, std::vector<double> times, const Refinement& first) {
  Witness witness{.name = candidate.name};
  Refinement refinement = first;
  refinement.engine = Catalog<Engine>::find(candidate.engine);
  refinement.settings = candidate.settings;
  refinement.tolerance = second_share;
  if (refinement.engine == nullptr) {
    witness.reason = "not part of this build";
    return witness;
  }
  try {
    witness.answer = std::make_unique<const Converged>(scene, std::move(times), refinement);
    witness.reason = witness.answer->reason();
  } catch (const std::domain_error& refused) {
    witness.reason = refused.what();
  }
  return witness;
}

std::string contradiction(const Scene& scene, double time, std::size_t body, double apart, const Witness& witness) {
  std::ostringstream words;
  words.precision(3);
  words << "the witnesses disagree from t = " << time << " s on: \"" << scene.bodies[body].name << "\" is " << apart
        << " m elsewhere in " << witness.name << ", beyond what either may be off";
  return words.str();
}

std::string silence(double time, std::span<const Witness> witnesses) {
  std::ostringstream words;
  words.precision(3);
  words << "no second witness at t = " << time << " s";
  for (const Witness& witness : witnesses) words << "; " << witness.name << ": " << witness.reason;
  return words.str();
}

// Ends the answer where a witness contradicts it or none knows.
void confirm(Converged& answer, const Scene& scene, std::span<const Witness> witnesses) {
  for (std::size_t moment = 0; moment < answer.times().size(); ++moment) {
    const double time = answer.times()[moment];
    if (time > answer.valid_until()) return;
    bool known = false;
    for (const Witness& witness : witnesses) {
      if (!witness.knows(time)) continue;
      known = true;
      const auto body = answer.contradicted_by(*witness.answer, moment);
      if (!body) continue;
      const Vec here = answer.states(moment)[*body].position;
      const Vec there = witness.answer->states(moment)[*body].position;
      answer.end_before(moment, contradiction(scene, time, *body, length(here - there), witness));
      return;
    }
    if (!known) return answer.end_before(moment, silence(time, witnesses));
  }
}

}  // namespace

ConvergedTruth witnessed_truth(const Scene& scene, std::vector<double> times, const Refinement& first) {
  std::vector<Witness> witnesses;
  ConvergedTruth truth = truth_of([&] {
    auto answer = std::make_shared<Converged>(scene, std::move(times), first);
    std::vector<double> until = answer->times();
    std::erase_if(until, [&](double time) { return time > answer->valid_until(); });
    for (const OtherEngine& candidate : other_engines()) {
      witnesses.push_back(hear(candidate, scene, until, first));
      if (witnesses.back().knows(until.back())) break;
    }
    confirm(*answer, scene, witnesses);
    return answer;
  });
  for (const Witness& witness : witnesses) {
    if (!witness.knows(scene.duration * 1e-9)) continue;
    truth.confirmed_by += (truth.confirmed_by.empty() ? "" : ", ") + witness.name;
  }
  return truth;
}

}  // namespace plumb
