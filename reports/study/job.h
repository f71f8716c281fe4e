#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The jobs of a study, what they return, the plan that lists them, and how it is divided among machines.
namespace plumb {

/// What a job found.
struct JobOutput {
  nlohmann::ordered_json values = nlohmann::ordered_json::object();  // the same in every run
  nlohmann::ordered_json times = nlohmann::ordered_json::object();   // everything that depends on the clock
};

/// One unit of work. It runs in a child process of its own, so an engine that crashes or hangs ends only this job.
struct Job {
  std::string key;                 // unique in its study and the same on every machine: "speed|bounce/e=0.8|box2d|..."
  std::function<JobOutput()> run;  // if it throws, the job has failed and the exception is the reason
  /// One timed repetition, called after `run` in the same process. Returns seconds, or a non-finite number if `run`
  /// left nothing to time. Null for jobs that are never timed.
  std::function<double()> repetition = nullptr;
  /// Consecutive jobs with the same non-empty group stay in one shard. If they are timed, their repetitions alternate
  /// and nothing else runs at the same time.
  std::string group = {};
  bool alone = false;  // nothing else may run at the same time
  /// Called in the parent before the child is forked: the child inherits what it leaves in memory. May be called more
  /// than once.
  std::function<void()> prepare = nullptr;
  /// Called in the child before `run`, with the seconds that this may take: for work that fits itself to them.
  std::function<void(double seconds)> within = nullptr;
};

enum class Ending { done, failed, crashed, timed_out, out_of_memory };

/// "done", "failed", "crashed", "timed out", "out of memory".
const char* name_of(Ending);

struct JobResult {
  std::string key;
  Ending ending = Ending::done;
  std::string reason;  // why it is not done
  /// Repetitions add to `times`: "median", "low" and "high" (quartiles) in s, "repetitions", "wide".
  JobOutput output;
};

/// A part of a key, counted from 0: those of "speed|bounce/e=0.8|box2d|..." are "speed", "bounce/e=0.8", "box2d". ""
/// where it has none.
std::string key_part(const std::string& key, int index);

/// One line of a results file.
std::string to_line(const JobResult&);

/// Throws std::invalid_argument for a line that to_line does not write.
JobResult from_line(const std::string& line);

/// A JSON number, or null if it is not finite.
nlohmann::ordered_json finite_or_null(double);

/// What all results of a study show together.
struct Findings {
  nlohmann::ordered_json findings = nlohmann::ordered_json::object();  // the same in every run
  nlohmann::ordered_json timings = nlohmann::ordered_json::object();   // everything that depends on the clock
  std::string text;                                                    // lines for the console
  bool failed = false;  // they show something that must not be: the study's exit code is 1
  /// Further files, as pairs of a path inside the study's folder and contents: the same in every run.
  std::vector<std::pair<std::string, std::string>> files = {};
};

struct StudyPlan {
  std::vector<Job> jobs;  // in the order in which they run and are shown
  /// Takes the results of all jobs, in the same order, and then those of the jobs that followed from them.
  std::function<Findings(const std::vector<JobResult>&)> conclude;
  /// Jobs that follow from the results of the others, in the order in which they run; null if there never are any. They
  /// run once all others have, after a merge if these were divided.
  std::function<std::vector<Job>(const std::vector<JobResult>&)> follow_up = nullptr;
};

/// Jobs that must stay together: a group, or a single job. In order.
std::vector<std::span<const Job>> units_of(std::span<const Job>);

/// Part k of n of a study; k counts from 1.
struct Shard {
  int k = 1, n = 1;

  bool whole() const { return n == 1; }
  std::string name() const;  // "2/4"
  bool operator==(const Shard&) const = default;
};

/// Reads "k/n". Throws std::invalid_argument if the text is not of that form.
Shard parse_shard(std::string_view text);

/// Returns the value of an environment variable, or null.
using EnvironmentLookup = std::function<const char*(const char* name)>;

/// The shard that belongs to this task of a Slurm array; nullopt outside of one. Throws std::invalid_argument for an
/// array with gaps: its tasks do not know their index.
std::optional<Shard> slurm_shard(const EnvironmentLookup&);

/// The units of jobs that belong to a shard: every n-th, so that expensive and cheap ones are spread.
std::vector<std::span<const Job>> units_in(const Shard&, const std::vector<std::span<const Job>>& units);

/// The engines that a study's tables lack: for each that failed in some of its jobs, or whose jobs crashed or exceeded
/// their limits: in how many of how many, and in which first, and why. `why` says why the engine failed in a job that
/// is done, "" if it did not. A key is "STUDY|WHAT|ENGINE|...".
nlohmann::ordered_json failures_of(const std::vector<JobResult>&,
                                   const std::function<std::string(const JobResult&)>& why);

/// The same in words, a line each; "" if none failed.
std::string failures_text(const nlohmann::ordered_json& failures);

}  // namespace plumb
