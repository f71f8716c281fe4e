#pragma once

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scenarios/catalog.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/scene.h"

namespace plumb {

struct BodyState {
  Vec position;  // of the centre of mass
  double angle = 0;
  Vec velocity;  // of the centre of mass
  double angular_velocity = 0;
};

/// One contact point as the engine left it after its last step.
struct ContactState {
  std::size_t a = 0, b = 0;    // indices into Scene::bodies
  Vec point;                   // world frame
  Vec normal;                  // unit, from a to b
  double normal_impulse = 0;   // N s on b along the normal, over the last step
  double tangent_impulse = 0;  // N s on b along the normal turned by +90 degrees, over the last step
  double separation = 0;       // m, negative when they overlap
};

/// What every engine offers, engines and closed forms alike.
class Simulation {
 public:
  Simulation() = default;
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;
  virtual ~Simulation() = default;

  /// Advances by dt seconds. The only call that is ever timed. Throws std::domain_error, saying why, where it turns out
  /// on the way that the scene is beyond the engine: that is *not supported*, not a failure.
  virtual void step(double dt) = 0;

  /// Writes the state of every body, in Scene order. `out` is as long as Scene::bodies.
  virtual void read(std::span<BodyState> out) const = 0;

  /// Appends the contacts of the last step. A engine that reports none appends nothing.
  virtual void read_contacts(std::vector<ContactState>&) const {}

  /// Seconds from the start for which the answer holds; a closed form may end at its second impact. By default: for
  /// ever.
  virtual double valid_until() const;
};

/// A setting that a engine understands, for `--engine NAME:key=value`.
struct Option {
  std::string key;
  std::string value;                                         // by default
  std::vector<std::pair<std::string, std::string>> choices;  // value and one line about it; empty: a number
  std::string about;
  double min = 0, max = 0;  // of a number
  bool whole = false;       // takes whole numbers only
};

/// Values by option key; what is missing has its default.
using Settings = std::map<std::string, std::string>;

/// What a engine chose by itself for a scene.
struct Choice {
  std::string option;
  std::string value;
  std::string reason;
};

/// A method of a engine, and the option by which it can be made to work harder.
struct WorkLadder {
  Settings method;                  // what tells it from the default
  std::string option;               // "" where there is none
  std::vector<std::string> values;  // of the option, from cheap to dear
};

/// Something that can answer a scene: our engine, a rival, a closed form.
struct Engine {
  std::string name;
  std::string about;   // one line
  std::string source;  // where it comes from, with version; for a closed form the textbook
  bool exact = false;  // a closed form: a truth, not a competitor
  std::vector<Option> options;
  /// Settings worth showing beside the default ones; a report without a choice of engines runs these too.
  std::vector<Settings> also = {};
  /// Its methods, as a study of speed against accuracy tries them. Of none: its default, and `also`.
  std::vector<WorkLadder> ladders = {};
  std::function<Stepping(const Settings&, double dt)> stepping;

  /// Why it cannot run this scene; "" when it can.
  std::function<std::string(const Scene&, const Settings&)> unsupported;
  std::function<std::unique_ptr<Simulation>(const Scene&, const Settings&)> build;
  /// What it chooses by itself for a scene, against its settings; null where it never does.
  std::function<std::vector<Choice>(const Scene&, const Settings&)> chooses = nullptr;
};

/// The settings with every option present, in the engine's own words. Throws std::invalid_argument, naming the
/// nearest key or choice, for what it does not know.
Settings complete(const Engine&, const Settings&);

}  // namespace plumb
