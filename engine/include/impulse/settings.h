#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "impulse/material.h"
#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Continuous collision for bodies that move farther than half their thickness in a step; slower ones don't need it.
enum class Continuous : std::uint8_t {
  off,        // bodies tunnel through anything thinner than their displacement, unless the solver looks ahead
  automatic,  // bodies stop where they hit a fixed or kinematic body, bullets where they hit any body; they lose the
              // rest of the step
  on          // all bodies are bullets
};

/// The solvers of the library for games. Others have only names: see solvers().
enum class SolverType : std::uint8_t { accurate, soft_step };
/// The name for Settings::solver: `settings.solver = name_of(SolverType::soft_step)`.
const char* name_of(SolverType solver);

/// How a world steps. World rejects invalid settings (std::invalid_argument names the field) and keeps its old ones.
struct Settings {
  Vec2 gravity{0, -10};                         // m/s^2
  Real dt = static_cast<Real>(1.0 / 60.0);      // s, one step
  std::string solver = "accurate";              // one of solvers(), see name_of()
  std::string integrator = "symplectic-euler";  // one of integrators(); ignored by solvers with their own
  std::string broad_phase = "auto";             // one of broad_phases()
  int iterations = 10;                          // of the velocity solver
  int position_iterations = 3;                  // for solvers that correct positions separately from velocities
  int substeps = 4;                             // for solvers that sub-step
  int workers = 1;                              // threads that share islands; the bits are the same for any number
  bool contacts = true;                         // if off, bodies pass through each other and the broad phase is skipped
  Continuous continuous = Continuous::automatic;
  bool contact_events = false;  // whether to keep World::contact_events(); free if off, and changes no bit
  /// Whether resting islands fall asleep (see World). The bits then differ from those of a world that stays awake.
  bool sleeping = false;
  /// A body is at rest once it has been no faster than these for sleep_time and has stayed where it was, to within
  /// .5 % of the distance that the linear speed covers in that time: creeping (as piles do under xpbd) or turning back
  /// is not rest. What springs pull and no friction holds must stand still, to within rounding. All above 0. The
  /// defaults are those of Box2D 2.4.
  Real sleep_linear_speed = static_cast<Real>(0.01);                 // m/s
  Real sleep_angular_speed = static_cast<Real>(2) * pi / Real{180};  // rad/s
  Real sleep_time = static_cast<Real>(0.5);                          // s
  FrictionMixing friction_mixing = FrictionMixing::geometric;
  RestitutionMixing restitution_mixing = RestitutionMixing::max;
};

/// Throws std::invalid_argument, naming the field and its valid range.
void validate(const Settings&);

struct MethodInfo {
  std::string name;
  std::string about;   // one line
  std::string source;  // the paper, talk or code that describes it
};

/// The names that Settings accepts, sorted.
std::vector<MethodInfo> solvers();
std::vector<MethodInfo> integrators();
std::vector<MethodInfo> broad_phases();

/// The errors that the chosen methods are known to make, from theory rather than measurement.
struct StatedErrors {
  Real h = 0;                      // s, one integration sub-step
  Real drift = 0;                  // free fall is off by drift * gravity * t * h
  int order = 1;                   // the error of smooth free motion is proportional to h^order
  int order_in_contact = 1;        // and that of sliding along a contact to h^order_in_contact
  Real impact_lag = 1;             // how late an impact may be detected, in units of h; 0 if its time is solved for
  Real gap = 0;                    // m, by which a resting contact may be separated or overlap
  Real joint_gap = 0;              // m, by which the anchors of a resting joint may be apart
  Real creep = 0;                  // m/s, at which a sticking contact may slide if its friction bears all of gravity; a
                                   // share of it at that share of the speed, none of it on level ground
  Real restitution_threshold = 0;  // m/s, slower impacts are inelastic
  Real joint_omega = 0;  // rad/s, natural frequency of joints in islands too large for a direct solve: there a joint
                         // stretches by its load / (2 m_eff joint_omega^2). 0: all joints are solved alike
  bool joints = false;   // whether the solver supports joints; if not, it ignores them
  bool looks_ahead = false;  // whether the solver sees contacts that will only close within the step, so that bodies
                             // don't tunnel, with continuous collision or without
};

/// Throws std::invalid_argument for settings that validate() rejects.
StatedErrors stated_errors(const Settings&);

}  // namespace impulse::inline IMPULSE_PRECISION
