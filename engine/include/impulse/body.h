#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "impulse/material.h"
#include "impulse/math.h"
#include "impulse/shape.h"

namespace impulse::inline IMPULSE_PRECISION {

class World;
struct BodySet;

enum class BodyType : std::uint8_t { fixed, kinematic, dynamic };

/// A handle to a body. Using a handle after its body was destroyed is detected.
struct BodyId {
  std::uint32_t index = ~std::uint32_t{0};
  std::uint32_t generation = 0;
  friend bool operator==(const BodyId&, const BodyId&) = default;
};

/// What a part is and what it collides with: two parts collide if the category of each shares a bit with the other's
/// mask. A single number of layers is both.
struct Layers {
  std::uint32_t category = ~std::uint32_t{0};
  std::uint32_t mask = ~std::uint32_t{0};

  constexpr Layers() = default;
  constexpr Layers(std::uint32_t layers) : category(layers), mask(layers) {}
  constexpr Layers(std::uint32_t is, std::uint32_t meets) : category(is), mask(meets) {}
  friend constexpr bool operator==(const Layers&, const Layers&) = default;
};
constexpr bool collide(const Layers& a, const Layers& b) {
  return ((a.category & b.mask) != 0) & ((b.category & a.mask) != 0);
}

/// One shape of a body and its material.
struct Part {
  Shape shape;
  Material material;
  std::optional<Layers> layers = {};  // in place of those of the body
  /// A sensor collides with nothing and has no mass. World::sensor_events() reports the parts of other bodies that
  /// overlap it and whose layers collide with its own.
  bool sensor = false;
};

/// The initial state of a body. Position and angle are those of the body's frame, the velocity is that of the centre of
/// mass of all its parts.
struct BodyDef {
  BodyType type = BodyType::dynamic;
  Vec2 position;              // m
  Real angle = 0;             // rad
  Vec2 velocity;              // m/s
  Real angular_velocity = 0;  // rad/s
  Real gravity_scale = 1;
  Real linear_damping = 0;   // 1/s
  Real angular_damping = 0;  // 1/s
  bool fixed_rotation = false;
  bool bullet = false;  // continuous collision against dynamic bodies too
  Layers layers;        // of the parts that have none of their own
  void* user_data = nullptr;
};

/// A lightweight view of a body in a world. Copy it freely, but store a BodyId, not a Body, across steps in which the
/// body may be destroyed. Every call on a view of a destroyed body throws std::out_of_range.
class Body {
 public:
  BodyId id() const { return id_; }
  BodyType type() const;
  Vec2 position() const;  // of the body's frame, m
  Real angle() const;     // rad
  Rotation rotation() const;
  Vec2 center() const;                  // centre of mass, world frame
  Vec2 velocity() const;                // of the centre of mass, m/s
  Real angular_velocity() const;        // rad/s
  MassData mass() const;                // of all parts, body frame; 0 for fixed and kinematic bodies
  std::span<const Part> parts() const;  // shapes relative to the centre of mass
  Layers layers() const;
  /// Of one part: its own, or those of the body. Throws std::out_of_range for an index of no part.
  Layers layers(std::size_t part) const;
  bool awake() const;  // in the world and not asleep
  void* user_data() const;

  /// Wakes the body and its island (see World). If they are awake, restarts their sleep timer.
  void wake();
  /// Puts the body and its island to sleep immediately, even in mid-air, until something wakes them. Does nothing to a
  /// body that is not in the world. Throws std::logic_error if Settings::sleeping is off, std::invalid_argument for a
  /// body that is not dynamic.
  void sleep();

  void set_pose(Vec2 position, Real angle);
  void set_velocity(Vec2 velocity, Real angular_velocity);
  void set_gravity_scale(Real scale);
  void set_layers(Layers layers);
  /// Gives a part layers of its own, or those of the body. Throws std::out_of_range for an index of no part.
  void set_part_layers(std::size_t part, const std::optional<Layers>& layers);

  /// Forces accumulate until the next step, which applies and clears them. N; force and point in the world frame.
  void apply_force(Vec2 force);
  void apply_force(Vec2 force, Vec2 point);
  void apply_torque(Real torque);  // N m
  /// Immediately changes the velocity: v += J/m; w += (r x J)/I. N s; impulse and point in the world frame.
  void apply_impulse(Vec2 impulse, Vec2 point);

 private:
  friend class World;
  Body(World& world, BodyId id) : world_(&world), id_(id) {}
  std::size_t row() const;
  BodySet& bodies() const;
  void disturb();
  World* world_;
  BodyId id_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
