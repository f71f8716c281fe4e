#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "impulse/material.h"
#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// What happens to bodies that move farther than half their thickness in a step; slower ones are never looked at.
enum class Continuous : std::uint8_t {
  off,        // they pass through what is thinner than their way, unless the solver looks ahead
  automatic,  // they stop where they meet a fixed or kinematic body, a `bullet` at any body; the rest of the step is
              // lost
  on          // as if all were bullets
};

/// How a world steps. World refuses settings that make no sense (std::invalid_argument names the field) and keeps the
/// ones it had.
struct Settings {
  Vec2 gravity{0, -10};                         // m/s^2
  Real dt = static_cast<Real>(1.0 / 60.0);      // s, of a step
  std::string solver = "accurate";              // one of solvers()
  std::string integrator = "symplectic-euler";  // one of integrators(); for solvers that leave the choice
  std::string broad_phase = "auto";             // one of broad_phases()
  int iterations = 10;                          // of the velocity solver
  int position_iterations = 3;                  // for solvers that correct positions apart from velocities
  int substeps = 4;                             // for solvers that cut a step into sub-steps
  int workers = 1;                              // threads to share islands among; the bits are the same for any number
  bool contacts = true;  // whether bodies meet at all; else they pass through each other, and no pair is looked for
  Continuous continuous = Continuous::automatic;
  bool contact_events = false;  // whether World::contact_events() is kept up; else it costs nothing
  /// Whether islands at rest fall asleep (see World); the bits then differ from those of a world that stays awake.
  bool sleeping = false;
  /// A body is at rest once it has been no faster than these for sleep_time, and has stayed where it was up to a
  /// hundredth of what the linear speed makes in that time: what creeps (as piles under xpbd do) or turns back is not
  /// at rest. All above 0. As Box2D 2.4 has them, where they have long served games.
  Real sleep_linear_speed = static_cast<Real>(0.01);                 // m/s
  Real sleep_angular_speed = static_cast<Real>(2) * pi / Real{180};  // rad/s
  Real sleep_time = static_cast<Real>(0.5);                          // s
  FrictionMixing friction_mixing = FrictionMixing::geometric;
  RestitutionMixing restitution_mixing = RestitutionMixing::max;
};

/// Throws std::invalid_argument, naming the field and what it may be.
void validate(const Settings&);

struct MethodInfo {
  std::string name;
  std::string about;   // one line
  std::string source;  // the paper, talk or code that describes it
};

/// What can be named in Settings, sorted by name.
std::vector<MethodInfo> solvers();
std::vector<MethodInfo> integrators();
std::vector<MethodInfo> broad_phases();

/// What the chosen methods say of their own errors, before any is measured.
struct StatedErrors {
  Real h = 0;                      // s, of one integration sub-step
  Real drift = 0;                  // free fall is off by drift * gravity * t * h
  int order = 1;                   // smooth free motion is off by a multiple of h^order
  int order_in_contact = 1;        // and sliding along what is touched, by one of h^order_in_contact
  Real impact_lag = 1;             // how late an impact may be noticed, in units of h; 0 where its time is solved for
  Real gap = 0;                    // m, by which a resting contact may stand off from touching, either way
  Real creep = 0;                  // m/s, at which a sticking contact may slide
  Real restitution_threshold = 0;  // m/s, slower impacts are inelastic
  Real joint_omega = 0;  // rad/s of the springs that joints are in islands too large to be solved at once: such
                         // a joint stretches by its load / (2 m_eff joint_omega^2); 0: all are solved alike
  bool joints = false;   // whether the solver holds them; else they are not there
};

/// Throws std::invalid_argument for settings that validate() refuses.
StatedErrors stated_errors(const Settings&);

}  // namespace impulse::inline IMPULSE_PRECISION
