#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "reports/run/run.h"
#include "reports/timing/copy.h"
#include "reports/timing/machine.h"
#include "reports/timing/sample.h"

namespace plumb {

/// Two builds of Plumb that step the same scenes, in turns.
class SideBySide {
 public:
  /// Begins and ends both, to see that they can be compared. `engine` is what --engine takes. Throws
  /// std::invalid_argument, naming the program, where one cannot be run or does not step on request.
  SideBySide(std::filesystem::path before, std::filesystem::path now, const std::vector<Case>&, std::string engine,
             double dt);

  const TimingFacts& facts_before() const { return facts_before_; }
  const TimingFacts& facts_now() const { return facts_now_; }
  /// Why instructions are not counted; "" where both do.
  const std::string& uncounted() const { return uncounted_; }

  /// All cases, by index.
  std::vector<std::size_t> all() const;

  /// In each sitting all of those cases come up once, each in three new processes (see TimedPair) that take turns,
  /// another one beginning each time; of new copies of
  /// the programs, see ProgramCopy. A first run says how many steps fit into a twentieth of a second; all are timed
  /// over these. A program that refuses, ends or hangs leaves that case without a result. `progress` hears of each case
  /// of each sitting.
  std::vector<TimedPair> measure(std::span<const std::size_t> which, int sittings,
                                 const std::function<void(const std::string&)>& progress) const;

 private:
  struct Asked {
    std::string name;
    std::string scene;  // text of a scene file
    std::size_t steps;
  };

  struct Turns {
    std::size_t turns, runs, steps, chunk;
  };

  // New ones for each sitting.
  struct Programs {
    ProgramCopy before, now, again;
  };

  Turns plan(const Asked&) const;
  void sit(const Programs&, const Asked&, const Turns&, std::size_t first, TimedPair&) const;

  std::filesystem::path before_, now_;
  std::vector<Asked> cases_;
  std::string engine_;
  double dt_;
  TimingFacts facts_before_, facts_now_;
  std::string uncounted_;
};

}  // namespace plumb
