// The study of speed against accuracy: every engine and method over a range of time steps and of its parameter steps,
// the values of the option that makes it work harder.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include "reports/report.h"
#include "reports/run/case_run.h"
#include "reports/run/selection.h"
#include "reports/run/timings.h"
#include "reports/study/job.h"
#include "reports/study/reference_solution.h"
#include "reports/study/speed/work_precision.h"
#include "reports/study/study.h"
#include "reports/system/command_options.h"
#include "reports/system/terminal.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

struct SpeedOptions {
  std::vector<std::string> scenarios;
  bool all = false;
  std::vector<std::string> engines;
  std::vector<std::string> steps{"1/30", "1/60", "1/120", "1/240", "1/480", "1/960"};
};

// An engine's method with one value of the option that makes it work harder.
struct ParameterStep {
  EngineConfig config;
  std::string method;  // without the option
  std::string option, value;
  bool standard = false;  // the value is the default
};

// s of a scene, from its start, that are timed: the same for all engines. Scenes with many bodies are timed for less,
// but long enough to see more than the start; otherwise the finest steps with all their repetitions would take hours.
double timed_seconds(const Scene& scene) {
  constexpr double body_seconds = 20;
  constexpr double least = 1;
  const auto bodies = std::count_if(scene.bodies.begin(), scene.bodies.end(),
                                    [](const Body& body) { return body.type == BodyType::dynamic; });
  return std::min(scene.duration,
                  std::max(least, body_seconds / static_cast<double>(std::max<std::ptrdiff_t>(bodies, 1))));
}

std::vector<ParameterStep> parameter_steps_of(const Json& configuration) {
  std::vector<ParameterStep> all;
  for (const auto& [config, ladder] : select_methods(configuration.at("engines"))) {
    if (ladder.option.empty()) {
      all.push_back({config, config.method(), "", "", true});
      continue;
    }
    const Settings defaults = complete(*config.engine, {});
    for (const std::string& value : ladder.values) {
      Settings settings = config.settings;
      settings[ladder.option] = value;
      all.push_back({{config.engine, complete(*config.engine, settings)},
                     config.method(),
                     ladder.option,
                     value,
                     value == defaults.at(ladder.option)});
    }
  }
  return all;
}

std::vector<Case> cases_of(const std::vector<std::string>& words, bool all) {
  return select_cases(words, all, {"pyramid"});
}

// The order that the engine states for such a case; 0 if none.
int stated_order(const Case& problem, const Stepping& stepping) {
  const auto& smoothness = problem.scenario->smoothness;
  switch (smoothness ? smoothness(problem.parameters) : Smoothness::none) {
    case Smoothness::none:
      return 0;
    case Smoothness::free:
      return stepping.order;
    case Smoothness::sliding:
      return stepping.order_in_contact;
  }
  return 0;
}

// The error and the cost of a method at one time step. If impacts fall somewhere between two steps, the error is taken
// over several phases of the step, so that no method is lucky.
class SpeedRun {
 public:
  SpeedRun(std::shared_ptr<const Case> problem, std::shared_ptr<const ReferenceSolution> reference, ParameterStep step,
           double dt)
      : problem_(std::move(problem)), reference_(std::move(reference)), step_(std::move(step)), dt_(dt) {}

