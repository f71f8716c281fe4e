#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "reports/judge/invariant.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/vec.h"

namespace plumb {

/// One invariant of the catalog, by name.
inline std::optional<InvariantCheck> checked(const std::string& name, const Scene& scene, const Trace& trace,
                                             const Stepping& stepping) {
  return Catalog<Invariant>::find(name)->check({scene, trace, stepping});
}

inline CheckStatus status(const std::string& name, const Scene& scene, const Trace& trace, const Stepping& stepping) {
  return checked(name, scene, trace, stepping).value().status;
}

/// One moment of a forged trace.
struct Moment {
  std::vector<BodyState> states;
  std::vector<ContactState> contacts = {};
};

inline Trace forged(double dt, const std::vector<Moment>& moments) {
  Trace trace(moments.front().states.size());
  double step = 0;
  for (const Moment& moment : moments) trace.record(dt * step++, moment.states, moment.contacts);
  return trace;
}

/// A box of 1 m, 1 kg and I = 1/6 on ground up to y = 0; no gravity by default.
inline Scene box_on_ground(double friction = 0.5, Vec gravity = {}) {
  const Surface surface{.density = 1, .static_friction = friction, .dynamic_friction = friction};
  return {.name = "box on ground",
          .gravity = gravity,
          .bodies = {{.name = "ground", .type = BodyType::fixed, .shapes = {{HalfSpace{}, surface}}},
                     {.name = "box", .position = {0, 0.5}, .shapes = {{Box{}, surface}}}}};
}

/// The ground and the box of that scene.
inline std::vector<BodyState> box_at(Vec position, Vec velocity = {}) {
  return {{}, {.position = position, .velocity = velocity}};
}

/// The ground's impulse on the box, from straight below.
inline ContactState pushing(double normal, double tangent = 0) {
  return {.a = 0, .b = 1, .normal = {0, 1}, .normal_impulse = normal, .tangent_impulse = tangent};
}

/// A box of 1 kg and I = 1/6 on a hinge through its centre, at 15 m from the origin, where nothing pulls.
inline Scene far_hinge() {
  Scene scene = box_on_ground();
  scene.bodies[0].layers = 0;
  scene.bodies[1].position = {15, 0};
  scene.joints.push_back(Revolute{.a = 0, .b = 1, .anchor = {15, 0}});
  return scene;
}

/// It is at rest, and then turns and moves, rad/s and m/s.
inline Trace sets_off(double dt, double speed) {
  const BodyState then{.position = {15, 0}};
  const BodyState now{.position = {15, 0}, .velocity = {speed, 0}, .angular_velocity = speed};
  return forged(dt, {{{{}, then}}, {{{}, now}}});
}

/// A disc of 1 kg that flies past another one, which goes on at 1 m/s and attracts it, at 2 cm and 8 m/s: 7 m/s^2 where
/// they start, 1250 m/s^2 where they are nearest, for a sixth of a step. And its trace; `felt`: the share of the pull
/// that acts on it.
inline Scene past_an_attraction() {
  const Surface surface{.density = 1};
  const double radius = std::sqrt(1 / std::numbers::pi);
  return {
      .name = "past an attraction",
      .gravity = {},
      .bodies = {{.name = "from", .velocity = {1, 0}, .shapes = {{Circle{radius}, surface}}},
                 {.name = "disc", .position = {-0.5, 0.02}, .velocity = {9, 0}, .shapes = {{Circle{radius}, surface}}}},
      .forces = {Attraction{.from = 0, .strength = 0.5, .exponent = 2}}};
}

inline Trace flown_past(double dt, double felt) {
  constexpr int parts = 4096;
  BodyState from{.velocity = {1, 0}};
  BodyState disc{.position = {-0.5, 0.02}, .velocity = {9, 0}};
  Trace trace(2);
  for (int step = 0; step <= 8; ++step) {
    trace.record(dt * step, std::vector<BodyState>{from, disc}, {});
    for (int part = 0; part < parts; ++part) {
      const double h = dt / parts;
      from.position = from.position + h / 2 * from.velocity;
      disc.position = disc.position + h / 2 * disc.velocity;
      const Vec line = from.position - disc.position;
      disc.velocity = disc.velocity + h * felt * 0.5 / std::pow(length(line), 3) * line;
      from.position = from.position + h / 2 * from.velocity;
      disc.position = disc.position + h / 2 * disc.velocity;
    }
  }
  return trace;
}

}  // namespace plumb
