#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reference/converged/converged.h"
#include "reports/judge/observe.h"
#include "reports/judge/scale.h"
#include "reports/run/horizon.h"
#include "reports/run/run.h"

/// Judges runs by a converged reference.
namespace plumb {

/// The reference that judges a case, of at most `budget` body-steps of each engine. nullopt if the budget is 0, where a
/// closed form can be evaluated; where kinematic bodies follow paths, as engines are given their mean velocity in each
/// step, which is no property of the method; and where the scenario says itself where a body that moves freely should
/// be: it has tolerances derived for its own motion, which know of impacts and edges, for example, what a general bound
/// can't. That a body stays on one side of a place says nothing of the kind.
std::optional<ConvergedTruth> converged_reference(const Case&, double dt, std::size_t budget);

/// The checks of one scene: place and angle of up to `judged_bodies` bodies, spread evenly over the scene, and the
/// energy. The tolerance is what the method states about itself, times how the scene amplifies it (see horizon.h), plus
/// the error of the reference. Each quantity is checked at the latest time at which that is evidence, and less than
/// half of what the truth changes up to then, so that no body can pass by standing still; and once in the first half of
/// the time to there.
class ConvergedChecks {
 public:
  /// The truth and the scene must outlive it. `dt`, s, is the step of the runs and of the truth's times.
  ConvergedChecks(const Scene&, const ConvergedTruth&, double dt);

  /// Whether the reference is valid beyond a first touch, or to its own end in a scene without any: whether it knows
  /// what the scene is for.
  bool knows_contact() const;

  /// Whether at that time, s, a body is yet to touch something for the first time, which it will; with "", any body.
  /// What is asked before asks nothing about what the scene is for.
  bool precedes_touch(const std::string& body, double time) const;

  /// None if the method's error can nowhere be told from a wrong motion.
  std::vector<TruthCheck> of(const Stepping&, const Trace&) const;

 private:
  struct Moment {
    std::size_t index = 0;    // of the truth's times
    Scales moved;             // what the truth changes up to there
    double energy_error = 0;  // J, of the reference
  };
  struct Question {
    Expectation expectation;
    std::size_t body = 0;
  };

  std::vector<Question> questions() const;
  /// The reference's error plus the method's; infinite where none can be given.
  double tolerance(const Question&, const Moment&, const Stepping&) const;
  /// J, by how much the truth's energy changes up to a moment in the time by which an impact may be late.
  double energy_lag(std::size_t index, double late) const;
  std::string source(const Question&, const Moment&, const Stepping&) const;

  const Scene& scene_;
  const Converged& answer_;
  Truth truth_;
  Scales scales_;
  Growth growth_;
  std::vector<double> touches_;   // s, by body: its first; infinite without one
  std::vector<Moment> moments_;   // latest first
  std::vector<double> energies_;  // J, of the truth, at its times
};

/// The most bodies that are checked.
inline constexpr std::size_t judged_bodies = 4;

}  // namespace plumb
