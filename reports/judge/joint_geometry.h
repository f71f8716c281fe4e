#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/scene/joints.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/scene.h"

/// The geometry of a scene's joints, from the scene and the states alone, by code that no engine shares.
namespace plumb {

/// One direction in which a joint may give an impulse: `direction` at an arm from the centre of b, its opposite at an
/// arm from the centre of a; or, with no direction, a turning impulse. With J this row, J^T lambda acts on the bodies.
struct JointRow {
  std::size_t a = 0, b = 0;
  Vec direction;                  // unit length, or zero
  double turn_a = 0, turn_b = 0;  // m or 1: the angular part on a and on b
  /// The joint whose limits alone give it: the lower one a positive impulse, the upper one a negative.
  std::optional<std::size_t> limits_of = {};
};

/// How far a joint may still turn, rad, or slide, m, to its lower and to its upper limit, negative beyond it; and its
/// rate, rad/s or m/s.
struct LimitRoom {
  double low = 0, high = 0;
  double rate = 0;
};

class JointGeometry {
 public:
  explicit JointGeometry(const Scene&);

  /// Every direction of every joint, in the same order for any states; also that which limits bound, reached or not,
  /// and the one that a motor drives.
  std::vector<JointRow> rows(std::span<const BodyState>) const;

  std::size_t size() const { return ends_.size(); }
  /// The bodies of a joint.
  std::pair<std::size_t, std::size_t> bodies(std::size_t joint) const { return {ends_[joint].a, ends_[joint].b}; }
  /// m, by how much a joint is violated; 0 for a spring.
  double error(std::size_t joint, std::span<const BodyState>) const;
  /// m, by how much a joint would violate its limits after dt s at these velocities, if b turned faster by `spin`,
  /// rad/s.
  double passes_limits(std::size_t joint, std::span<const BodyState>, double dt, double spin = 0) const;
  /// rad/s^2, by which forces of these sizes, N, on the bodies may turn them about a hinge between them: F r/(I + m
  /// r^2) each, r the distance of its centre.
  double swung_by(std::size_t joint, double force_a, double force_b) const;
  /// rad/s, by which its motor may speed up a hinge in dt s: no faster than it is to turn, nor by more than its
  /// strength does to the two bodies alone. 0 for other joints.
  double driven_by(std::size_t joint, std::span<const BodyState>, double dt) const;
  /// Whether the joint's limits are of a way, in m.
  bool slides(std::size_t joint) const { return ends_[joint].keeps == Keeps::line; }
  /// nullopt without limits.
  std::optional<LimitRoom> room(std::size_t joint, std::span<const BodyState>) const;
  /// J, twice the energy that a joint's motor can give its bodies in dt s; 0 without a motor.
  double drive(std::size_t joint, double dt) const;
  /// Whether the joint's motor reached its speed between these states, passed it or lost it: then it changes its force
  /// within the step.
  bool switches(std::size_t joint, std::span<const BodyState> then, std::span<const BodyState> now) const;
  /// m, the distances of a joint's anchors from the centres of both bodies.
  std::pair<double, double> arms(std::size_t joint) const;
  /// J, what a joint stores if it is a spring of that angular frequency, rad/s (see Stepping::joint_frequency): w^2 d
  /// K^-1 d / 2 for the distance d of its anchors and their inverse effective mass K, and likewise for its angle if it
  /// keeps that. Of hinges, welds and rods; 0 for others.
  double stored(std::size_t joint, std::span<const BodyState>, double frequency) const;
  /// m/s^2, a bound of the acceleration by which joints hold any body: that of gravity, and w^2 r of every arm.
  double acceleration(std::span<const BodyState>, double gravity) const;
  /// rad/s, the fastest rotation of a body in a joint.
  double spin(std::span<const BodyState>) const;
  /// m, by how much a step of dt s along the tangents at these velocities violates a joint: a point at an arm r that
  /// turns by w dt leaves its circle by r (w dt)^2/2. Of a spring: how far its change of force moves its bodies, k/m
  /// dt^2 times the path.
  double linearisation(std::size_t joint, std::span<const BodyState>, double dt) const;

 private:
  using Keeps = JointFacts::Keeps;
  struct Ends {
    Keeps keeps;
    std::size_t a, b;
    Vec at_a, at_b;  // m, from the centres of mass, in the bodies' frames
    Vec axis = {};   // of a line, in a's frame
    double length = 0;
    double angle = 0;                   // rad, of b less a at the start
    double rate = 0;                    // 1/s^2, of a spring: its stiffness per mass
    std::optional<Limits> limits = {};  // of a point or a line
    std::optional<Motor> motor = {};
  };
  // How far the joint turned, rad, or slid, m, and its rate.
  struct Travel {
    double way = 0, rate = 0;
  };
  static Travel travel_of(const Ends&, const BodyState& a, const BodyState& b);
  static std::optional<LimitRoom> room_of(const Ends&, const BodyState& a, const BodyState& b);
  // rad or m, by how much the joint is beyond its limits, and m, what that is at the anchors.
  static double beyond_limits(const Ends&, const BodyState& a, const BodyState& b);
  static double gap_beyond_limits(const Ends&, const BodyState& a, const BodyState& b);

  std::vector<Ends> ends_;
  std::vector<Mass> masses_;
};

}  // namespace plumb
