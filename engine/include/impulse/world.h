#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "impulse/body.h"
#include "impulse/contact.h"
#include "impulse/debug_draw.h"
#include "impulse/force.h"
#include "impulse/joint.h"
#include "impulse/settings.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Where a ray enters a body's part, or a moved shape first touches it.
struct BodyHit {
  BodyId body;
  std::size_t part = 0;  // index into Body::parts()
  Real fraction = 1;     // of the way from start to end
  Vec2 point;            // world frame
  Vec2 normal;           // unit, out of the part, world frame
};

/// The article's Scene: holds the bodies, steps them, answers queries.
///
/// With Settings::sleeping, an island of bodies falls asleep when all of them have been at rest for a while. Contacts,
/// joints, springs and attractions connect bodies into islands; fixed and kinematic bodies connect nothing. Sleeping
/// bodies cost almost nothing, have no velocity, keep their contacts and are found by every query.
/// The whole island wakes when one of its bodies
///
/// - comes into contact with an awake body or a moving kinematic one, or is connected to one by a joint, spring or
///   attraction;
/// - receives a force, torque or impulse that is not zero, any set_ call, or Body::wake;
/// - gains or loses a joint or a force;
/// - touched something that was removed, destroyed or moved, or is where a fixed or kinematic body is placed.
///
/// All islands wake when gravity, solver, friction mixing or Settings::contacts change, and when sleeping is turned
/// off.
///
/// Persistent forces (see force.h) don't keep a body awake: a load hanging on a spring may sleep.
///
/// Bodies may be created, inserted, removed and destroyed at any time; inside a callback the change takes effect when
/// the call that runs the callback returns. The filter and the pre-solve callback may read the world but not change it:
/// that throws std::logic_error. Both are called on the thread that calls step(), in the order of bodies and parts. The
/// same calls give the same bits on every machine and with any number of workers, and reading the world changes none.
class World {
 public:
  explicit World(const Settings& settings = {});
  ~World();
  /// A copy has the same bodies, joints and forces with the same handles, and both go on with the same bits: keep a
  /// copy to roll back to, `World saved = world; ... world = saved;`. Callbacks are copied, user_data is shared. Throws
  /// std::logic_error in a callback of `other`.
  World(const World& other);
  World& operator=(const World& other);
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  const Settings& settings() const;
  /// Throws std::invalid_argument for invalid settings and leaves the world unchanged.
  void set_settings(const Settings& settings);
  Vec2 gravity() const { return settings().gravity; }
  void set_gravity(Vec2 gravity);
  Real dt() const { return settings().dt; }
  void set_dt(Real dt);

  /// Creates a body from one or more parts and inserts it. Throws std::invalid_argument if the def is not finite, if
  /// there are no parts, or if a dynamic body has no mass.
  BodyId create_body(const BodyDef& def, std::span<const Part> parts);
  BodyId create_body(const BodyDef& def, const Shape& shape, const Material& material = {});
  /// Takes a body out of the simulation. It keeps its state and can be inserted again.
  void remove_body(BodyId id);
  void insert_body(BodyId id);
  /// Destroys a body; its handles become stale.
  void destroy_body(BodyId id);

  bool contains(BodyId id) const;  // not destroyed; inserted or not
  /// Throws std::out_of_range for a stale handle.
  Body body(BodyId id);
  /// All inserted bodies, sorted by index. The span is valid until the next call.
  std::span<const BodyId> bodies() const;
  std::size_t body_count() const;
  /// The number of dynamic bodies that the next step will move.
  std::size_t awake_count() const;

  /// The force acts from the next step until remove_force or until a body it refers to is destroyed. Throws
  /// std::invalid_argument for invalid values and std::out_of_range for a stale body.
  ForceId add_force(const Force& force);
  /// Throws std::out_of_range for a stale id.
  void remove_force(ForceId id);
  bool contains(ForceId id) const;

  /// Connects two bodies at their current poses, until destroy_joint or until either body is destroyed. Throws
  /// std::invalid_argument for invalid values or pairs, std::out_of_range for a stale body.
  JointId create_joint(const Joint& joint);
  void destroy_joint(JointId id);
  bool contains(JointId id) const;
  /// Change the motor or the limits of a revolute or prismatic joint, or remove them, and wake its bodies. Throw
  /// std::invalid_argument for invalid values and other joints, std::out_of_range for a stale id.
  void set_motor(JointId id, const std::optional<Motor>& motor);
  void set_limits(JointId id, const std::optional<Limits>& limits);
  /// The impulse (N s, world frame) on body b in the last sub-step; body a received the opposite.
  Vec2 joint_impulse(JointId id) const;

  /// Advances by dt(). Throws std::domain_error and moves nothing if the solver cannot solve this world (only `exact`
  /// ever does).
  void step();

  /// Calls back for every part whose bounds overlap the box, or that contains the point, sensors included. Return false
  /// to stop.
  using QueryCallback = std::function<bool(BodyId, const Part&)>;
  void query_aabb(const Aabb& box, const QueryCallback& callback);
  void query_point(Vec2 point, const QueryCallback& callback);

  /// Calls back for every part that the ray from -> to enters, nearest first. Return false to stop. Sensors and
  /// parts that contain the ray's start are skipped. Throws std::invalid_argument for points that are not finite.
  using RayCallback = std::function<bool(const BodyHit&)>;
  void ray_cast(Vec2 from, Vec2 to, const RayCallback& callback);
  /// The nearest hit on parts whose category shares a bit with `layers`.
  std::optional<BodyHit> ray_cast(Vec2 from, Vec2 to, std::uint32_t layers = ~std::uint32_t{0}) const;

  /// The first part whose category shares a bit with `layers`, sensors apart, that the shape at `start` touches when it
  /// moves by `by` without rotating. One that it overlaps at the start is a hit with fraction 0, normal 0 and the start
  /// as its point. Short of contact by rounding only. Throws std::invalid_argument for a half-space and for values that
  /// are not finite.
  std::optional<BodyHit> shape_cast(const Shape& shape, const Pose& start, Vec2 by,
                                    std::uint32_t layers = ~std::uint32_t{0}) const;

  /// The contact points of the last step, sorted by bodies and parts. The span is valid until the next step or call.
  std::span<const ContactInfo> contacts() const;
  /// The events of the last step. Throws std::logic_error unless Settings::contact_events is on.
  ContactEvents contact_events() const;
  /// What sensors saw at the end of the last step.
  SensorEvents sensor_events() const;

  /// step() asks the filter whether two parts whose layers collide do so. It wakes all bodies; an empty function lets
  /// all collide. A filter that lets all collide changes no bit.
  void set_filter(PartFilter filter);
  /// step() calls this for each contact of bodies that are awake, before it solves them: all that touch or may touch
  /// within the step. Throws std::invalid_argument, and moves nothing, if it sets coefficients out of their ranges. An
  /// empty function ends it. Large piles at rest cost more with one.
  void set_pre_solve(PreSolve pre_solve);

  /// Draws the parts whose bounds overlap `view` (world frame), the contacts, and for each joint a line between the
  /// centres of mass of its two bodies.
  void debug_draw(DebugDraw& draw, const Aabb& view);

 private:
  friend class Body;
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
