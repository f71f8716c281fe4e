#include "reports/judge/truth.h"

namespace plumb {

Truth::Truth(const Engine& closed_form, const Scene& scene)
    : closed_form_(closed_form),
      scene_(scene),
      until_(closed_form.build(scene, complete(closed_form, {}))->valid_until()) {}

std::optional<std::vector<BodyState>> Truth::at(double time) const {
  if (time > until_) return std::nullopt;
  const auto simulation = closed_form_.build(scene_, complete(closed_form_, {}));
  if (time > 0) simulation->step(time);
  std::vector<BodyState> states(scene_.bodies.size());
  simulation->read(states);
  return states;
}

}  // namespace plumb
