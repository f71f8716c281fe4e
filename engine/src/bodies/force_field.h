#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "bodies/body_set.h"
#include "impulse/force.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Everything that accelerates bodies other than contacts and joints: gravity, collected forces, generators, damping.
class ForceField {
 public:
  Vec2 gravity;

  /// Acceleration of every row at the bodies' present poses and velocities: v in m/s^2, w in rad/s^2. Rows with inverse
  /// mass 0 get 0. `out` is resized to the bodies.
  ///
  /// Damping is -d v at the velocity after `implicit` seconds: v' = v + h (a - d v') is v' = v + h (a - d v)/(1 + h d),
  /// which no damping makes unstable, and whose speed of fall in air, a/d, is exact; but it is of first order in h, so
  /// a method of higher order passes 0 and gets -d v itself. The damping of springs is always taken at the present
  /// velocity.
  void accelerations(const BodySet& bodies, Real implicit, std::vector<Velocity>& out) const;

  /// Whether accelerations depend on where bodies are or how fast they go.
  bool vary(const BodySet& bodies) const;

  /// Throws std::invalid_argument for numbers that make no sense and std::out_of_range for bodies that are not there.
  ForceId add(const Force& force, const BodySet& bodies);
  bool contains(ForceId id) const;
  /// The rows of the bodies that it acts on or comes from. Throws std::out_of_range for a stale id.
  std::vector<std::uint32_t> bodies_of(ForceId id, const BodySet& bodies) const;
  /// Appends the pairs of rows of which one feels where the other is.
  void append_ties(const BodySet& bodies, std::vector<std::pair<std::uint32_t, std::uint32_t>>& out) const;
  /// Throws std::out_of_range for a stale id.
  void remove(ForceId id);
  /// Ends every generator that names the body.
  void forget(BodyId body);

 private:
  struct Slot {
    std::uint32_t generation = 0;
    std::optional<Force> force;
  };
  void need(ForceId id) const;
  void end(std::size_t slot);

  std::vector<Slot> slots_;
  std::vector<std::uint32_t> free_slots_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
