#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reports/judge/invariant.h"
#include "scenarios/catalog.h"

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

}  // namespace plumb
