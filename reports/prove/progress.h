#pragma once

#include <cstddef>
#include <mutex>
#include <string>

#include "reports/run/experiment.h"

namespace plumb {

/// Counts what begins, and reports it from several threads, one at a time.
class ProgressCounter {
 public:
  /// `progress` must outlive it.
  ProgressCounter(const Progress& progress, std::size_t all) : progress_(progress), all_(all) {}
  void begin(const std::string& what) {
    const std::lock_guard alone(reporting_);
    progress_(what, done_++, all_);
  }

 private:
  const Progress& progress_;
  std::size_t all_, done_ = 0;
  std::mutex reporting_;
};

inline std::string label_of(const Case& one) { return one.scenario->name + " " + one.variant; }

}  // namespace plumb
