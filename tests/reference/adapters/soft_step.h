#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenes.h"

/// What theory says of the engines that split a step into four sub-steps and find impacts once a step.
namespace plumb::adapter_tests {

constexpr double soft_step_dt = 1.0 / 60;  // s

/// A disc on an undamped spring, k = w dt, V = v dt, x' = x + V - c k^2 y, V' = V - k^2 y, y = x + a V, c = (1 +
/// 1/n)/2, a = 1 - c, keeps k^2 x^2 + k^2/n x V + (1 - c a k^2) V^2: from rest at x0 it reaches x0/sqrt(1 - k^2/(4 n^2
/// (1 - c a k^2))), and no more.
inline void expect_bounded_spring(const Engine& engine) {
  constexpr double n = 4, k = 1.5, c = (1 + 1 / n) / 2, x0 = 0.1;
  Scene scene = scene_of({body_of(BodyType::dynamic, {1 + x0, 0}, Circle{0.5, {}})});
  scene.name = "spring";
  scene.gravity = {};
  scene.duration = 40;
  const double mass = std::acos(-1.0) / 4;
  scene.forces.push_back(Spring{.b = 0, .stiffness = mass * std::pow(k / soft_step_dt, 2), .length = 1});
  const auto simulation = engine.build(scene, {});
  std::vector<BodyState> states(1);
  double farthest = 0;
  for (int i = 0; i < 2000; ++i) {
    simulation->step(soft_step_dt);
    simulation->read(states);
    farthest = std::max(farthest, std::abs(states[0].position.x - 1));
  }
  const double reached = x0 / std::sqrt(1 - k * k / (4 * n * n * (1 - c * (1 - c) * k * k)));
  EXPECT_NEAR(farthest, reached, reached / 100);
  EXPECT_EQ(engine.stepping({}, soft_step_dt).spring_limit, 2);
}

/// Discs that collide at 4 m/s, at eight phases of a step: they part as late as if they had met late, each twice as far
/// off as it came. They are found up to a step late, and bounce at the end of the next.
inline void expect_impacts_within_the_stated_lag(const Engine& engine) {
  constexpr double speed = 4;  // m/s
  double latest = 0;           // s
  for (int phase = 0; phase < 8; ++phase) {
    const double gap = 0.3 + speed * soft_step_dt * phase / 8;
    Scene scene = scene_of({body_of(BodyType::dynamic, {0, 0}, Circle{0.5, {}}, 1),
                            body_of(BodyType::dynamic, {1 + gap, 0}, Circle{0.5, {}}, 1)});
    scene.name = "impact";
    scene.gravity = {};
    scene.duration = 1;
    scene.bodies[0].name = "left";
    scene.bodies[0].velocity = {speed, 0};
    const auto simulation = engine.build(scene, {});
    for (int i = 0; i < 30; ++i) simulation->step(soft_step_dt);
    std::vector<BodyState> states(2);
    simulation->read(states);
    const double apart = states[1].position.x - states[0].position.x - 1;
    const double late = (speed * 30 * soft_step_dt - gap - apart) / (2 * speed);
    EXPECT_GE(late, -1e-6);
    latest = std::max(latest, late);
  }
  const Stepping stated = engine.stepping({}, soft_step_dt);
  EXPECT_GT(latest, soft_step_dt);
  EXPECT_LE(latest, stated.impact_lag * stated.h);
}

/// A disc that slips on the ground as it bounces loses mu v of its speed along it, v being that at which it falls: the
/// impulse of restitution, e m v, comes after the last sub-step, without friction. Coulomb's law has mu (1 + e) v.
inline void expect_no_friction_of_restitution(const Engine& engine) {
  constexpr double mu = 0.1, e = 0.6, v = 4;  // m/s
  Scene scene =
      scene_of({body_of(BodyType::fixed, {}, HalfSpace{}, e), body_of(BodyType::dynamic, {0, 1}, Circle{0.5, {}}, e)});
  scene.name = "bounce";
  scene.gravity = {};
  scene.duration = 1;
  scene.bodies[0].name = "ground";
  for (Body& body : scene.bodies) body.shapes[0].surface.static_friction = body.shapes[0].surface.dynamic_friction = mu;
  scene.bodies[1].velocity = {v, -v};
  const BodyState after = last_state(engine, scene, {}, 30);
  EXPECT_NEAR(after.velocity.y, e * v, e * v / 100);
  EXPECT_NEAR(v - after.velocity.x, mu * v, mu * v / 100);
}

}  // namespace plumb::adapter_tests
