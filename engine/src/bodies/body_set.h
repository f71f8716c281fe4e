#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "impulse/body.h"

namespace impulse::inline IMPULSE_PRECISION {

struct Velocity {
  Vec2 v;           // of the centre of mass, m/s
  Real w = 0;       // rad/s
  Real unused = 0;  // pads to four numbers for lanes
};

struct InverseMass {
  Real m = 0;  // 1/kg
  Real i = 0;  // 1/(kg m^2)
};

/// Whether impulses change the body's velocity.
inline bool pushable(const InverseMass& mass) { return mass.m + mass.i > 0; }

/// How a body responds to gravity and damping.
struct Response {
  Real gravity_scale = 1;
  Real linear_damping = 0;   // 1/s
  Real angular_damping = 0;  // 1/s
};

/// Data that a step rarely touches.
struct BodyDetail {
  bool alive = false;
  bool inserted = false;
  BodyDef def;               // as created, except for the layers, which are current
  MassData mass;             // body frame; 0 for fixed and kinematic bodies
  Velocity stored_velocity;  // of a removed body, for when it is inserted again
  std::vector<Part> parts;   // shapes relative to the centre of mass

  Layers layers_of(const Part& part) const { return part.layers.value_or(def.layers); }
};

/// The bodies as a structure of arrays: row i of each array belongs to one body. Rows of destroyed, removed or sleeping
/// bodies have inverse mass 0 and velocity 0, so that loops over all rows need no branch and solvers treat a sleeping
/// body as a fixed one. The pose is that of the centre of mass.
struct BodySet {
  std::vector<Pose> pose;
  std::vector<Real> angle;      // rad, the pose's rotation without wrap-around
  std::vector<Vec2> remainder;  // m, part of the position below the pose's precision; kept by some solvers
  std::vector<Velocity> velocity;
  std::vector<InverseMass> inverse_mass;
  std::vector<Response> response;
  std::vector<Vec2> force;            // N, accumulated until the next step
  std::vector<Real> torque;           // N m
  std::vector<Real> bounding_radius;  // m, about the centre of mass; ignores half-spaces and sensors
  std::vector<Real> thickness;        // m, of its thinnest solid part: the least distance between two parallel tangents
  std::vector<std::uint8_t> held;  // 1 if a contact or joint acted on it in the last step, see Integrator::needs_held
  std::vector<std::uint8_t> asleep;
  std::vector<std::uint32_t> pile;        // number of the resting pile that keeps its contacts, or 0: resting_piles.h
  std::vector<std::uint32_t> generation;  // of the row's body, or of the next one if the row is free
  std::vector<BodyDetail> detail;
  std::vector<std::uint32_t> free_rows;  // the last freed is reused first
  std::size_t sleepers = 0;              // number of sleeping bodies
  std::uint64_t sleep_changes = 0;       // counts bodies that fell asleep or woke
  std::uint64_t part_changes = 0;        // counts bodies that were inserted or removed or changed layers
  std::uint64_t pile_changes = 0;        // counts piles that came to rest or were invalidated

  std::size_t size() const { return pose.size(); }

  /// Creates a body in a free row without inserting it. Throws std::invalid_argument like World::create_body.
  BodyId add(const BodyDef& def, std::span<const Part> parts);
  void insert(std::size_t i);
  void remove(std::size_t i);
  void destroy(std::size_t i);
  /// Requires a dynamic body that is inserted and awake; sets its velocity to 0.
  void put_to_sleep(std::size_t i);
  /// Requires a sleeping body. A body must be awake when it is removed.
  void wake(std::size_t i);

  void set_layers(std::size_t i, Layers layers);
  void set_part_layers(std::size_t i, std::size_t part, const std::optional<Layers>& layers);

  bool contains(BodyId id) const {
    return id.index < size() && detail[id.index].alive && generation[id.index] == id.generation;
  }
  /// The velocity of a body, inserted or not.
  Velocity& velocity_of(std::size_t i) { return detail[i].inserted ? velocity[i] : detail[i].stored_velocity; }
  BodyId id(std::size_t i) const { return {static_cast<std::uint32_t>(i), generation[i]}; }

  bool dynamic(std::size_t i) const { return detail[i].def.type == BodyType::dynamic; }
  /// Whether impulses change its velocity: an awake dynamic body.
  bool pushable(std::size_t i) const { return impulse::pushable(inverse_mass[i]); }
  /// Whether a step may move it: an awake dynamic body or a moving kinematic one.
  bool moves(std::size_t i) const { return pushable(i) || velocity[i].v != Vec2{} || velocity[i].w != 0; }

  /// Moves row i for h seconds at its velocity.
  void advance(std::size_t i, Real h) { advance(i, velocity[i], h); }
  /// Moves row i for h seconds at the given velocity.
  void advance(std::size_t i, const Velocity& at, Real h);

  void clear_forces();
};

/// Mass, centre and inertia of several shapes as one body. Sensors have none.
MassData total_mass(std::span<const Part> parts);

}  // namespace impulse::inline IMPULSE_PRECISION
