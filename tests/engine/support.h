#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "impulse/impulse.h"

/// Worlds and helpers for the engine's tests.
namespace impulse::inline IMPULSE_PRECISION {

/// Half the distance between 1 and the next number up: the largest relative error of one operation.
constexpr Real round_off = std::numeric_limits<Real>::epsilon() / 2;

inline Real real(double x) { return static_cast<Real>(x); }

inline Settings weightless(double dt = 1.0 / 60) {
  Settings settings;
  settings.solver = "article";  // takes one integrator step per world step, which keeps closed forms short
  settings.gravity = {};
  settings.dt = real(dt);
  return settings;
}

/// Of the default method, with gravity in m/s^2.
inline Settings falling(double gravity = 10) {
  Settings settings;
  settings.gravity = {0, real(-gravity)};
  return settings;
}

inline Material frictionless(double restitution = 0) { return {1, 0, 0, real(restitution)}; }

inline BodyDef at(double x, double y, double vx = 0, double vy = 0, double w = 0, double angle = 0) {
  BodyDef def;
  def.position = {real(x), real(y)};
  def.velocity = {real(vx), real(vy)};
  def.angular_velocity = real(w);
  def.angle = real(angle);
  return def;
}

inline BodyId add_floor(World& world, const Material& material = {}) {
  BodyDef def;
  def.type = BodyType::fixed;
  return world.create_body(def, Shape::half_space({0, 1}, 0), material);
}

inline void run(World& world, int steps) {
  for (int i = 0; i < steps; ++i) world.step();
}

/// A disc on a spring of rest length 0 to the origin, with an angular frequency of 1 rad/s.
struct Oscillator {
  World world;
  BodyId body;

  Oscillator(const char* integrator, double dt, double damping = 0) : world(settings(integrator, dt)) {
    BodyDef def = at(1, 0);
    def.linear_damping = real(damping);
    body = world.create_body(def, Shape::circle(Real{0.5}));
    world.add_force(Spring{{}, body, {}, {}, world.body(body).mass().mass, 0, 0});
  }

  static Settings settings(const char* integrator, double dt) {
    Settings chosen = weightless(dt);
    chosen.integrator = integrator;
    return chosen;
  }

  Real x() { return world.body(body).position().x; }
  Real v() { return world.body(body).velocity().x; }
  Real energy() { return (x() * x() + v() * v()) / 2; }
};

/// log2 of the factor by which the error of the state (x, v) at time 2 shrinks when the step is halved.
inline double order_of_convergence(const char* integrator, int steps, double damping = 0) {
  const double half = damping / 2;
  const double frequency = std::sqrt(1 - half * half);
  const double decay = std::exp(-half * 2);
  const double x = decay * (std::cos(frequency * 2) + half / frequency * std::sin(frequency * 2));
  const double v = -decay / frequency * std::sin(frequency * 2);
  const auto error = [&](int n) {
    Oscillator oscillator(integrator, 2.0 / n, damping);
    run(oscillator.world, n);
    return std::hypot(static_cast<double>(oscillator.x()) - x, static_cast<double>(oscillator.v()) - v);
  };
  return std::log2(error(steps) / error(2 * steps));
}

/// m, how far a body falls short of g t^2/2 in 1 s at 10 m/s^2 with steps of 1/64 s, which is exact in binary.
inline double fall_error(const char* integrator) {
  Settings settings;
  settings.solver = "article";
  settings.dt = 1 / Real{64};
  settings.integrator = integrator;
  World world(settings);
  const BodyId body = world.create_body(at(0, 0), Shape::circle(1));
  run(world, 64);
  return static_cast<double>(world.body(body).position().y) + 5;
}

}  // namespace impulse::inline IMPULSE_PRECISION
