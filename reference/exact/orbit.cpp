#include "reference/exact/flight.h"

#include <cmath>
#include <numbers>

#include "reference/exact/closed_form.h"
#include "reference/exact/recognise.h"

namespace plumb {

// Vis viva: v^2 = k (2/r - 1/a).
Orbit::Orbit(Vec position, Vec velocity, double strength)
    : position_(position),
      velocity_(velocity),
      strength_(strength),
      axis_(1 / (2 / length(position) - dot(velocity, velocity) / strength)) {}

double Orbit::period() const { return 2 * std::numbers::pi * std::sqrt(axis_ * axis_ * axis_ / strength_); }

// Kepler's equation from the starting point instead of the perihelion, for the change x of the eccentric anomaly:
//   n t = x - (1 - r0/a) sin x + (r0.v0/sqrt(k a)) (1 - cos x),   n = sqrt(k/a^3),
// Lagrange's f and g then give r = f r0 + g v0 (Battin, ch. 4.3). The derivative of the right-hand side is r/a > 0, so
// Newton's method within a shrinking bracket always converges.
Orbit::State Orbit::at(double t) const {
  const double r0 = length(position_);
  const double n = std::sqrt(strength_ / (axis_ * axis_ * axis_));
  const double m = n * std::remainder(t, period());
  const double ec = 1 - r0 / axis_;
  const double es = dot(position_, velocity_) / std::sqrt(strength_ * axis_);
  double low = m - 2;  // |x - n t| <= 2 e < 2
  double high = m + 2;
  double x = m;
  for (int i = 0; i < 100; ++i) {
    const double value = x - ec * std::sin(x) + es * (1 - std::cos(x)) - m;
    (value < 0 ? low : high) = x;
    const double newton = x - value / (1 - ec * std::cos(x) + es * std::sin(x));
    const double next = newton > low && newton < high ? newton : (low + high) / 2;
    if (next == x) break;
    x = next;
  }
  const double less = 2 * std::sin(x / 2) * std::sin(x / 2);  // 1 - cos x without cancellation
  const double r = axis_ * (1 - ec * std::cos(x) + es * std::sin(x));
  const double f = 1 - axis_ / r0 * less;
  const double g = (r0 * std::sin(x) + axis_ * es * less) / (n * axis_);
  const double df = -std::sqrt(strength_ * axis_) / (r * r0) * std::sin(x);
  const double dg = 1 - axis_ / r * less;
  return {f * position_ + g * velocity_, df * position_ + dg * velocity_};
}

namespace {

struct Planet {
  std::vector<BodyState> start;
  std::size_t body = 0, sun = 0;
  Orbit orbit;

  void at(double t, std::span<BodyState> out) const {
    write_states(start, out);
    const Orbit::State now = orbit.at(t);
    out[body].position = start[sun].position + now.position;
    out[body].velocity = now.velocity;
    out[body].angle = start[body].angle + t * start[body].angular_velocity;
  }
};

Recognised<Planet> recognise_orbit(const Scene& scene) {
  const std::optional<BodyOnGround> pair = single_body_on_ground(scene);
  if (!scene.joints.empty() || !pair || scene.forces.size() != 1)
    return "handles only one body about one fixed attractor";
  const Attraction* pull = std::get_if<Attraction>(&scene.forces.front());
  if (pull == nullptr || pull->from != pair->ground) return "handles only one body about one fixed attractor";
  if (pull->exponent != 2 || pull->strength <= 0) return "handles only attraction with 1/r^2";
  const Body& body = scene.bodies[pair->body];
  if (gravity_of(scene, body) != Vec{}) return "handles only motion without gravity";
  if (body.linear_damping != 0 || body.angular_damping != 0) return "does not support damping";
  if ((body.layers & scene.bodies[pair->ground].layers) != 0) return "handles only bodies that share no layer";
  const std::vector<BodyState> start = start_of(scene);
  const Vec position = start[pair->body].position - start[pair->ground].position;
  const Vec velocity = start[pair->body].velocity;
  if (cross(position, velocity) == 0) return "handles only orbits, not a fall into the centre";
  if (dot(velocity, velocity) / 2 >= pull->strength / length(position)) return "handles only a body that cannot escape";
  return Planet{start, pair->body, pair->ground, Orbit(position, velocity, pull->strength)};
}

const Catalog<Engine>::Entry orbit_entry{
    closed_form<Planet>({.name = "orbit",
                         .about = "A body on an ellipse about a fixed centre: T = 2 pi sqrt(a^3/k)",
                         .source = "Kepler, Newton; Battin, Mathematics and Methods of Astrodynamics, ch. 3 and 4"},
                        recognise_orbit)};

}  // namespace
}  // namespace plumb
