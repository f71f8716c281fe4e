#pragma once

#include <compare>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reports/report.h"

/// What a history keeps of a report.
namespace plumb {

class JsonReader;

/// Who answered what.
struct Subject {
  std::string scenario, variant;
  std::string engine;  // see label_of
  double dt = 0;       // s

  auto operator<=>(const Subject&) const = default;
};

struct StepTime {
  double median = 0, low = 0, high = 0;  // us, with quartiles
  int repetitions = 0;
};

struct Answered {
  std::string verdict;
  std::map<std::string, Measured> metrics;  // NaN: not finite
  std::optional<StepTime> time;
};

struct Snapshot {
  std::string commit;
  std::string at;  // see utc
  std::vector<std::string> command;
  std::map<std::string, std::string> environment;
  std::map<Subject, Answered> answers;
};

/// A line of JSON without its break: the same for the same content, numbers to the bit.
std::string to_line(const Snapshot&);

/// Reads it back. Throws std::invalid_argument, naming `name` and the place, for what is no such line.
Snapshot snapshot_of_line(const std::string& line, const std::string& name);

/// A hash of that line: two snapshots are the same where theirs are.
std::string id_of(const Snapshot&);

/// Of the text of a report.json, see report.schema.json. Beside the metrics of its runs, `share_of_allowed` is how many
/// times what is allowed a run is off where it is worst. Throws std::invalid_argument, naming `name` and the place, for
/// what is none.
Snapshot snapshot_of_report(const std::string& text, const std::string& name);

/// A list of texts.
std::vector<std::string> words_from(const JsonReader&);

}  // namespace plumb