  JobOutput output() {
    JobOutput output;
    Json& values = output.values;
    const EngineConfig& config = step_.config;
    std::string why_not;
    const auto stepping = stepping_of(config, dt_, why_not);
    values = {{"scenario", problem_->scenario->name},
              {"variant", problem_->variant},
              {"engine", config.engine->name},
              {"execution", name_of(config.engine->execution)},
              {"method", step_.method},
              {"option", step_.option},
              {"setting", step_.value},
              {"standard", step_.standard},
              {"dt", dt_},
              {"steps", steps_in(problem_->scene->duration, dt_)},
              {"timed", timed_seconds(*problem_->scene)},
              {"order", stepping ? stated_order(*problem_, *stepping) : 0},
              {"truth", reference_->engine() == nullptr ? "" : reference_->engine()->name},
              {"truth_until", 0.0},
              {"truth_error", 0.0},
              {"scale", 0.0}};
    if (reference_->engine() == nullptr) {
      values["status"] = "no truth";
      values["why"] = reference_->reason();
      return output;
    }
    values["truth_until"] = std::min(reference_->until(), problem_->scene->duration);
    values["truth_error"] = reference_->error();
    values["scale"] = reference_->scale();
    if (stepping) {
      measure_error(values, *stepping);
    } else {
      values["status"] = name_of(Status::failed);
      values["why"] = why_not;
    }
    able_ = values.contains("error");
    return output;
  }

  // s per simulated second; NaN for a method that did not run to the end.
  double cost() const {
    if (!able_) return std::numeric_limits<double>::quiet_NaN();
    Scene scene = *problem_->scene;
    scene.duration = timed_seconds(scene);
    return step_cost(scene, step_.config, dt_);
  }

 private:
  void measure_error(Json& values, const Stepping& stepping) const {
    double squares = 0;
    double least = std::numeric_limits<double>::infinity();
    double largest = 0;
    const std::vector<Case> all = phases(*problem_, problem_->scenario->phased ? judged_phases : 1);
    for (const Case& phase : all) {
      const Outcome outcome = run(*phase.scene, step_.config, dt_, phase.first_step);
      values["status"] = name_of(outcome.status);
      values["why"] = outcome.reason;
      if (outcome.status != Status::ok) return;
      const double error = reference_->error_of(*outcome.trace, dt_, phase.first_step);
      squares += error * error;
      least = std::min(least, error);
      largest = std::max(largest, error);
    }
    values["phases"] = all.size();
    values["error"] = std::sqrt(squares / static_cast<double>(all.size()));
    values["error_least"] = least;
    values["error_largest"] = largest;
    values["round_off"] = reference_->round_off(stepping);
  }

  std::shared_ptr<const Case> problem_;
  std::shared_ptr<const ReferenceSolution> reference_;
  ParameterStep step_;
  double dt_;
  bool able_ = false;
};

std::vector<Job> jobs_of(const Json& configuration) {
  std::vector<double> time_steps;
  for (const std::string text : configuration.at("dt")) time_steps.push_back(parse_dt(text));
  const std::vector<ParameterStep> parameter_steps = parameter_steps_of(configuration);
  const double finest = *std::min_element(time_steps.begin(), time_steps.end());
  std::vector<Job> jobs;
  for (Case& one : cases_of(configuration.at("scenarios"), configuration.at("all"))) {
    const auto problem = std::make_shared<const Case>(std::move(one));
    const auto reference = std::make_shared<ReferenceSolution>(*problem, finest);
    const std::string case_name = problem->scenario->name + "/" + problem->variant;
    for (std::size_t i = 0; i < time_steps.size(); ++i) {
      const std::string dt = configuration.at("dt")[i];
      for (const ParameterStep& step : parameter_steps) {
        const auto speed_run = std::make_shared<SpeedRun>(problem, reference, step, time_steps[i]);
        const std::string setting = step.option.empty() ? "" : "|" + step.option + "=" + step.value;
        jobs.push_back({.key = fmt::format("speed|{}|{}{}|dt={}", case_name,
                                           label_of(step.config.engine->name, step.method), setting, dt),
                        .run = [speed_run] { return speed_run->output(); },
                        .repetition = [speed_run] { return speed_run->cost(); },
                        .group = case_name + "|" + dt,
                        .prepare = [reference] { reference->find(); }});
      }
    }
  }
  return jobs;
}

