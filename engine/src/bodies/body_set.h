#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contacts/contact.h"
#include "impulse/body.h"
#include "impulse/world.h"

namespace impulse::inline IMPULSE_PRECISION {

struct Velocity {
  Vec2 v;           // of the centre of mass, m/s
  Real w = 0;       // rad/s
  Real unused = 0;  // four lanes
};

struct InverseMass {
  Real m = 0;  // 1/kg
  Real i = 0;  // 1/(kg m^2)
};

/// How a body answers to gravity and to the air.
struct Response {
  Real gravity_scale = 1;
  Real linear_damping = 0;   // 1/s
  Real angular_damping = 0;  // 1/s
};

/// What a step seldom touches.
struct BodyDetail {
  bool alive = false;
  bool inserted = false;
  BodyDef def;              // as it was created, but for the layers, which are as they are now
  MassData mass;            // body frame; 0 where immovable
  Velocity removed_with;    // the velocity that a removed body will be inserted with
  std::vector<Part> parts;  // shapes relative to the centre of mass
};

struct ActiveJoint;

/// The bodies as columns: row i of each is one body. Rows of dead or removed bodies have inverse mass 0 and velocity 0,
/// so that loops over all rows need no branch; so have those asleep, which are to solvers what a fixed body is. The
/// pose is that of the centre of mass.
struct BodySet {
  std::vector<Pose> pose;
  std::vector<Real> angle;      // the pose's rotation as a number that winds up
  std::vector<Vec2> remainder;  // m, of the position, too small for the pose to hold; for solvers that keep it
  std::vector<Velocity> velocity;
  std::vector<InverseMass> inverse_mass;
  std::vector<Response> response;
  std::vector<Vec2> force;         // N, collected until the next step
  std::vector<Real> torque;        // N m
  std::vector<Real> reach;         // m, of the farthest point of its shapes from the centre of mass; half-spaces aside
  std::vector<Real> thickness;     // m, the least distance between two parallel lines that hold its thinnest part
  std::vector<std::uint8_t> held;  // 1 if a contact or joint pushed it in the last step; for integrators that ask
  std::vector<std::uint8_t> asleep;
  std::vector<std::uint32_t> pile;        // 0, or which pile at rest keeps its contacts (solvers/resting_piles.h)
  std::vector<std::uint32_t> generation;  // of the body in the row, or of the next one
  std::vector<BodyDetail> detail;
  std::vector<std::uint32_t> free_rows;  // the last freed is reused first
  std::size_t sleepers = 0;              // how many are asleep
  std::uint64_t sleep_changes = 0;       // how often one fell asleep or woke
  std::uint64_t part_changes = 0;        // how often one came or went, or changed its layers
  std::uint64_t pile_changes = 0;        // how often a pile came to rest or was let go

  std::size_t size() const { return pose.size(); }

  /// Makes a body in a free row, not inserted yet. Throws std::invalid_argument as World::create_body does.
  BodyId add(const BodyDef& def, std::span<const Part> parts);
  void insert(std::size_t i);
  void remove(std::size_t i);
  void destroy(std::size_t i);
  /// Of a dynamic body that is inserted and awake; it loses its velocity.
  void put_to_sleep(std::size_t i);
  /// Of a body asleep; it must be awake before it is removed.
  void wake(std::size_t i);

  void set_layers(std::size_t i, std::uint32_t mask);

  bool contains(BodyId id) const {
    return id.index < size() && detail[id.index].alive && generation[id.index] == id.generation;
  }
  /// The velocity of a body, inserted or not.
  Velocity& motion(std::size_t i) { return detail[i].inserted ? velocity[i] : detail[i].removed_with; }
  BodyId id(std::size_t i) const { return {static_cast<std::uint32_t>(i), generation[i]}; }

  bool dynamic(std::size_t i) const { return detail[i].def.type == BodyType::dynamic; }
  /// Whether something can push it: an awake dynamic body.
  bool pushable(std::size_t i) const { return inverse_mass[i].m + inverse_mass[i].i > 0; }
  /// Whether a step may move it: an awake dynamic body, or a kinematic one on its way.
  bool stirs(std::size_t i) const {
    return inverse_mass[i].m + inverse_mass[i].i > 0 || velocity[i].v != Vec2{} || velocity[i].w != 0;
  }

  /// Moves row i by h seconds at its velocity.
  void advance(std::size_t i, Real h) { advance(i, velocity[i], h); }
  /// Moves row i by h seconds at a velocity other than its own.
  void advance(std::size_t i, const Velocity& at, Real h);

  void mark_held(std::span<const Contact> contacts, std::span<const ActiveJoint> joints);
  void clear_forces();
};

/// Mass, centre and inertia of several shapes as one body.
MassData total_mass(std::span<const Part> parts);

}  // namespace impulse::inline IMPULSE_PRECISION
