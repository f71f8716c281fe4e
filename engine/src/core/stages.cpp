#include "core/stages.h"

#ifdef IMPULSE_STAGES

#include <chrono>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <vector>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

using Clock = std::chrono::steady_clock;

class Stages {
 public:
  Stages() = default;
  Stages(const Stages&) = delete;
  Stages& operator=(const Stages&) = delete;
  ~Stages() {
    if (steps_ == 0) return;
    std::cerr << "Stages, us per step over " << steps_ << " steps:\n" << std::fixed << std::setprecision(2);
    for (const Stage& stage : stages_) {
      std::cerr << std::setw(12) << stage.time.count() / static_cast<double>(steps_) << "  " << stage.name << '\n';
    }
  }

  void start() {
    ++steps_;
    next_ = 0;
    last_ = Clock::now();
  }
  void end(const char* name) {
    const Clock::time_point now = Clock::now();
    of(name).time += now - last_;
    last_ = Clock::now();  // don't count the lookup
  }

 private:
  struct Stage {
    const char* name;
    std::chrono::duration<double, std::micro> time;
  };

  /// Finds a stage by name. Stages come in nearly the same order in every step, so the search starts after the last.
  Stage& of(const char* name) {
    for (std::size_t i = 0; i < stages_.size(); ++i) {
      Stage& stage = stages_[(next_ + i) % stages_.size()];
      if (stage.name != name) continue;
      next_ += i + 1;
      return stage;
    }
    return stages_.emplace_back(Stage{name, {}});
  }

  std::vector<Stage> stages_;
  std::size_t steps_ = 0;
  std::size_t next_ = 0;
  Clock::time_point last_;
};

thread_local Stages stages;

}  // namespace

void start_stages() { stages.start(); }
void end_stage(const char* name) { stages.end(name); }

}  // namespace impulse::inline IMPULSE_PRECISION

#endif
