#include "reference/exact/spring.h"

#include <cmath>

#include "reference/exact/closed_form.h"
#include "reference/exact/recognise.h"
#include "scenarios/scene/mass.h"

namespace plumb {

// s = e^(-d t) (A cos w t + B sin w t), d = c/(2 m), w^2 = k/m - d^2, with A and B from s(0) and s'(0) = B w - d A.
Oscillator::Oscillator(double stretch, double speed, double mass, double stiffness, double damping)
    : decay_(damping / (2 * mass)),
      frequency_(std::sqrt(stiffness / mass - decay_ * decay_)),
      cosine_(stretch),
      sine_((speed + decay_ * stretch) / frequency_) {}

Oscillator::State Oscillator::at(double t) const {
  const double envelope = std::exp(-decay_ * t);
  const double c = std::cos(frequency_ * t);
  const double s = std::sin(frequency_ * t);
  const double stretch = cosine_ * c + sine_ * s;
  const double rate = frequency_ * (sine_ * c - cosine_ * s);
  return {envelope * stretch, envelope * (rate - decay_ * stretch)};
}

double Oscillator::amplitude() const { return std::hypot(cosine_, sine_); }

namespace {

struct SpringMass {
  std::vector<BodyState> start;
  std::size_t body = 0;
  Vec anchor, along;
  double length = 0;
  Oscillator oscillator;

  void at(double t, std::span<BodyState> out) const {
    for (std::size_t i = 0; i < start.size(); ++i) out[i] = start[i];
    const Oscillator::State now = oscillator.at(t);
    out[body].position = anchor + (length + now.stretch) * along;
    out[body].velocity = now.speed * along;
    out[body].angle = start[body].angle + t * start[body].angular_velocity;
  }
};

Recognised<SpringMass> recognise_spring(const Scene& scene) {
  if (!scene.joints.empty() || scene.bodies.size() != 1 || scene.forces.size() != 1)
    return "solves one body on one spring";
  const Spring* spring = std::get_if<Spring>(&scene.forces.front());
  const Body& body = scene.bodies.front();
  if (spring == nullptr || spring->a || body.type != BodyType::dynamic) return "solves a spring fixed in the world";
  if (gravity_of(scene, body) != Vec{}) return "solves a spring without gravity";
  if (body.linear_damping != 0 || body.angular_damping != 0) return "knows no damping but the spring's";
  const Mass mass = mass_of(body);
  if (mass.mass <= 0 || length(spring->anchor_b - mass.center) > flat)
    return "solves a spring held at the centre of mass";
  const BodyState start = start_of(body);
  const Vec apart = start.position - spring->anchor_a;
  const double distance = length(apart);
  if (distance == 0) return "solves a spring with a direction";
  const Vec along = (1 / distance) * apart;
  if (std::abs(cross(start.velocity, along)) > flat) return "solves motion along the spring";
  if (spring->damping * spring->damping >= 4 * mass.mass * spring->stiffness) return "solves an underdamped spring";
  const Oscillator oscillator(distance - spring->length, dot(start.velocity, along), mass.mass, spring->stiffness,
                              spring->damping);
  if (oscillator.amplitude() >= spring->length) return "solves a mass that never passes the anchor";
  return SpringMass{{start}, 0, spring->anchor_a, along, spring->length, oscillator};
}

const Catalog<Engine>::Entry spring_entry{
    closed_form<SpringMass>({.name = "spring",
                             .about = "A mass on a spring: e^(-d t) (A cos w t + B sin w t)",
                             .source = "Hooke (1678); Landau & Lifshitz, Mechanics, par. 21 and 25"},
                            recognise_spring)};

}  // namespace
}  // namespace plumb
