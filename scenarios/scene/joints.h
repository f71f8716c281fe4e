#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json_fwd.hpp>

#include "scenarios/scene/maps.h"
#include "scenarios/scene/scene.h"

/// All operations that depend on the kind of joint: what it keeps, maps, reading from and writing to scene files.
namespace plumb {

class BodyNames;
class JsonReader;

/// As in scene files: "revolute".
const char* kind_name(const Joint&);

/// What a joint does, whatever its kind, for all that judges, draws or simplifies joints.
struct JointFacts {
  /// Two points on each other; the same and the angle between the bodies; b's point on a line through a's and the
  /// angle; a distance of two points, rigidly or by a spring.
  enum class Keeps { point, pose, line, rod, spring };

  Keeps keeps;
  std::size_t a, b;
  Vec anchor_a, anchor_b;          // world frame, at the start
  Vec axis = {};                   // of a line, world frame, at the start; of any length
  double length = 0;               // m, of a rod or a spring
  double stiffness = 0;            // N/m, of a spring
  double damping = 0;              // N s/m, of a spring
  const Limits* limits = nullptr;  // null where it has none
  const Motor* motor = nullptr;
};

/// The limits and the motor are the joint's own: it must outlive them.
JointFacts facts_of(const Joint&);
inline const Limits* limits_of(const Joint& joint) { return facts_of(joint).limits; }
inline const Motor* motor_of(const Joint& joint) { return facts_of(joint).motor; }

/// Where a map takes the points and directions of a joint on a body, whether it turns rotations around, and into which
/// units.
struct JointMap {
  std::function<Vec(std::size_t body, Vec)> point, direction;
  bool mirrored = false;
  Units units = {};
};

Joint mapped(const Joint&, const JointMap&);
Joint mapped(const Joint&, const Congruence&);
Joint in_units(const Joint&, const Units&);

/// Throws std::invalid_argument if it is not a valid joint.
Joint read_joint(const JsonReader&, const BodyNames&);
/// The scene gives the bodies their names.
nlohmann::ordered_json as_json(const Joint&, const Scene&);

}  // namespace plumb
