#include "reference/converged/converged.h"

#include <cstddef>
#include <memory>
#include <span>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "scenarios/scene/vec.h"

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

struct SecondAnswer {
  std::string name;
  std::unique_ptr<const Converged> answer;  // null if it cannot run the scene
  std::string reason;                       // why it is null or ends early

  bool knows(double time) const { return answer != nullptr && time <= answer->valid_until(); }
};

SecondAnswer hear(const OtherEngine& candidate, const Scene& scene, std::vector<double> times,
                  const Refinement& first) {
  SecondAnswer second{.name = candidate.name};
  Refinement refinement = first;
  refinement.engine = Catalog<Engine>::find(candidate.engine);
  refinement.settings = candidate.settings;
  refinement.tolerance = second_share;
  if (refinement.engine == nullptr) {
    second.reason = "not part of this build";
    return second;
  }
  try {
    second.answer = std::make_unique<const Converged>(scene, std::move(times), refinement);
    second.reason = second.answer->reason();
  } catch (const std::domain_error& refused) {
    second.reason = refused.what();
  }
  return second;
}

std::string contradiction(const Scene& scene, double time, std::size_t body, double apart, const SecondAnswer& second) {
  std::ostringstream words;
  words.precision(3);
  words << "the engines disagree from t = " << time << " s on: \"" << scene.bodies[body].name << "\" is " << apart
        << " m elsewhere in " << second.name << ", beyond what either may be off";
  return words.str();
}

std::string silence(double time, std::span<const SecondAnswer> seconds) {
  std::ostringstream words;
  words.precision(3);
  words << "no second engine has an answer at t = " << time << " s";
  for (const SecondAnswer& second : seconds) words << "; " << second.name << ": " << second.reason;
  return words.str();
}

// Ends the answer where a second answer contradicts it or none knows.
void confirm(Converged& answer, const Scene& scene, std::span<const SecondAnswer> seconds) {
  for (std::size_t moment = 0; moment < answer.times().size(); ++moment) {
    const double time = answer.times()[moment];
    if (time > answer.valid_until()) return;
    bool known = false;
    for (const SecondAnswer& second : seconds) {
      if (!second.knows(time)) continue;
      known = true;
      const auto body = answer.contradicted_by(*second.answer, moment);
      if (!body) continue;
      const Vec here = answer.states(moment)[*body].position;
      const Vec there = second.answer->states(moment)[*body].position;
      answer.end_before(moment, contradiction(scene, time, *body, length(here - there), second));
      return;
    }
    if (!known) return answer.end_before(moment, silence(time, seconds));
  }
}

}  // namespace

ConvergedTruth confirmed_truth(const Scene& scene, std::vector<double> times, const Refinement& first) {
  std::vector<SecondAnswer> seconds;
  ConvergedTruth truth = truth_of([&] {
    auto answer = std::make_shared<Converged>(scene, std::move(times), first);
    std::vector<double> until = answer->times();
    std::erase_if(until, [&](double time) { return time > answer->valid_until(); });
    for (const OtherEngine& candidate : other_engines()) {
      seconds.push_back(hear(candidate, scene, until, first));
      if (seconds.back().knows(until.back())) break;
    }
    confirm(*answer, scene, seconds);
    return answer;
  });
  for (const SecondAnswer& second : seconds) {
    if (!second.knows(scene.duration * 1e-9)) continue;
    truth.confirmed_by += (truth.confirmed_by.empty() ? "" : ", ") + second.name;
  }
  return truth;
}

}  // namespace plumb
