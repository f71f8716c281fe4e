#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "reports/system/environment.h"
#include "reports/timing/paired.h"

namespace plumb {

/// A program copied to a temporary folder, which is removed in the end. How a file happens to lie in memory, page by
/// page, after a linker or a copy wrote it changes the time of a step by up to 5 %, even for the same program. Copies
/// that were all made in the same way differ only by chance. Copies that a killed process left are removed when the
/// next one is made.
class ProgramCopy {
 public:
  /// Throws std::invalid_argument, naming the program, if it cannot be copied.
  explicit ProgramCopy(const std::filesystem::path& program);
  ProgramCopy(const ProgramCopy&) = delete;
  ProgramCopy& operator=(const ProgramCopy&) = delete;
  ~ProgramCopy();

  const std::filesystem::path& path() const { return path_; }

 private:
  void remove() const;

  std::filesystem::path folder_, path_;
  int lock_ = -1;  // on the folder, while this exists
};

/// A scene to be timed in two programs.
struct TimedScene {
  std::string name;
  std::string scene;      // text of a scene file
  std::size_t steps = 0;  // to its end
};

/// Two builds of Plumb that step the same scenes alternately.
class SideBySide {
 public:
  /// Starts both programs once, to see whether they can be compared. `engine` is as for --engine. Throws
  /// std::invalid_argument, naming the program, if one cannot be run or is no timing worker.
  SideBySide(std::filesystem::path before, std::filesystem::path now, std::vector<TimedScene>, std::string engine,
             double dt);

  const TimingFacts& facts_before() const { return facts_before_; }
  const TimingFacts& facts_now() const { return facts_now_; }
  /// Why instructions are not counted; "" if both programs count them.
  const std::string& uncounted() const { return uncounted_; }

  /// Times the scenes with these indices. Each round makes new copies of the programs and times every scene once, in
  /// three new processes (see TimedPair) that take repetitions alternately. A first run finds how many steps fit into a
  /// twentieth of a second; all timings are of these steps. If a program refuses, ends or hangs, the scene has no
  /// result. `progress` is called with the name of each scene in each round.
  std::vector<TimedPair> measure(std::span<const std::size_t> which, int rounds,
                                 const std::function<void(const std::string&)>& progress) const;

 private:
  // How a scene is timed in a round.
  struct Schedule {
    std::size_t repetitions, runs, steps, chunk;
  };

  // New ones for each round.
  struct Programs {
    ProgramCopy before, now, again;
  };

  Schedule schedule(const TimedScene&) const;
  void time_round(const Programs&, const TimedScene&, const Schedule&, std::size_t first, TimedPair&) const;

  std::filesystem::path before_, now_;
  std::vector<TimedScene> scenes_;
  std::string engine_;
  double dt_;
  TimingFacts facts_before_, facts_now_;
  std::string uncounted_;
};

}  // namespace plumb
