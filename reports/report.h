#pragma once

#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "reference/simulation.h"
#include "reports/trace.h"
#include "scenarios/scenario.h"

/// The contents of a report: runs, checks, comparisons and timings. Writers see nothing else.
namespace plumb {

enum class Status { ok, failed, not_supported };

/// right: every check explained by the method and within 1 % of its scale, and the checks have power. coarse:
/// explained, but farther off than that, as the method must be at this step. wrong: not explained, or an invariant
/// broken. plausible: no truth to judge by, and invariants that could have been broken held. no_evidence: nothing that
/// was checked could have failed.
enum class Verdict { right, coarse, wrong, plausible, no_evidence, beyond_horizon, not_supported, failed };

/// The state of a check. held: within its tolerance. not_reported: the engine does not report what the check needs.
/// not_applicable: nothing in the run asks the question, such as a law of contacts where nothing touches. The last two
/// are never a pass.
enum class CheckStatus { held, broken, not_reported, not_applicable };

/// "ok", "failed", "not supported".
const char* name_of(Status);

/// "right", "coarse", "wrong", "plausible", "no evidence", "beyond horizon", "not supported", "failed".
const char* name_of(Verdict);

/// "held", "broken", "not reported", "not applicable".
const char* name_of(CheckStatus);

/// error / tolerance: 0 where the error is 0 or negative, infinity where the tolerance is 0 or either is not finite.
double error_ratio(double error, double tolerance);

struct Measured {
  double value = 0;
  std::string unit;
};

/// The errors of one check over runs with shifted steps, in the check's unit.
struct Spread {
  double min = 0, median = 0, max = 0;
  int phases = 0;
};

/// One reading of a run against its expected value.
struct TruthCheck {
  std::string body;
  std::string quantity;
  std::string unit;
  double time = 0;                                              // s
  Relation relation = Relation::equal;                          // of measured to expected
  double expected = 0, measured = 0, error = 0, tolerance = 0;  // error: by how much the relation is missed, >= 0
  /// What the truth says changes, by which errors of all engines are measured; see judge/scale.h. 0: not known.
  double scale = 0;
  double chance = 0;  // what of the error is a sample's, not the engine's
  bool passed = false;
  bool reported = true;  // false if the engine does not report the quantity: neither passed nor failed
  bool idle = false;     // whether nothing is asked: bodies move, and it would pass if all of them stayed at the start;
                         // its body is not dynamic; or is yet to touch something, which it will by a reference
  bool converged = false;  // by a converged reference
  std::string source;
  std::optional<Spread> spread = std::nullopt;  // over all phases, if there are several; the rest is the worst phase's
};

/// An invariant over a run, where its error is largest against its tolerance.
struct InvariantCheck {
  std::string name;
  std::string unit;
  CheckStatus status = CheckStatus::held;
  double value = 0, tolerance = 0;
  double ratio = 0;         // error_ratio(value, tolerance)
  double scale = 0;         // what an engine without the law would show, in the same unit; 0: nothing tested it
  double time = 0;          // s
  std::string where;        // body, or "a - b"; "" for the whole scene
  int phases = 1;           // runs with shifted steps, of which it is the worst
  std::string detail = {};  // of a metamorphic relation: what was compared, and why that much may differ
};

struct RunRecord {
  std::string scenario;
  std::string variant;
  Parameters parameters;
  std::string engine;
  std::string method;      // settings that differ from the engine's defaults, "key=value,..."; "" for the defaults
  bool exact = false;      // a closed form, or a converged reference
  bool converged = false;  // judged by a converged reference, or it is one
  double dt = 0;
  Status status = Status::ok;
  std::string reason;
  std::map<std::string, Measured> metrics;
  std::vector<TruthCheck> truth;
  std::vector<InvariantCheck> invariants;  // those that apply to the scene
  Verdict verdict = Verdict::plausible;
  std::shared_ptr<const Scene> scene;  // for pictures; not part of report.json
  std::shared_ptr<const Trace> trace;  // the same
};

/// A check is evidence only if it can fail: if its tolerance is below this share of its scale.
inline constexpr double evidence_share = 0.05;
/// The share of its scale within which a check is right.
inline constexpr double right_share = 0.01;

/// error / scale, the same ruler for every engine, without what chance explains; infinite where either is not finite or
/// the scale is 0.
double relative_error(const TruthCheck&);
/// Whether the check was reported and its tolerance is small enough to fail a wrong engine.
bool is_evidence(const TruthCheck&);
/// Whether the invariant was held or broken.
bool is_judged(const InvariantCheck&);
/// Whether the invariant was tested: something happened by which a wrong engine would have broken it.
bool is_evidence(const InvariantCheck&);

/// What of a run is not a test, and the share of its scale that is allowed: its reported checks that are no evidence,
/// and its invariants whose tolerance is too large for what an engine without the law would have shown. Where that is
/// nothing, the run never met the law.
struct NotATest {
  std::string what;  // "y of box at 2 s", "energy"
  double share = 0;
};
std::vector<NotATest> not_tests(const std::vector<TruthCheck>&);
std::vector<NotATest> not_tests(const RunRecord&);

/// The largest relative_error of a run's reported checks; nullopt if there is none.
std::optional<double> worst_relative_error(const RunRecord&);

/// The largest error_ratio of a run's checks; nullopt if no check could judge it.
std::optional<double> worst_error_ratio(const RunRecord&);

/// "engine" or "engine:key=value,...", as --engine takes it.
std::string label_of(const std::string& engine, const std::string& method);

/// " (WebAssembly)": what follows an engine's name where its times are shown, by the name of how its code runs; "" for
/// native code, " (program)" where it is not stated.
std::string execution_mark(const std::string& execution);

/// A difference over time relative to a scale of the scene.
struct RelativeDifference {
  double largest = 0, end = 0;
};

/// The first things to know of two runs of a case: how far apart they are in energy and momentum, whether both came to
/// rest, how deep bodies overlapped in each, and when the two first diverged.
struct KeyDifferences {
  RelativeDifference energy, momentum, angular_momentum;
  double energy_scale = 0;                     // J; the scales depend on the scene alone, see judge/scale.h
  double momentum_scale = 0;                   // kg m/s
  double angular_momentum_scale = 0;           // kg m^2/s
  std::optional<double> rest_a, rest_b;        // s, since when all bodies are at rest; nullopt if one moves at the end
  std::optional<double> overlap_a, overlap_b;  // m, the deepest; nullopt if there are no two bodies
  std::optional<double> diverged_at;           // s, when the bodies were first `diverged_by` apart; nullopt: never
};

/// m, RMS over the bodies: a hundredth of a body of a metre.
inline constexpr double diverged_by = 0.01;

/// "both", "one" or "none": of the two runs, which came to rest.
const char* resting(const KeyDifferences&);

/// Two engines, or an engine and the truth, over one scenario.
struct Comparison {
  std::string scenario;
  std::string variant;
  std::string a, b;                                  // labels, see label_of
  std::optional<KeyDifferences> key = std::nullopt;  // if both runs reached their end
  std::map<std::string, Measured> metrics;           // differences over time and at the end
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

/// The notes explain the names in a report to its readers.
struct ScenarioNote {
  std::string name;
  std::string question;
  std::vector<Parameter> parameters;
  std::string group = {};  // "friction"; "" for a scene file
};

/// What the scenarios of a group ask about.
struct GroupNote {
  std::string name;   // "chaos"
  std::string title;  // "chaos and statistics"
  std::string stake;  // what goes wrong if an engine fails here
};

/// What an engine says about how it steps, in words: tolerances rest on it.
struct SteppingNote {
  std::string method;
  std::string text;
};

struct EngineNote {
  std::string name;
  std::string about;
  std::string source;
  std::string word = {};  // how a command line names it, if not by its name
  std::string language = {};
  ExecutionKind execution = ExecutionKind::native;  // how its code runs, which its times depend on
  bool exact = false;
  std::vector<std::string> caveats = {};  // what it does differently from what a scene means
  std::vector<SteppingNote> states = {};  // one a method
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
  std::map<std::string, std::string> environment;  // compiler, flags, build, versions, processor; nothing that varies
  std::vector<ScenarioNote> scenarios;
  std::vector<GroupNote> groups;  // of the scenarios
  std::vector<EngineNote> engines;
  std::vector<MetricNote> metrics;
  std::vector<InvariantNote> invariants;
  std::vector<RunRecord> runs;
  std::vector<Comparison> comparisons;
  std::vector<Timing> timings;
  std::vector<std::shared_ptr<const nlohmann::ordered_json>> studies;  // each a study's short document; for the page
  std::map<std::string, double> clock;  // wall times of the parts, s, and the share outside `step`
};

/// The name of a metamorphic relation among a run's invariants and metrics is this and its own.
inline const std::string relation_prefix = "relation_";

}  // namespace plumb
