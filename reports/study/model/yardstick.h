#pragma once

#include <memory>
#include <string>
#include <vector>

#include "reports/run/run.h"
#include "reports/study/answer.h"

namespace plumb {

/// How much worse than a full model another one answers a case.
///
/// By the truth, for as long as there is one. Where it ends before the scene, or does not know itself to within the
/// tolerance, by the difference from the full model as well, up to the scene's horizon: beyond, runs that began a
/// billionth apart have parted, and a difference says nothing.
class Yardstick {
 public:
  Yardstick(Case asked, EngineConfig full, double dt, double tolerance);

  /// Looks for the truth and runs the full model, once; before that nothing is known.
  void find();

  struct Reading {
    Status status = Status::ok;
    std::string reason;  // why not ok
    double error = 0;    // m, from the truth; not a number where there is none
    double change = 0;   // m, by which it is worse than the full model; infinite where it did not run
  };
  Reading read(const EngineConfig&) const;
  bool within(const Reading&) const;

  const Case& asked() const { return asked_; }
  const EngineConfig& full() const { return full_; }
  double dt() const { return dt_; }
  /// Who says the truth; "" where nobody does.
  std::string truth() const;
  double truth_until() const;                             // s
  double truth_error() const { return answer_.error(); }  // m
  /// s, up to where models are compared with the full one; 0 where the truth does without.
  double compared_until() const { return compared_until_; }
  std::size_t phases() const { return phases_.size(); }

 private:
  double difference(const Trace&, const Trace&, double until) const;

  Case asked_;
  EngineConfig full_;
  double dt_;
  double tolerance_;
  Answer answer_;
  double arm_;  // m, what a turn by an angle moves: the radius of gyration of the smallest body
  bool found_ = false;
  double compared_until_ = 0;
  std::vector<Case> phases_;
  std::vector<std::shared_ptr<const Trace>> truths_;  // of each phase
  std::vector<std::shared_ptr<const Trace>> fulls_;
  double full_error_ = 0;
};

}  // namespace plumb
