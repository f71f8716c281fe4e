#pragma once

#include <vector>

#include "../support.h"

/// Helpers for worlds whose bodies may sleep.
namespace impulse::inline IMPULSE_PRECISION {

inline Settings sleeping_allowed(const char* solver = "accurate") {
  Settings settings;
  settings.solver = solver;
  settings.sleeping = true;
  settings.contact_events = true;
  return settings;
}

inline BodyDef kind(BodyType type, BodyDef def) {
  def.type = type;
  return def;
}

inline Shape unit_box() { return Shape::box({Real{0.5}, Real{0.5}}); }

/// A column of boxes on the floor.
inline std::vector<BodyId> add_column(World& world, double x, int height) {
  std::vector<BodyId> boxes;
  boxes.reserve(static_cast<std::size_t>(height));
  for (int i = 0; i < height; ++i) boxes.push_back(world.create_body(at(x, .5 + i), unit_box()));
  return boxes;
}

/// The number of steps after which no body is awake, at most `most`.
inline int steps_to_sleep(World& world, int most = 1200) {
  for (int i = 0; i < most; ++i) {
    if (world.awake_count() == 0) return i;
    world.step();
  }
  return most;
}

inline std::vector<bool> awake(World& world, const std::vector<BodyId>& ids) {
  std::vector<bool> states;
  states.reserve(ids.size());
  for (const BodyId id : ids) states.push_back(world.body(id).awake());
  return states;
}

struct BodyState {
  Vec2 position, velocity;
  Real angle = 0, spin = 0;
  friend bool operator==(const BodyState&, const BodyState&) = default;
};

inline std::vector<BodyState> states(World& world) {
  std::vector<BodyState> all;
  for (const BodyId id : world.bodies()) {
    const Body body = world.body(id);
    all.push_back({body.position(), body.velocity(), body.angle(), body.angular_velocity()});
  }
  return all;
}

}  // namespace impulse::inline IMPULSE_PRECISION
