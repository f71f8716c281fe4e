#include "reports/prove/variation.h"

#include <algorithm>
#include <array>

#include "scenarios/random.h"

namespace plumb {

Variation variation_of(std::uint64_t seed) {
  Random random(seed);
  const auto one_of = [&](const auto& choices) { return choices[random.next() % choices.size()]; };
  constexpr std::array precisions{"float", "double"};
  constexpr std::array broad_phases{"auto", "brute", "grid", "tree"};
  constexpr std::array workers{"1", "2", "3", "4"};
  constexpr std::array lanes{"accurate", "accurate-scalar"};
  return {.seed = seed,
          .settings = {{"precision", one_of(precisions)},
                       {"broad-phase", one_of(broad_phases)},
                       {"workers", one_of(workers)},
                       {"solver", one_of(lanes)}}};
}

Case Variation::of(const Case& asked) const {
  const auto& parameters = asked.scenario->parameters;
  const auto random = std::find_if(parameters.begin(), parameters.end(),
                                   [](const Parameter& parameter) { return parameter.name == "seed"; });
  if (random == parameters.end()) return asked;
  Case varied = asked;
  varied.parameters.at("seed") = std::min(random->min + static_cast<double>(seed), random->max);
  varied.scene = std::make_shared<const Scene>(asked.scenario->scene(varied.parameters));
  return varied;
}

std::string Variation::words() const {
  std::string text = "seed " + std::to_string(seed) + ":";
  for (const auto& [option, value] : settings) text += (text.back() == ':' ? " " : ", ") + option + "=" + value;
  return text;
}

}  // namespace plumb
