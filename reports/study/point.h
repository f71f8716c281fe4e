#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

namespace plumb {

/// What one point of a study says.
struct Row {
  nlohmann::ordered_json values = nlohmann::ordered_json::object();  // the same in every run
  nlohmann::ordered_json times = nlohmann::ordered_json::object();   // what hangs on the clock
};

/// One thing to find out. It is found out in a child process of its own, so that nothing a engine does, crash or
/// hang, ends more than this point.
struct Point {
  std::string key;           // unique in its study, and the same wherever that is run: "speed|bounce/e=0.8|box2d|..."
  std::function<Row()> run;  // what it throws is the point's outcome
  /// One repetition of what is timed, after `run` and in the same process; returns seconds, or what is not finite where
  /// `run` left nothing to time. Null where nothing ever is.
  std::function<double()> turn = nullptr;
  /// Points that follow each other and share a group that is not "" belong together: they stay in one shard, and those
  /// that are timed take turns, with nothing beside.
  std::string group = {};
  bool alone = false;  // nothing else may run beside it
  /// Called before the child is born, in the parent: what it leaves in memory, the child has too. Often called twice.
  std::function<void()> prepare = nullptr;
};

enum class Ending { done, failed, crashed, timed_out, out_of_memory };

/// "done", "failed", "crashed", "timed out", "out of memory".
const char* name_of(Ending);

struct PointResult {
  std::string key;
  Ending ending = Ending::done;
  std::string reason;  // why not done
  Row row;             // times: of turns, "median", "low" and "high" (quartiles) in s, "repetitions", "wide"
};

/// As a line of a results file.
std::string to_line(const PointResult&);

/// Throws std::invalid_argument for what to_line does not write.
PointResult from_line(const std::string& line);

}  // namespace plumb
