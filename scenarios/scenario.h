#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/catalog.h"
#include "scenarios/scene/quantity.h"
#include "scenarios/scene/scene.h"

namespace plumb {

/// A parameter of a family of scenes.
struct Parameter {
  std::string name;
  double value = 0;  // the default
  double min = 0, max = 0;
  std::string unit;    // "" if it has none
  std::string about;   // in words
  bool whole = false;  // takes whole numbers only
};

/// Values by parameter name. Complete: every parameter of the family has a value.
using Parameters = std::map<std::string, double>;

/// What an engine states about how it steps: enough to predict the size of its errors. Declared by the engine's
/// adapter, never measured.
struct Stepping {
  double dt = 0;  // s, time step: one call to step
  double h = 0;   // s, integration sub-step

  /// Position error of free fall, as a factor of gravity * t * h: +1/2 for symplectic Euler, -1/2 for explicit Euler, 0
  /// if free fall is exact.
  double drift = 0;
  double damping_interval = 0;  // s, at which damping acts; 0: at every sub-step
  int order = 0;                // order of convergence in h of smooth free motion; 0: not stated
  int order_in_contact = 0;     // order of convergence in h of smooth sliding along a contact; 0: not stated
  double impact_lag = 1;        // latest detection of an impact, in units of h; 0 if the time of impact is solved for
  double impact_lead = 0;       // earliest braking of an approach before the bodies touch, likewise

  double skin = 0;          // m, the largest separation at which a contact at rest carries load
  double slop = 0;          // m, the overlap (of skins, if it has them) of a contact at rest that is left alone, or its
                            // compliance under one weight: points of one contact rest at most that far from level
  double joint_slop = 0;    // m, the distance between the anchors of a joint at rest, likewise
  double angular_slop = 0;  // rad, by which a hinge at rest may be past its limit
  /// Hz, of contacts that are damped springs, which a smaller step does not make stiffer: at rest they overlap by
  /// load/(m w^2), w = 2 pi times this and m the effective mass of the two bodies at the point. 0: they are no springs.
  double contact_frequency = 0;
  double fixed_contact_frequency = 0;  // Hz, the same of contacts with what does not move
  double joint_frequency = 0;          // Hz, the same of joints, whose anchors come apart by that
  /// Whether a contact keeps its points on both bodies for a whole step, in which these turn: the lowest point of a
  /// disc of radius r that turns by a rises by r (1 - cos a), and the disc is let down by as much.
  bool held_anchors = false;
  /// Whether a rotation goes along its tangent and is normalised, so that a sub-step turns by atan(w h).
  bool tangent_rotation = false;
  double creep = 0;  // m/s, the largest sliding speed of a sticking contact whose friction bears all of gravity; if
                     // it bears a share of it, that share
  double rest_speed = 0;             // m/s, the largest speed at which a body may be put to sleep; 0: it never sleeps
  double restitution_threshold = 0;  // m/s, slower impacts are treated as inelastic
  int iterations = 0;  // solver iterations over simultaneous impacts; 0 if they are solved one by one or exactly
  int position_iterations = 0;  // iterations over overlaps and joint errors, where they are corrected separately
  double epsilon = 0;           // unit round-off of its arithmetic
  bool differenced_velocities = false;  // whether it keeps velocities as differences of positions, rounded as these are
  bool whole_impulses = true;           // whether reported contact impulses, if any, are sums over the whole step

  /// Whether it looks for contacts within the whole step ahead, so that no body passes through another, with or without
  /// continuous collision.
  bool looks_ahead = false;

  /// The largest w dt at which a mass on an undamped spring, w = sqrt(k/m), stays bounded forever. 0: never bounded;
  /// nullopt: not stated.
  std::optional<double> spring_limit = std::nullopt;

  /// m, by which a contact at rest may be separated or overlap.
  double contact_gap() const { return std::max(skin, slop); }
};

/// One statement that must hold in a run.
struct Expectation {
  std::string body;   // "" for quantities of the whole scene
  std::string other;  // load: count contacts with this body only; "" counts all contacts
  Quantity quantity = Quantity::x;
  Relation relation = Relation::equal;
  std::optional<double> time;      // s; nullopt means the end
  double over = 0;                 // s, averaging interval up to that time; 0: the value at that moment
  int index = 0;                   // apex, landing: which one, counted from 1
  std::optional<double> expected;  // nullopt: the value of the scenario's closed form at that time

  /// The largest error, in the quantity's unit, that an engine which steps like this may make.
  std::function<double(const Stepping&)> allowed;
  /// If set, replaces `allowed`: the largest error for any engine, including round-off.
  std::optional<double> within = std::nullopt;
  /// How far from the law chance alone takes a mean over a finite sample, in the quantity's unit: no error of an
  /// engine.
  double chance = 0;
  std::string source;  // the formula, and the reason for the tolerance
};

/// One canonical setting of a family, given by the parameters that differ from the defaults.
struct Variant {
  std::string label;  // unique within the family
  Parameters changes;
};

/// Whether a motion is smooth, so that a method shows its order of convergence: no impacts and no change between
/// sticking and sliding. `free`: nothing touches. `sliding`: slides along a contact from the start.
enum class Smoothness { none, free, sliding };

/// A family of scenes that asks one question.
struct Scenario {
  std::string name;
  std::string question;  // "Does a dropped disc come to rest?"
  std::vector<Parameter> parameters;
  std::vector<Variant> variants;  // at least one; `report` runs them
  std::string closed_form;        // name of the reference/exact entry with the exact solution; "" if there is none
  std::function<Scene(const Parameters&)> scene;
  std::function<std::vector<Expectation>(const Parameters&)> expectations;
  bool canonical = false;                                             // part of the short report, the default
  std::function<Smoothness(const Parameters&)> smoothness = nullptr;  // null: none
  bool phased = false;  // whether its errors depend on when within a step an impact happens
  std::string group;    // "friction": the folder of its file; its entry sets it
};

/// The default values with the changes applied. Throws std::invalid_argument if a name is unknown (the message suggests
/// the nearest one), a value is out of range, or a whole number has a fraction.
Parameters complete(const Scenario&, const Parameters& changes);

/// What the families of one folder ask about; group.cpp has them all.
struct ScenarioGroup {
  std::string name;   // the folder
  std::string title;  // "chaos and statistics"
  std::string stake;  // what goes wrong in a game or a simulation if an engine fails here; a sentence
};

}  // namespace plumb
