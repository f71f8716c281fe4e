#pragma once

#include <cmath>
#include <random>

#include "../support.h"

/// Worlds for the tests of solvers.
namespace impulse::inline IMPULSE_PRECISION {

constexpr double g = 10;  // m/s^2, the default

/// The bound for the precision that this is compiled for.
constexpr double bound(double in_double, double in_float) {
  return sizeof(Real) == sizeof(double) ? in_double : in_float;
}

inline Settings accurate() {
  Settings settings;
  settings.solver = "accurate";
  return settings;
}

inline Material material(double restitution, double friction = 0) {
  return {1, real(friction), real(friction), real(restitution)};
}

inline Vec2 vec(double x, double y) { return {real(x), real(y)}; }

inline BodyDef tilted(double x, double y, double angle) { return at(x, y, 0, 0, 0, angle); }

inline BodyId ground(World& world, const Material& m, double angle = 0) {
  BodyDef def = tilted(0, 0, angle);
  def.type = BodyType::fixed;
  return world.create_body(def, Shape::half_space({0, 1}, 0), m);
}

inline void run_for(World& world, double seconds) { run(world, static_cast<int>(std::lround(seconds * 60))); }

inline double energy(World& world) {
  double sum = 0;
  for (const BodyId id : world.bodies()) {
    const Body body = world.body(id);
    const MassData mass = body.mass();
    const double v2 = static_cast<double>(length_squared(body.velocity()));
    const double w = static_cast<double>(body.angular_velocity());
    sum += static_cast<double>(mass.mass) * (v2 / 2 + static_cast<double>(-dot(world.gravity(), body.center()))) +
           static_cast<double>(mass.inertia) * w * w / 2;
  }
  return sum;
}

/// Between low and high, the same with every standard library.
inline double seeded(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
}

}  // namespace impulse::inline IMPULSE_PRECISION
