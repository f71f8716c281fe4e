// Speed against accuracy: every engine and method over a ladder of steps and of what makes it work harder.

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

#include "reports/report.h"
#include "reports/run/case_run.h"
#include "reports/run/selection.h"
#include "reports/study/answer.h"
#include "reports/study/asked_cases.h"
#include "reports/study/methods.h"
#include "reports/study/speed/speed_findings.h"
#include "reports/study/study.h"
#include "reports/timing/step_cost.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

// s of a scene, from its start, that are timed: the same for all engines. Of many bodies less, but enough to see
// more than the start; all repetitions of the ladder's finest steps would otherwise take hours.
double timed_seconds(const Scene& scene) {
  constexpr double body_seconds = 20;
  constexpr double least = 1;
  const auto bodies = std::count_if(scene.bodies.begin(), scene.bodies.end(),
                                    [](const Body& body) { return body.type == BodyType::dynamic; });
  return std::min(scene.duration,
                  std::max(least, body_seconds / static_cast<double>(std::max<std::ptrdiff_t>(bodies, 1))));
}

struct Asked {
  std::vector<std::string> scenarios;
  bool all = false;
  std::vector<std::string> engines;
  std::vector<std::string> steps{"1/30", "1/60", "1/120", "1/240", "1/480", "1/960"};
};

// An engine's method at one rung of what makes it work harder.
struct Rung {
  EngineConfig config;
  std::string method;  // without the rung
  std::string option, value;
  bool standard = false;  // the value is the default
};

std::vector<Rung> rungs_of(const EngineConfig& config, const WorkLadder& ladder) {
  const Engine& engine = *config.engine;
  if (ladder.option.empty()) return {{config, config.method(), "", "", true}};
  std::vector<Rung> rungs;
  for (const std::string& value : ladder.values) {
    Settings settings = config.settings;
    settings[ladder.option] = value;
    const Settings defaults = complete(engine, {});
    rungs.push_back({{&engine, complete(engine, settings)},
                     config.method(),
                     ladder.option,
                     value,
                     value == defaults.at(ladder.option)});
  }
  return rungs;
}

std::vector<Rung> rungs_of(const Json& configuration) {
  std::vector<Rung> all;
  for (const Method& method : methods_asked(configuration.at("engines"))) {
    for (Rung& rung : rungs_of(method.config, method.ladder)) all.push_back(std::move(rung));
  }
  return all;
}

std::vector<Case> cases_of(const std::vector<std::string>& words, bool all) {
  return cases_asked(words, all, {"pyramid"});
}

std::vector<double> steps_of(const Json& configuration) {
  std::vector<double> steps;
  for (const std::string text : configuration.at("dt")) steps.push_back(parse_dt(text));
  return steps;
}

// 0 where none is.
int order_stated(const Case& asked, const Stepping& stepping) {
  const auto& smoothness = asked.scenario->smoothness;
  switch (smoothness ? smoothness(asked.parameters) : Smoothness::none) {
    case Smoothness::none:
      return 0;
    case Smoothness::free:
      return stepping.order;
    case Smoothness::sliding:
      return stepping.order_in_contact;
  }
  return 0;
}

// How far a method is off at one step: over all phases of a step where impacts fall somewhere in it, so that none is
// lucky.
class Measurement {
 public:
  Measurement(std::shared_ptr<const Case> asked, std::shared_ptr<const Answer> answer, Rung rung, double dt)
      : asked_(std::move(asked)), answer_(std::move(answer)), rung_(std::move(rung)), dt_(dt) {}

  Row row() {
    Row row;
    Json& values = row.values;
    const EngineConfig& config = rung_.config;
    const Stepping stepping = config.engine->stepping(config.settings, dt_);
    values = {{"scenario", asked_->scenario->name},
              {"variant", asked_->variant},
              {"engine", config.engine->name},
              {"method", rung_.method},
              {"option", rung_.option},
              {"setting", rung_.value},
              {"standard", rung_.standard},
              {"dt", dt_},
              {"steps", steps_in(asked_->scene->duration, dt_)},
              {"timed", timed_seconds(*asked_->scene)},
              {"order", order_stated(*asked_, stepping)},
              {"truth", answer_->witness() == nullptr ? "" : answer_->witness()->name},
              {"truth_until", 0.0},
              {"truth_error", 0.0}};
    if (answer_->witness() == nullptr) {
      values["status"] = "no truth";
      values["why"] = answer_->reason();
      return row;
    }
    values["truth_until"] = std::min(answer_->until(), asked_->scene->duration);
    values["truth_error"] = answer_->error();
    measure_into(values, stepping);
    able_ = values.contains("error");
    return row;
  }

