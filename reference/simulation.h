#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
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

/// One contact point after the last step, once: with the sum of its impulses where several solves met it.
struct ContactState {
  std::size_t a = 0, b = 0;    // indices into Scene::bodies
  Vec point;                   // world frame
  Vec normal;                  // unit, from a to b
  double normal_impulse = 0;   // N s on b along the normal, over the last step
  double tangent_impulse = 0;  // N s on b along the normal turned by +90 degrees, over the last step
  double separation = 0;       // m, negative when they overlap
};

/// A scene as one engine or closed form runs it.
class Simulation {
 public:
  Simulation() = default;
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;
  virtual ~Simulation() = default;

  /// Says that the next `steps` steps will last dt seconds each. It changes no result; an engine that is a program of
  /// its own can compute them while their states are read.
  virtual void announce(double /*dt*/, std::size_t /*steps*/) {}

  /// Advances by dt seconds. The only call that is ever timed. Throws std::domain_error with the reason if the scene
  /// turns out to be beyond the engine: that is reported as *not supported*, not as a failure.
  virtual void step(double dt) = 0;

  /// Gives a kinematic body another velocity, m/s, for the steps to come. Throws std::logic_error if the engine has not
  /// implemented it: then its `unsupported` refuses scenes with paths.
  virtual void drive(std::size_t body, Vec velocity);

  /// Writes the state of every body, in Scene order. `out` is as long as Scene::bodies.
  virtual void read(std::span<BodyState> out) const = 0;

  /// Appends the contacts of the last step; nothing if the engine does not report contacts.
  virtual void read_contacts(std::vector<ContactState>&) const {}

  /// Seconds that all steps so far took by the engine's own clock, for an engine whose calls cost more than its steps:
  /// a program of its own. nullopt: the time of the calls counts.
  virtual std::optional<double> seconds_stepped() const { return std::nullopt; }

  /// Seconds from the start until which the solution is valid, infinite by default. A closed form may end at the second
  /// impact, for example.
  virtual double valid_until() const;
};

/// A setting of an engine, given as `--engine NAME:key=value`.
struct Option {
  std::string key;
  std::string value;                                         // default
  std::vector<std::pair<std::string, std::string>> choices;  // value and one line about it; empty for a number
  std::string about;
  double min = 0, max = 0;  // of a number
  bool whole = false;       // whether the number must be whole
};

/// How the code of an engine runs. It decides times as much as the method does, so they are told apart by it.
enum class ExecutionKind { native, webassembly, jit, interpreted, not_stated };

/// "native", "WebAssembly", "JIT", "interpreted", "not stated".
const char* name_of(ExecutionKind);

/// Values by option key; a missing one has its default.
using Settings = std::map<std::string, std::string>;

/// A value that an engine chose by itself for a scene.
struct Choice {
  std::string option;
  std::string value;
  std::string reason;
};

/// A method of an engine, and the option that trades its speed for accuracy.
struct WorkLadder {
  Settings method;                  // settings that select it
  std::string option;               // "" if there is none
  std::vector<std::string> values;  // of the option, from cheap to expensive
};

/// Anything that can run a scene: our engine, another physics engine, a closed form.
struct Engine {
  std::string name;
  std::string about;      // one line
  std::string source;     // origin and version; for a closed form the textbook
  std::string word = {};  // how a command line names it, if not by its name: "exec:./mine"
  std::string language = "C++";
  ExecutionKind execution = ExecutionKind::native;
  /// What it does differently from what the scene means, a sentence each; shown beside its verdicts.
  std::vector<std::string> caveats = {};
  bool exact = false;  // a closed form: a reference solution, not a competitor
  std::vector<Option> options;
  /// Settings worth showing beside the default ones: a report for which no engines were selected runs these too.
  std::vector<Settings> also = {};
  /// The methods that a study of speed against accuracy tries. If empty, it tries the default and `also`.
  std::vector<WorkLadder> ladders = {};
  std::function<Stepping(const Settings&, double dt)> stepping;

  /// Why it cannot run the scene; "" if it can, or if only `build` knows.
  std::function<std::string(const Scene&, const Settings&)> unsupported;
  std::function<std::unique_ptr<Simulation>(const Scene&, const Settings&)> build;
  /// The values that it chooses by itself for a scene with these settings; null if it never does.
  std::function<std::vector<Choice>(const Scene&, const Settings&)> chooses = nullptr;
  /// Whether it may run in Plumb's own process, because it was tested with it. Other engines get processes of their own
  /// (see isolated): a crash, a hang or a call of exit then fails its own runs and nothing else.
  bool in_process = false;
};

/// The settings with every option present. Throws std::invalid_argument for an unknown key or choice, naming the
/// nearest known one, and for a number that is malformed or out of range.
Settings complete(const Engine&, const Settings&);

/// An engine whose adapter is part of Plumb, but not of this build.
struct LeftOutEngine {
  std::string_view name;  // as its adapter calls it
  std::string_view why;   // "Box2D 3 was not found", and what helps
};

/// Generated by CMake (leave_out).
std::span<const LeftOutEngine> left_out_engines();

}  // namespace plumb
