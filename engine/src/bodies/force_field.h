#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "bodies/body_set.h"
#include "impulse/force.h"

namespace impulse::inline IMPULSE_PRECISION {

/// A force on particular bodies: its slot in the field, and the row of one that it can move.
struct Pull {
  std::uint32_t slot = 0;
  std::uint32_t body = 0;
};

/// Everything that accelerates bodies except contacts and joints: gravity, accumulated forces, persistent forces (see
/// impulse/force.h), damping.
class ForceField {
 public:
  Vec2 gravity;

  /// The acceleration of every row at the bodies' current poses and velocities: v in m/s^2, w in rad/s^2. Rows with
  /// inverse mass 0 get 0. Resizes `out` to the number of bodies.
  ///
  /// Damping is -d v at the velocity after `implicit` seconds: v' = v + h (a - d v') is v' = v + h (a - d v)/(1 + h d).
  /// That is stable for any damping, and the terminal velocity a/d is exact, but it is of first order in h. A method of
  /// higher order passes 0 and gets -d v at the current velocity; over the next `reach` seconds that at most stops the
  /// body. Springs use the current velocity for their damping.
  void accelerations(const BodySet& bodies, Real implicit, std::vector<Velocity>& out, Real reach = 0) const;
  /// The same of some rows alone, given all pulls on them. Springs damp the velocities `later`: a method of second
  /// order passes those of the time at which the acceleration counts. Damping is of `held`, the velocities then by all
  /// but forces.
  void accelerations(const BodySet& bodies, std::span<const std::uint32_t> rows, std::span<const Pull> pulls,
                     Real implicit, const std::vector<Velocity>& held, const std::vector<Velocity>& later,
                     std::vector<Velocity>& out) const;

  /// 1/s, how fast bodies of these rows pass what attracts them within `time` s: their speed, or that of circles, over
  /// their distance where they are nearest, if they go straight on. Meanwhile a force turns and changes by as much as
  /// itself. 0 for forces that are linear in places, or too weak to be felt.
  Real passing_rate(const BodySet& bodies, std::span<const std::uint32_t> rows, Real time) const;

  bool empty() const { return slots_.size() == free_slots_.size(); }
  /// Whether accelerations depend on positions or velocities.
  bool vary(const BodySet& bodies) const;
  /// The same of each row.
  void find_varying(const BodySet& bodies, std::vector<std::uint8_t>& out) const;
  /// Lists the forces on one body or between two, in their own order.
  void list_pulls(const BodySet& bodies, std::vector<Pull>& out) const;

  /// Throws std::invalid_argument for invalid values and std::out_of_range for bodies that don't exist.
  ForceId add(const Force& force, const BodySet& bodies);
  bool contains(ForceId id) const;
  /// The rows of the bodies that the force acts on or comes from. Throws std::out_of_range for a stale id.
  std::vector<std::uint32_t> bodies_of(ForceId id, const BodySet& bodies) const;
  /// Appends the rows of the bodies that springs pull.
  void append_sprung(const BodySet& bodies, std::vector<std::uint32_t>& rows) const;
  /// Appends the pairs of rows of which one body's acceleration depends on the other's position, or would if they were
  /// nearer by `margin` m.
  void append_pairs(const BodySet& bodies, std::vector<std::pair<std::uint32_t, std::uint32_t>>& out,
                    Real margin = 0) const;
  /// Whether some attraction accelerates the body of a row.
  bool attracts(const BodySet& bodies, std::size_t row) const;
  /// Throws std::out_of_range for a stale id.
  void remove(ForceId id);
  /// Removes every force that refers to the body.
  void forget(BodyId body);

 private:
  struct Slot {
    std::uint32_t generation = 0;
    std::optional<Force> force;
  };
  void require(ForceId id) const;
  void attract(const BodySet& bodies, std::size_t row, std::vector<Velocity>& out) const;
  void free_slot(std::size_t slot);

  std::vector<Slot> slots_;
  std::vector<std::uint32_t> free_slots_;
  std::vector<std::uint32_t> attractions_;  // slots, in order
};

}  // namespace impulse::inline IMPULSE_PRECISION
