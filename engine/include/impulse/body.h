#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "impulse/material.h"
#include "impulse/math.h"
#include "impulse/shape.h"

namespace impulse::inline IMPULSE_PRECISION {

class World;
struct BodySet;

enum class BodyType : std::uint8_t { fixed, kinematic, dynamic };

/// Names a body for as long as it lives; a handle whose body is gone is detected, never followed.
struct BodyId {
  std::uint32_t index = ~std::uint32_t{0};
  std::uint32_t generation = 0;
  friend bool operator==(const BodyId&, const BodyId&) = default;
};

/// One shape of a body and what it is made of.
struct Part {
  Shape shape;
  Material material;
};

/// How a body starts. Positions and angles are of the body's own frame; the velocity is of the centre of mass.
struct BodyDef {
  BodyType type = BodyType::dynamic;
  Vec2 position;
  Real angle = 0;
  Vec2 velocity;
  Real angular_velocity = 0;
  Real gravity_scale = 1;
  Real linear_damping = 0;   // 1/s
  Real angular_damping = 0;  // 1/s
  bool fixed_rotation = false;
  bool bullet = false;  // continuous collision against moving bodies too
  std::uint32_t layers = ~std::uint32_t{0};
  void* user_data = nullptr;
};

/// A light view of a body in a world: copy it, don't keep it across steps in which the body may die (keep the BodyId).
/// Every call on a view of a dead body throws std::out_of_range.
class Body {
 public:
  BodyId id() const { return id_; }
  BodyType type() const;
  Vec2 position() const;  // of the body's frame
  Real angle() const;
  Rotation rotation() const;
  Vec2 center() const;                  // of mass, world frame
  Vec2 velocity() const;                // of the centre of mass, m/s
  Real angular_velocity() const;        // rad/s
  MassData mass() const;                // of all parts, body frame; 0 where immovable
  std::span<const Part> parts() const;  // shapes relative to the centre of mass
  std::uint32_t layers() const;
  bool awake() const;  // in the world, and not asleep
  void* user_data() const;

  /// Wakes the body and its island (see World); if they are awake, their time to fall asleep starts over.
  void wake();
  /// Puts the body and its island to sleep at once, even in mid-air, until something wakes them. Throws
  /// std::logic_error where Settings::sleeping is off and std::invalid_argument for a body that is not dynamic. A body
  /// out of the world stays as it is.
  void sleep();

  void set_pose(Vec2 position, Real angle);
  void set_velocity(Vec2 velocity, Real angular_velocity);
  void set_gravity_scale(Real scale);
  void set_layers(std::uint32_t mask);

  /// Forces are summed until the next step uses and clears them. N, world frame; points in the world.
  void apply_force(Vec2 force);
  void apply_force(Vec2 force, Vec2 point);
  void apply_torque(Real torque);
  /// v += J/m; w += (r x J)/I, at once. N s, world frame; point in the world.
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
