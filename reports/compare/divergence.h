#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reports/trace.h"
#include "scenarios/scenario.h"

/// When and why two runs of one scene diverge: by more than round-off explains, and as far as contacts show it.
namespace plumb {

/// How far two runs may differ and still count as equal.
struct StateTolerance {
  double position = 0;  // m, also of contact points and separations
  double angle = 0;     // rad, also of normals
  double velocity = 0;  // m/s
  double spin = 0;      // rad/s
  double impulse = 0;   // N s
};

/// The same number for every quantity, in its own unit; the impulse is what gives the lightest body that velocity.
StateTolerance uniform_tolerance(double tolerance, const Scene&);

/// The differences that round-off explains, from what two runs state of their arithmetic and the largest numbers so
/// far. The scene must outlive it.
class RoundOffTolerance {
 public:
  RoundOffTolerance(const Scene&, const Stepping& a, const Stepping& b);

  /// The tolerance at a time, s, from the states of both runs then and at all earlier calls. Call it moment by moment.
  StateTolerance at(double time, std::span<const BodyState> a, std::span<const BodyState> b);

 private:
  void include(std::span<const BodyState>);

  const Scene& scene_;
  Stepping a_, b_;
  double mass_ = 0;                                  // kg, of all dynamic bodies
  double smallest_radius_ = 1, largest_radius_ = 0;  // m, of gyration
  // The largest so far: m, rad, m/s, rad/s.
  double position_ = 0, angle_ = 0, speed_ = 0, spin_ = 0;
};

/// The part of a step in which two runs first differ.
enum class Stage {
  start,        // before the first step
  integration,  // nothing touches the body in either run
  event_time,   // one run has an impact that the other has some steps later, or at another moment of the step
  contact_set,  // two bodies touch in one run only
  manifold,     // the same bodies touch, at other points, normals or separations
  impulse,      // the same contacts have other impulses
  not_reported  // the reported contacts do not explain it
};

/// "start", "integration", "event time", "contact set", "manifold", "impulse", "not reported".
const char* name_of(Stage);

/// One of the two runs that are compared, and what its engine states of its stepping. The trace must outlive it.
struct ComparedRun {
  std::string name;
  const Trace* trace = nullptr;
  Stepping stepping;
};

/// One quantity in both runs.
struct ValueDifference {
  std::string what;  // "y of box"
  std::string unit;
  std::optional<double> a, b;  // nullopt if that run does not report it
  double difference = 0;       // |a - b|
  double tolerance = 0;        // up to which they count as equal
};

struct ContactCause {
  Stage stage = Stage::integration;
  std::string other;  // the body at the contact that explains the divergence; "" if none does
  std::vector<ValueDifference> values;
  std::string advice;  // a sentence or two: where to look
};

/// Finds the first difference in the contacts that reach a body in a step (from 1), directly or through other bodies.
/// It goes through them in the order of a step: which bodies touch, where, and with what impulses. The states before
/// the step count as equal; `tolerance` is that of the step.
ContactCause find_contact_cause(const Scene&, const ComparedRun& a, const ComparedRun& b, std::size_t step,
                                std::size_t body, const StateTolerance& tolerance);

/// A moment at which the difference has grown by a factor since the divergence.
struct DivergenceGrowth {
  double factor = 1;
  std::size_t step = 0;
  double time = 0;        // s
  double difference = 0;  // the largest of all bodies, in the unit of the first difference
};

struct Divergence {
  std::size_t step = 0;  // 0 is the start
  double time = 0;       // s
  Stage stage = Stage::integration;
  std::string body;                      // with the largest error ratio
  std::string other;                     // the body at the contact that explains it; "" if none does
  ValueDifference first;                 // of the body's state
  std::vector<ValueDifference> values;   // the body's state and the contact that explains the divergence
  std::string advice;                    // a sentence or two: where to look
  std::vector<DivergenceGrowth> growth;  // at 1, 10, 100 ... times as far as it went, and at the end
};

struct TraceComparison {
  std::size_t steps = 0;    // that both have
  double until = 0;         // s
  ValueDifference largest;  // without divergence: the difference with the largest error ratio
  std::optional<Divergence> divergence;
};

/// Finds the first step after which any body's state differs by more than `tolerance` (the same number in m, rad, m/s
/// and rad/s) or, without one, by more than round-off explains. If one run ends early, so does the comparison. Throws
/// std::invalid_argument unless both runs are of that scene with the same time step.
TraceComparison compare_traces(const Scene&, const ComparedRun& a, const ComparedRun& b,
                               std::optional<double> tolerance);

}  // namespace plumb
