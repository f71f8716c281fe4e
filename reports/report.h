#pragma once

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "reports/trace.h"
#include "scenarios/scenario.h"

/// Everything a report says, ready to be written; writers look at nothing else.
namespace plumb {

enum class Status { ok, failed, not_supported };

/// right: within what is allowed of the truth, no invariant broken. plausible: no truth to judge it by, and no
/// invariant broken. wrong: what physics forbids, beyond what the order of the method predicts.
enum class Verdict { right, plausible, wrong, beyond_horizon, not_supported, failed };

struct Measured {
  double value = 0;
  std::string unit;
};

/// Errors of one check over runs whose steps fall differently, in its unit.
struct Spread {
  double min = 0, median = 0, max = 0;
  int phases = 0;
};

struct TruthCheck {
  std::string body;
  std::string quantity;
  std::string unit;
  double time = 0;                                              // s
  Relation relation = Relation::equal;                          // of measured to expected
  double expected = 0, measured = 0, error = 0, tolerance = 0;  // error: by how much the relation is missed, >= 0
  bool passed = false;
  bool reported = true;  // false where the engine does not show what was asked for: neither passed nor failed
  std::string source;
  std::optional<Spread> spread = std::nullopt;  // over the phases, where there are several; the rest is of the worst
};

/// held: within what is allowed. not_reported: the engine does not show what would tell; never a pass.
enum class CheckStatus { held, broken, not_reported };

/// How an invariant fared over a run: where it was missed most, against what is allowed there.
struct InvariantCheck {
  std::string name;
  std::string unit;
  CheckStatus status = CheckStatus::held;
  double value = 0, tolerance = 0;
  double ratio = 0;   // value / tolerance; infinite where nothing is allowed
  double time = 0;    // s
  std::string where;  // body, or "a - b"; "" for the whole scene
};

struct RunRecord {
  std::string scenario;
  std::string variant;
  Parameters parameters;
  std::string engine;
  std::string method;  // settings that tell methods of one engine apart, "key=value,..."; "" where there is one only
  bool exact = false;  // a closed form
  double dt = 0;
  Status status = Status::ok;
  std::string reason;
  std::map<std::string, Measured> metrics;
  std::vector<TruthCheck> truth;
  std::vector<InvariantCheck> invariants;  // those that apply
  Verdict verdict = Verdict::plausible;
  std::shared_ptr<const Scene> scene;  // for pictures; not part of report.json
  std::shared_ptr<const Trace> trace;  // the same
};

/// One engine against another, or against the truth, over one scenario.
struct Comparison {
  std::string scenario;
  std::string variant;
  std::string a, b;                         // engine (with method where needed)
  std::map<std::string, Measured> metrics;  // differences over time and at the end
  Verdict verdict = Verdict::plausible;
  std::string reason;
};

struct Timing {
  std::string scenario;
  std::string variant;
  std::string engine;
  std::string method;
  double step_us = 0;           // median over repetitions of the mean time of a step
  double step_us_low = 0;       // lower quartile
  double step_us_high = 0;      // upper quartile
  double real_time_factor = 0;  // simulated seconds per second
  int repetitions = 0;
};

/// What readers of a report need to know of the names in it.
struct ScenarioNote {
  std::string name;
  std::string question;
  std::string closed_form;  // "" where physics has none
  std::vector<Parameter> parameters;
};

struct EngineNote {
  std::string name;
  std::string about;
  std::string source;
  bool exact = false;
};

struct MetricNote {
  std::string name;
  std::string unit;
  std::string definition;
  std::string better;  // "lower", "higher", "neither"
};

struct InvariantNote {
  std::string name;
  std::string unit;
  std::string definition;
};

struct Report {
  std::string title;
  std::vector<std::string> command;                // that made it
  std::map<std::string, std::string> environment;  // compiler, flags, build, versions, processor: no clock
  std::vector<ScenarioNote> scenarios;
  std::vector<EngineNote> engines;
  std::vector<MetricNote> metrics;
  std::vector<InvariantNote> invariants;
  std::vector<RunRecord> runs;
  std::vector<Comparison> comparisons;
  std::vector<Timing> timings;
  std::vector<nlohmann::ordered_json> studies;  // short forms, each a study's document; for the page alone
  std::map<std::string, double> clock;  // wall seconds of the parts, share outside step: with the timings, apart
};

/// "ok", "failed", "not supported".
const char* name_of(Status);

/// "right", "plausible", "wrong", "beyond horizon", "not supported", "failed".
const char* name_of(Verdict);

/// "held", "broken", "not reported".
const char* name_of(CheckStatus);

/// How many times what is allowed a run is off where it is worst, by truth or invariant; nothing where nothing judged
/// it.
std::optional<double> times_allowed(const RunRecord&);

/// "engine" or "engine:key=value,...", as --engine takes it.
std::string label_of(const std::string& engine, const std::string& method);

}  // namespace plumb
