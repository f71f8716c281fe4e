#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reports/judge/verdict.h"
#include "reports/run/run.h"

namespace plumb {

/// All that a run is known by once it is judged.
struct Examined {
  Status status = Status::ok;
  std::string reason;      // why not ok
  Judgement judgement;     // the worst of all phases, where the scenario has them
  std::uint64_t bits = 0;  // of every state and contact of the run that begins on a whole step
  bool same_twice = true;  // whether a second run had the same bits
};

/// Runs a case twice, and in all its phases, and judges it by its truths and invariants.
Examined examine_twice(const Case&, const EngineConfig&, double dt);

/// How a fault shows. The first three need nothing to be held against; the last says only that something changed.
enum class Means { truth, invariant, repeat, bits };

/// "truth", "invariant", "not the same twice", "bits alone".
const char* name_of(Means);

/// One thing that holds for the right method and not for another.
struct Alarm {
  std::string scenario;
  std::string variant;
  Means means = Means::truth;
  std::string metric;  // "box y", "energy"
  std::string unit;
  double off = 0, tolerance = 0;
  double ratio = 0;  // off / tolerance; infinite where nothing is allowed, or the run did not come to its end
};

/// What `suspect` misses and `right` does not. Nothing where the right one does not run the case: then no one is told
/// from it. Bits alone are an alarm only where nothing else is.
std::vector<Alarm> alarms(const Case&, const Examined& right, const Examined& suspect);

/// The same without a look at the bits, for runs that may have others.
std::vector<Alarm> physics_alarms(const Case&, const Examined& right, const Examined& suspect);

}  // namespace plumb
