#include "reference/exact/ballistic.h"

#include <utility>

#include "reference/exact/closed_form.h"
#include "reference/exact/recognise.h"

namespace plumb {

Ballistic::Ballistic(std::vector<BodyState> start, std::vector<Vec> acceleration)
    : start_(std::move(start)), acceleration_(std::move(acceleration)) {}

void Ballistic::at(double t, std::span<BodyState> out) const {
  for (std::size_t i = 0; i < start_.size(); ++i) out[i] = thrown(start_[i], acceleration_[i], t);
}

namespace {

bool may_meet(const Body& a, const Body& b) {
  const bool moves = a.type == BodyType::dynamic || b.type == BodyType::dynamic;
  return moves && (a.layers & b.layers) != 0 && !a.shapes.empty() && !b.shapes.empty();
}

Recognised<Ballistic> recognise_ballistic(const Scene& scene) {
  if (const std::string reason = beyond_textbook(scene); !reason.empty()) return reason;
  std::vector<Vec> acceleration;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (may_meet(scene.bodies[i], scene.bodies[j])) return "solves bodies that share no layer with another";
    }
    acceleration.push_back(gravity_of(scene, scene.bodies[i]));
  }
  return Ballistic(start_of(scene), std::move(acceleration));
}

const Catalog<Engine>::Entry ballistic_entry{
    closed_form<Ballistic>({.name = "ballistic",
                            .about = "Free fall of bodies that meet nothing: r = r0 + v0 t + g t^2/2, angle = a0 + w t",
                            .source = "Galileo, Discorsi (1638), fourth day; Goldstein, Classical Mechanics, ch. 1"},
                           recognise_ballistic)};

}  // namespace
}  // namespace plumb