Json configuration_of(const SpeedOptions& options) {
  std::vector<std::string> steps = options.steps;
  std::stable_sort(steps.begin(), steps.end(), [](const auto& a, const auto& b) { return parse_dt(a) > parse_dt(b); });
  Json configuration{{"scenarios", options.scenarios},
                     {"all", options.all},
                     {"engines", options.engines},
                     {"dt", steps},
                     {"scenes", hash_of(cases_of(options.scenarios, options.all))}};
  require_distinct_keys(jobs_of(configuration));
  return configuration;
}

std::string orders_text(const Json& orders) {
  std::map<std::string, int> counts;
  for (const Json& order : orders) {
    if (order.at("stated").is_number()) ++counts[order.at("finding")];
  }
  if (counts.empty()) return "";
  std::string text = "Stated orders of convergence:";
  for (const auto& [finding, count] : counts)
    text += fmt::format("{} {} {}", &finding == &counts.begin()->first ? "" : ",", count, finding);
  text += ".\n";
  for (const Json& order : orders) {
    if (order.at("finding") != "not as stated") continue;
    text += fmt::format("  {} {}: {} {}{}{}: measured {:.2f} +- {:.2f}, stated {}\n",
                        order.at("scenario").get<std::string>(), order.at("variant").get<std::string>(),
                        order.at("engine").get<std::string>(), order.at("option").get<std::string>(),
                        order.at("option").empty() ? "" : "=", order.at("setting").get<std::string>(),
                        order.at("order").get<double>(), order.at("half_width").get<double>(),
                        order.at("stated").get<int>());
  }
  return text;
}

Findings conclude(const std::vector<JobResult>& results) {
  Findings found;
  const Json orders = orders_of(results);
  const Json failures = failures_of(results, [](const JobResult& one) -> std::string {
    const Json& values = one.output.values;
    return values.at("status") == name_of(Status::failed) ? values.at("why") : "";
  });
  found.findings = {{"order_tolerance", order_tolerance}, {"orders", orders}, {"failures", failures}};
  found.timings = work_precision_of(results);
  const auto unfinished =
      std::count_if(results.begin(), results.end(), [](const JobResult& one) { return one.ending != Ending::done; });
  const auto wide = std::count_if(results.begin(), results.end(), [](const JobResult& one) {
    return one.output.times.contains("wide") && one.output.times.at("wide").get<bool>();
  });
  found.text = times_text(found.timings, terminal_width(120)) + "\n" + orders_text(orders) + failures_text(failures) +
               fmt::format("\n{} jobs; {} crashed or exceeded their limits; {} were timed with a wide spread.\n",
                           results.size(), unfinished, wide);
  return found;
}

const Catalog<Study>::Entry speed_entry{
    {.name = "speed",
     .about = "Speed against accuracy: the cost of each method for an error, and its error for a cost",
     .examples =
         "  plumb study speed                              the canonical scenarios and the pyramid, every engine\n"
         "  plumb study speed --scenarios spring orbit     some scenarios\n"
         "  plumb study speed --engine impulse --engine box2d --dt 1/60 1/240\n",
     .attach = [](CLI::App& app) -> std::function<Json()> {
       const auto options = std::make_shared<SpeedOptions>();
       CommandOptions add(app);
       add.add("--scenarios", "NAME", options->scenarios, "NAME, NAME:LABEL or NAME:parameter=value,...");
       add.flag("--all", options->all, "Every scenario");
       add.add_repeated("--engine", "ENGINE", options->engines,
                        "NAME[:key=value,...]; may be repeated. Default: every engine and method");
       add.add("--dt", "STEP", options->steps, "Time steps in s, numbers or fractions");
       return [options] { return configuration_of(*options); };
     },
     .plan = [](const Json& configuration) -> StudyPlan {
       return {jobs_of(configuration), conclude};
     },
     .summary = [](const std::vector<std::string>& engines) -> std::optional<std::vector<std::string>> {
       return with_engines(
           {"--scenarios", "bounce:e=0.8", "slope:steep", "spring", "stacking:ten", "--dt", "1/30", "1/60", "1/120"},
           engines);
     }}};

}  // namespace
}  // namespace plumb
