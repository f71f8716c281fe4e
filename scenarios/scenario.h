#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/catalog.h"
#include "scenarios/scene/scene.h"

namespace plumb {

/// A number that a family of scenes is made from.
struct Parameter {
  std::string name;
  double value = 0;  // by default
  double min = 0, max = 0;
  std::string unit;    // "" where it has none
  std::string about;   // in words
  bool whole = false;  // takes whole numbers only
};

/// Values by parameter name, complete: every parameter of the family has one.
using Parameters = std::map<std::string, double>;

/// What a engine states of how it steps: enough to predict its errors. Stated, never measured.
struct Stepping {
  double dt = 0;  // s, of a call to step
  double h = 0;   // s, of one integration sub-step
  double drift =
      0;  // free fall is off by drift * gravity * t * h: +1/2 for symplectic Euler, -1/2 for explicit, 0 where exact
  int order = 0;             // smooth free motion is off by a multiple of h^order; 0: not stated
  int order_in_contact = 0;  // and sliding along what is touched, by one of h^order_in_contact; 0: not stated
  double impact_lag = 1;     // how late an impact may be noticed, in units of h; 0 where its time is solved for
  double gap = 0;    // m, by which a resting contact may stand off from touching, either way (skin, slop, compliance)
  double creep = 0;  // m/s, at which a sticking contact may slide by the method's nature
  double rest_speed = 0;  // m/s, up to which a body may be stopped dead and no longer looked at (sleeping); 0: never
  double restitution_threshold = 0;  // m/s, slower impacts are treated as inelastic
  int iterations = 0;          // sweeps over impacts that fall together; 0 where these are taken one by one, or exactly
  double epsilon = 0;          // unit round-off of its arithmetic
  bool whole_impulses = true;  // the contact impulses that it shows, if any, are the sums over the step
  /// It sees what a body may hit within a step, so that none passes by, with continuous collision or without.
  bool looks_ahead = false;
  /// w dt up to which a mass on an undamped spring of w = sqrt(k/m) stays bounded, for ever; 0: for no step; nothing:
  /// not stated.
  std::optional<double> spring_limit = std::nullopt;
};

/// What can be read off a motion. x, y, vx, vy are of the centre of mass; energy and momenta are of the whole scene
/// (kinetic + gravity + springs and attractions; about the world's origin; dynamic bodies only). All from `load` on are
/// of a run rather than of a moment.
enum class Quantity {
  x,
  y,
  angle,
  vx,
  vy,
  speed,
  angular_velocity,
  energy,
  momentum_x,
  momentum_y,
  angular_momentum,
  speed_spread,  // <v^4>/<v^2>^2 over the dynamic bodies: 1 where all are equally fast, 2 for Maxwell's law in a plane
  load,          // the normal forces of the contacts on a body
  energy_rise,   // the most by which the energy ever came above an earlier moment's
  landing,       // when y had a local minimum
  apex           // a local maximum of y
};

/// How the measured value must stand to the expected one, give or take what is allowed.
enum class Relation { equal, at_least, at_most };

/// "equal", "at least", "at most".
const char* name_of(Relation);

const char* name_of(Quantity);
const char* unit_of(Quantity);

/// One thing that must come true in a run.
struct Expectation {
  std::string body;   // "" for quantities of the whole scene
  std::string other;  // load: of contacts with this body alone; "" for those with any
  Quantity quantity = Quantity::x;
  Relation relation = Relation::equal;
  std::optional<double> time;                      // s; nothing means the end
  double over = 0;                                 // s up to then that the reading is the mean of; 0: that moment's
  int index = 0;                                   // apex, landing: the how-manieth, from 1
  std::optional<double> expected;                  // nothing: what the scenario's closed form says at that time
  std::function<double(const Stepping&)> allowed;  // largest error, in the quantity's unit, from how the engine steps
  std::optional<double> within = std::nullopt;  // largest error whoever steps, round-off and all, instead of `allowed`
  std::string source;                           // the formula, and why that much is allowed
};

/// One canonical setting of a family, by the parameters that differ from the defaults.
struct Variant {
  std::string label;  // unique within the family
  Parameters changes;
};

/// Whether a motion is smooth, so that a method shows its order: nothing happens in an instant, no impact and no change
/// between sticking and sliding. `free`: nothing touches. `sliding`: along what it touches from the beginning.
enum class Smoothness { none, free, sliding };

/// A family of scenes that asks one question.
struct Scenario {
  std::string name;
  std::string question;  // "Does a lone box fall as Galileo says?"
  std::vector<Parameter> parameters;
  std::vector<Variant> variants;  // at least one; what `report` runs
  std::string closed_form;        // entry of reference/exact that knows the answer; "" where physics has none
  std::function<Scene(const Parameters&)> scene;
  std::function<std::vector<Expectation>(const Parameters&)> expectations;
  bool canonical = false;                                             // part of the short report that runs by default
  std::function<Smoothness(const Parameters&)> smoothness = nullptr;  // null: none
  bool phased = false;  // its errors depend on where in a step an impact falls
};

/// All defaults, with the changes laid over. Throws std::invalid_argument for an unknown name, a value out of range or
/// a broken whole number; the message names the nearest parameter.
Parameters complete(const Scenario&, const Parameters& changes);

}  // namespace plumb
