#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "impulse/body.h"
#include "impulse/debug_draw.h"
#include "impulse/force.h"
#include "impulse/joint.h"
#include "impulse/settings.h"

namespace impulse::inline IMPULSE_PRECISION {

/// One point of a touching pair, as the last step left it.
struct ContactInfo {
  BodyId a, b;
  Vec2 point;                // world frame
  Vec2 normal;               // unit, from a to b
  Real separation = 0;       // m, negative when they overlap
  Real normal_impulse = 0;   // N s on b along the normal, sum over the last step
  Real tangent_impulse = 0;  // N s on b along perpendicular(normal), sum over the last step
};

/// Two parts that touched in a step: they overlapped at its start or pushed each other during it.
struct TouchingParts {
  BodyId a, b;
  std::uint16_t part_a = 0, part_b = 0;  // places in Body::parts()
  Vec2 point;                            // world frame, middle of the points in contact
  Vec2 normal;                           // unit, from a to b
  Real normal_impulse = 0;               // N s on b along the normal, of all points, sum over the step
  Real tangent_impulse = 0;              // N s on b along perpendicular(normal), likewise
};

/// What the last step changed, each in order of bodies and parts. The spans hold until the next step.
struct ContactEvents {
  std::span<const TouchingParts> begun;     // did not touch in the step before
  std::span<const TouchingParts> touching;  // all, those that begun among them
  /// Touch no more, as they last did. A body that was destroyed or removed ends its contacts with the next step: ask
  /// contains() before using its handle.
  std::span<const TouchingParts> ended;
};

/// Where a ray enters a part.
struct BodyHit {
  BodyId body;
  std::size_t part = 0;  // place in Body::parts()
  Real fraction = 1;     // of the way from the ray's start to its end
  Vec2 point;            // world frame
  Vec2 normal;           // unit, out of the part, world frame
};

/// The article's Scene: holds the bodies, steps them, answers queries.
///
/// With Settings::sleeping, an island of bodies falls asleep when all of them have rested for a while. An island is
/// what contacts, joints, springs and attractions tie together; fixed and kinematic bodies tie nothing to each other.
/// Bodies asleep cost next to nothing, have no velocity, go on touching what they touch and are found by every query.
/// An island wakes as one, by
///
/// - contact with a body that is awake, or with a kinematic one that moves; likewise a joint, spring or attraction;
/// - a force, torque or impulse that is not zero, and any set_ call, on one of its bodies; Body::wake;
/// - a joint or a force being added or taken away at one of its bodies;
/// - the removal, destruction or shift of what it touches, and whatever immovable is put in its place;
/// - a change of gravity, of solver, of friction mixing or of contacts, and the end of sleeping in the settings.
///
/// Forces that stay (see force.h) keep nothing awake by themselves: a load that hangs on a spring may sleep.
///
/// Bodies may be created, inserted, removed and destroyed at any time; inside a callback the change takes effect when
/// the call that runs the callback returns. Same calls, same bits, on every machine.
class World {
 public:
  explicit World(const Settings& settings = {});
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  const Settings& settings() const;
  /// Throws std::invalid_argument and leaves the world as it was.
  void set_settings(const Settings& settings);
  Vec2 gravity() const { return settings().gravity; }
  void set_gravity(Vec2 gravity);
  Real dt() const { return settings().dt; }
  void set_dt(Real dt);

  /// Makes a body of one or more parts and inserts it. Throws std::invalid_argument for a def that is not finite, for
  /// no parts, or for a dynamic body without mass.
  BodyId create_body(const BodyDef& def, std::span<const Part> parts);
  BodyId create_body(const BodyDef& def, const Shape& shape, const Material& material = {});
  /// Takes a body out of the simulation; it keeps its state and can be inserted again.
  void remove_body(BodyId id);
  void insert_body(BodyId id);
  /// Ends a body; its handles go stale.
  void destroy_body(BodyId id);

  bool contains(BodyId id) const;  // alive, inserted or not
  /// Throws std::out_of_range for a stale handle.
  Body body(BodyId id);
  /// All inserted bodies, in order of their index.
  std::vector<BodyId> bodies() const;
  std::size_t body_count() const;
  /// Of dynamic bodies that the next step will move.
  std::size_t awake_count() const;

  /// Acts from the next step on. Throws std::invalid_argument for numbers that make no sense and std::out_of_range for
  /// a stale body. It ends with remove_force or with any body that it names.
  ForceId add_force(const Force& force);
  /// Throws std::out_of_range for a stale id.
  void remove_force(ForceId id);
  bool contains(ForceId id) const;

  /// Ties two bodies as they stand now. Throws std::invalid_argument for numbers or pairs that make no sense,
  /// std::out_of_range for a stale body. The joint ends with destroy_joint or with either body.
  JointId create_joint(const Joint& joint);
  void destroy_joint(JointId id);
  bool contains(JointId id) const;
  /// N s that the joint gave to body b (and took from a) in the last sub-step, world frame.
  Vec2 joint_impulse(JointId id) const;

  /// Advances by dt(). Throws std::domain_error, and moves nothing, where the solver says that it cannot solve this
  /// world (only `exact` does).
  void step();

  /// Calls back for every part whose bounds overlap the box / that contains the point; return false to stop.
  using QueryCallback = std::function<bool(BodyId, const Part&)>;
  void query_aabb(const Aabb& box, const QueryCallback& callback);
  void query_point(Vec2 point, const QueryCallback& callback);

  /// Calls back for every part that the ray from -> to enters, nearest first; return false to stop. A part that holds
  /// the ray's start is not entered. Throws std::invalid_argument for points that are not finite.
  using RayCallback = std::function<bool(const BodyHit&)>;
  void ray_cast(Vec2 from, Vec2 to, const RayCallback& callback);
  /// The nearest of them on bodies that share a layer with `layers`.
  std::optional<BodyHit> ray_cast(Vec2 from, Vec2 to, std::uint32_t layers = ~std::uint32_t{0}) const;

  std::vector<ContactInfo> contacts() const;
  /// Of the last step. Throws std::logic_error unless Settings::contact_events is on.
  ContactEvents contact_events() const;

  /// Draws the parts whose bounds meet `view` (world frame), the contacts, and a line between the centres of mass of
  /// every two bodies that a joint ties.
  void debug_draw(DebugDraw& draw, const Aabb& view);

 private:
  friend class Body;
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
