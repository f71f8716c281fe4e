#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "reports/system/environment.h"
#include "reports/timing/clock.h"

/// A timing worker is a process that steps scenes on request, so that two builds of Plumb can be timed side by side. It
/// reads and writes one line of JSON at a time, and begins with {"pace": version, "facts": TimingFacts, "uncounted":
/// why instructions are not counted, or ""}. The requests and their answers:
///
///   {"scene": text of a scene file, "engine": as for --engine, "dt": s}   -> {} once it can be stepped
///   {"runs": n, "steps": n, "chunk": n, "patience": s}                    -> {"cpu": [s], "wall": [s], "count": n}
///   anything that cannot be done                                          -> {"refused": why}
///
/// A repetition is `runs` runs from the initial state, each of the same number of steps. The times are those of one
/// run, by chunks of `chunk` steps: for each chunk the median over all runs. The first run ends at the end of a chunk
/// once its steps have taken `patience`; the other runs then have the same length. "count" is the number of
/// instructions of a run, or null if they are not counted. Older builds must be able to answer, so keys only change
/// with the version.
namespace plumb {

constexpr int worker_version = 1;

/// Reads a scene and gives what builds a simulation of it by an engine, as --engine names it. Throws std::exception if
/// the engine cannot simulate the scene.
using SimulationReader = std::function<FreshSimulation(const std::string& scene, const std::string& engine)>;

/// Answers requests until there are no more.
void serve_timing(std::istream&, std::ostream&, const SimulationReader&);

/// A timing worker in a new process.
class TimingWorker {
 public:
  /// `patience`, in s, applies to each answer. Throws std::invalid_argument, naming the program, if it cannot be run or
  /// is no timing worker.
  explicit TimingWorker(std::filesystem::path program, double patience = 60);
  TimingWorker(const TimingWorker&) = delete;
  TimingWorker& operator=(const TimingWorker&) = delete;
  ~TimingWorker();

  const TimingFacts& facts() const { return facts_; }
  /// Why it counts no instructions; "" if it does.
  const std::string& uncounted() const { return uncounted_; }

  /// Throws std::runtime_error, naming the program, if it ends, loses patience, or its answer is not a JSON object.
  nlohmann::ordered_json ask(const nlohmann::ordered_json& request);

 private:
  void start(const char* command);
  void read_greeting();
  void end();
  std::string read_line();
  [[noreturn]] void fail(const std::string& what) const;

  std::filesystem::path program_;
  double patience_;  // s
  pid_t process_ = 0;
  int socket_ = -1;
  std::string received_;  // after the last line
  TimingFacts facts_;
  std::string uncounted_;
};

/// The path of the running program.
std::filesystem::path own_program();

}  // namespace plumb
