#pragma once

#include <optional>
#include <span>
#include <vector>

#include "reports/trace.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/scene.h"

/// Energy, momentum and forces of a scene, computed from the scene and the states of its bodies alone, in double, by
/// code that no engine shares. States give the centre of mass.
namespace plumb {

/// The states after `time` s at constant velocities.
std::vector<BodyState> moved_on(std::span<const BodyState>, double time);

struct Energy {
  double linear = 0;      // J, sum of m v^2/2
  double rotational = 0;  // J, sum of I w^2/2
  double potential = 0;   // J: gravity's -m s g.r (s the gravity scale), springs' and attractions'
  double kinetic() const { return linear + rotational; }
  double total() const { return linear + rotational + potential; }
};

struct Momentum {
  Vec linear;          // kg m/s
  double angular = 0;  // kg m^2/s, about the world's origin
};

/// Whether something outside keeps up a velocity of the body, and so may do work: a kinematic body that moves, and one
/// that may not turn but has an angular velocity.
bool is_driven(const Body&);

/// The states that the scene starts from.
std::vector<BodyState> initial_states(const Scene&);

/// The forces of a scene, and its soft distance joints, which are springs between points of two bodies.
std::vector<Force> forces_of(const Scene&);

/// Energy and momentum of a scene's dynamic bodies. The scene must outlive it.
class Conserved {
 public:
  explicit Conserved(const Scene&);

  Energy energy(std::span<const BodyState>) const;
  Momentum momentum(std::span<const BodyState>) const;

  /// By body, in Scene order.
  std::span<const Mass> masses() const { return masses_; }

 private:
  double potential_of(const Attraction&, std::span<const BodyState>) const;

  // A linear spring between two points, each relative to a body's centre of mass, or in the world.
  struct Elastic {
    std::optional<std::size_t> a;
    std::size_t b = 0;
    Vec at_a, at_b;
    double stiffness = 0, length = 0;
  };

  const Scene& scene_;
  std::vector<Mass> masses_;
  std::vector<Elastic> elastics_;
};

struct Wrench {
  Vec force;          // N at the centre of mass
  double torque = 0;  // N m about it
};

/// N and N m: how far a wrench may be off.
struct WrenchError {
  double force = 0, torque = 0;
};

/// Gravity and the scene's forces on its dynamic bodies, without rigid joints and contacts. Independent of Loads
/// (reference/adapter.h), which feeds the same forces to engines that lack them. The scene must outlive it.
class AppliedForces {
 public:
  explicit AppliedForces(const Scene&);

  /// By body, in Scene order; zero for a body that is not dynamic.
  std::vector<Wrench> at(std::span<const BodyState>) const;

  /// By body: how far the force that a method takes for a step of dt s may be off from the mean of both ends, whichever
  /// end it takes, or any place on the way that the velocities at the start lead by: the middle of the step, and where
  /// bodies turn by radians, one for each, and where they pass what pulls at them. And how far the mean over the step
  /// may be: half the difference of the ends; and where forces turn back within it, as a spring at the end of its
  /// stroke, an eighth of what their rates at both ends would change in a step.
  std::vector<WrenchError> change_in(std::span<const BodyState> then, std::span<const BodyState> now, double dt) const;

  /// The states in which bodies that went straight on for `time` s, or back if it is negative, would pass what pulls at
  /// them, so near that they go farther in that time: a force may come and go between two moments.
  std::vector<std::vector<BodyState>> passages(std::span<const BodyState>, double time) const;

  /// W, the power that the scene's forces bring in from outside: it moves the centre of an attraction that is not
  /// mutual, and the end of a spring on a kinematic body. (A constant force has a potential instead.)
  double power(std::span<const BodyState>) const;

  /// J, of the constant forces: -F.x - T angle.
  double potential(std::span<const BodyState>) const;

  std::span<const Mass> masses() const { return conserved_.masses(); }
  const Conserved& conserved() const { return conserved_; }

 private:
  Vec attracted(const Attraction&, std::size_t body, std::span<const BodyState>) const;

  const Scene& scene_;
  std::vector<Force> forces_;
  Conserved conserved_;
};

/// J, the energy that a scene can convert, by which errors of energy are scaled. It depends on the scene and its closed
/// form only, so it is the same for every engine: the kinetic energy at the start, plus the energy of springs and
/// attractions there, plus what gravity would release if all bodies sank from the top of the arrangement to its bottom;
/// or the largest kinetic energy of the closed form, if that is more. `truth` may be null.
double energy_range(const Scene&, const Trace* truth);

}  // namespace plumb
