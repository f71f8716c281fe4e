#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reference/converged/converged.h"
#include "reports/find/complaint.h"
#include "reports/find/kind.h"
#include "reports/run/converged_checks.h"
#include "reports/run/relations.h"
#include "reports/run/run.h"

/// Judges an engine in a scene that nobody wrote expectations for.
namespace plumb {

/// The name of our engine as it is.
inline constexpr const char* ours = "impulse";

/// An engine that is searched for mistakes.
struct Suspect {
  std::string name;  // as it is given: "box2d", "impulse:solver=article", "fault:NAME", "closed-form:NAME"
  EngineConfig config;
  /// Set for a fault: what the right engine fails as well does not count.
  std::optional<EngineConfig> right = std::nullopt;
  /// Keep the engines of a fault, which no catalog holds.
  std::shared_ptr<const Engine> faulty = nullptr, sound = nullptr;
};

/// "NAME[:key=value,...]" is an engine, "fault:NAME" ours with a fault of `plumb prove`, "fault:all" with each of them
/// in turn, and "closed-form:NAME" or "closed-form:all" closed forms, in which any mistake is the judges'. Throws
/// std::invalid_argument, naming the nearest, for one that is not there.
std::vector<Suspect> parse_suspects(std::string_view word);

/// Whether it is a closed form, by its name: what it is found to break, judges mistake.
bool is_closed_form(std::string_view suspect);

/// Of several words; every engine as it is if there are none.
std::vector<Suspect> parse_suspects(const std::vector<std::string>& words);

/// s, the step of all runs of a search.
inline constexpr double search_step = 1.0 / 60;

/// What a scene is judged by. To find the same complaint again, only its own judge is needed.
struct Judges {
  bool places = true;     // where every body must be
  bool relations = true;  // of the scene's run and its images'
  std::string only = "";  // the only relation; "" for all

  /// Only laws, which need to know nothing.
  static Judges laws() { return {.places = false, .relations = false}; }
  /// Those that can have a complaint for this reason.
  static Judges of_reason(const std::string& reason);
};

/// What judges need to know of a scene, whatever engine runs it: where every body must be, from a closed form that
/// recognises the scene, or from refinement that a second engine confirms; and how differences grow.
class Known {
 public:
  /// The scene must outlive it. Nothing is known of scenes that are not well posed, and of those that would take more
  /// than a fraction of a second.
  Known(const Scene&, Posed, Judges = {});

  /// What this engine breaks, apart from laws.
  std::vector<Complaint> complaints(const EngineConfig&, const Trace&) const;

  /// Whether there is anything to judge by.
  bool empty() const { return !growth_ && !checks_; }

 private:
  std::vector<Complaint> misplaced(const Stepping&, const Trace&) const;

  Judges judges_;
  std::optional<SceneGrowth> growth_;
  std::string judge_;
  std::optional<ConvergedTruth> truth_;
  std::optional<ConvergedChecks> checks_;
};

/// A complaint of this judge about each check that fails, the worst of each reason.
std::vector<Complaint> complaints_of(const std::string& judge, std::span<const TruthCheck>);

/// Runs the scene once and judges it by the run's end and the invariants.
Opinion judged_by_laws(const Scene&, Posed, const EngineConfig&);

/// Runs the scene, which the engine runs to its end, and its images, and judges by what is known.
std::vector<Complaint> judged_by(const Known&, const Scene&, const EngineConfig&);

}  // namespace plumb