  // s per simulated second; of what does not run to its end, no number.
  double time() const {
    if (!able_) return std::numeric_limits<double>::quiet_NaN();
    Scene scene = *asked_->scene;
    scene.duration = timed_seconds(scene);
    return step_cost(scene, rung_.config, dt_);
  }

 private:
  void measure_into(Json& values, const Stepping& stepping) const {
    double squares = 0;
    double least = std::numeric_limits<double>::infinity();
    double largest = 0;
    const std::vector<Case> all = phases(*asked_, asked_->scenario->phased ? judged_phases : 1);
    for (const Case& phase : all) {
      const Outcome outcome = run(*phase.scene, rung_.config, dt_, phase.first_step);
      values["status"] = name_of(outcome.status);
      values["why"] = outcome.reason;
      if (outcome.status != Status::ok) return;
      const double error = answer_->error_of(*outcome.trace, dt_, phase.first_step);
      squares += error * error;
      least = std::min(least, error);
      largest = std::max(largest, error);
    }
    values["phases"] = all.size();
    values["error"] = std::sqrt(squares / static_cast<double>(all.size()));
    values["error_least"] = least;
    values["error_largest"] = largest;
    values["round_off"] = answer_->round_off(stepping);
  }

  std::shared_ptr<const Case> asked_;
  std::shared_ptr<const Answer> answer_;
  Rung rung_;
  double dt_;
  bool able_ = false;
};

std::vector<Point> points_of(const Json& configuration) {
  const std::vector<double> steps = steps_of(configuration);
  const std::vector<Rung> rungs = rungs_of(configuration);
  const double finest = *std::min_element(steps.begin(), steps.end());
  std::vector<Point> points;
  for (Case& one : cases_of(configuration.at("scenarios"), configuration.at("all"))) {
    const auto asked = std::make_shared<const Case>(std::move(one));
    const auto answer = std::make_shared<Answer>(*asked, finest);
    const std::string place = asked->scenario->name + "/" + asked->variant;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const std::string dt = configuration.at("dt")[i];
      for (const Rung& rung : rungs) {
        const auto measurement = std::make_shared<Measurement>(asked, answer, rung, steps[i]);
        const std::string setting = rung.option.empty() ? "" : "|" + rung.option + "=" + rung.value;
        points.push_back({.key = fmt::format("speed|{}|{}{}|dt={}", place,
                                             label_of(rung.config.engine->name, rung.method), setting, dt),
                          .run = [measurement] { return measurement->row(); },
                          .turn = [measurement] { return measurement->time(); },
                          .group = place + "|" + dt,
                          .prepare = [answer] { answer->find(); }});
      }
    }
  }
  return points;
}

Json configuration_of(const Asked& asked) {
  std::vector<std::string> steps = asked.steps;
  std::stable_sort(steps.begin(), steps.end(), [](const auto& a, const auto& b) { return parse_dt(a) > parse_dt(b); });
  Json configuration{{"scenarios", asked.scenarios},
                     {"all", asked.all},
                     {"engines", asked.engines},
                     {"dt", steps},
                     {"scenes", hash_of(cases_of(asked.scenarios, asked.all))}};
  must_differ(points_of(configuration));
  return configuration;
}

const Catalog<Study>::Entry speed_entry{
    {.name = "speed",
     .about = "Speed against accuracy: what each method costs for an error, and what error it gives for a time",
     .examples =
         "  plumb study speed                              the canonical scenarios and the pyramid, every engine\n"
         "  plumb study speed --scenarios spring orbit     some scenarios\n"
         "  plumb study speed --engine impulse --engine box2d --dt 1/60 1/240\n",
     .attach = [](CLI::App& app) -> std::function<Json()> {
       const auto asked = std::make_shared<Asked>();
       app.add_option("--scenarios", asked->scenarios, "NAME, NAME:LABEL or NAME:parameter=value,...")
           ->type_name("NAME");
       app.add_flag("--all", asked->all, "Every scenario");
       app.add_option("--engine", asked->engines,
                      "NAME[:key=value,...]; may be repeated. Default: every engine and method")
           ->allow_extra_args(false)
           ->type_name("ENGINE");
       app.add_option("--dt", asked->steps, "The ladder of time steps in s, numbers or fractions")
           ->capture_default_str()
           ->type_name("STEP");
       return [asked] { return configuration_of(*asked); };
     },
     .plan = [](const Json& configuration) -> StudyPlan {
       return {points_of(configuration), speed_findings};
     },
     .brief = {{"--scenarios", "bounce:e=0.8", "slope:steep", "spring", "stacking:ten", "--dt", "1/30", "1/60",
                "1/120"}}}};

}  // namespace
}  // namespace plumb
