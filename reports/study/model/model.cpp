// The study of models: what each feature of our engine is worth in a scene, in error and in cost, and the least model
// that the scene needs.

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

#include "reports/report.h"
#include "reports/run/selection.h"
#include "reports/run/timings.h"
#include "reports/study/job.h"
#include "reports/study/model/least_model.h"
#include "reports/study/model/model_error.h"
#include "reports/study/runner.h"
#include "reports/study/study.h"
#include "reports/system/command_options.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

struct ModelOptions {
  std::vector<std::string> scenarios;
  bool all = false;
  std::string engine = "impulse";
  std::string dt = "1/60";
  std::string tolerance = "1e-4";
};

// One scene of each kind that the canonical scenarios lack: flight, forces, frictionless contact, granular piles,
// joints, many bodies.
const std::vector<std::string> extra_cases{"free-bodies",         "orbit:ellipse",  "spring:w=4",     "disc-pile",
                                           "flush-tiles:smooth",  "billiard:table", "pi-billiard:31", "pyramid:five",
                                           "hanging-chain:still", "rain:seed 1"};

bool can_leave_out(const EngineConfig& config) { return config.engine->chooses != nullptr; }

bool leaves_out_by_itself(const EngineConfig& config) {
  return config.settings.at("model") != complete(*config.engine, {}).at("model");
}

EngineConfig full_of(const Json& configuration) {
  const std::string word = configuration.at("engine");
  EngineConfig full = parse_engine(word);
  if (!can_leave_out(full)) {
    throw std::invalid_argument(word + " cannot leave features out; choose impulse, or impulse:key=value,...");
  }
  if (leaves_out_by_itself(full)) {
    throw std::invalid_argument(word + " leaves features out by itself, so it is not a full model to drop them from");
  }
  return full;
}

double tolerance_of(const Json& configuration) {
  const double tolerance = parse_number("--tolerance", configuration.at("tolerance").get<std::string>());
  if (tolerance > 0) return tolerance;
  throw std::invalid_argument("--tolerance must be above 0 m");
}

// One model in one case: its error, and then its cost.
class ModelRun {
 public:
  ModelRun(std::shared_ptr<const ModelError> errors, EngineConfig model, Json about)
      : errors_(std::move(errors)), model_(std::move(model)), about_(std::move(about)) {}

  JobOutput output() {
    const Case& problem = errors_->problem();
    const ModelError::Result result = errors_->of(model_);
    able_ = result.status == Status::ok;
    JobOutput output;
    output.values = {{"scenario", problem.scenario->name}, {"variant", problem.variant}};
    output.values.update(about_);
    output.values.update({{"line", label_of(model_.engine->name, model_.method())},
                          {"status", name_of(result.status)},
                          {"why", result.reason},
                          {"error", finite_or_null(result.error)},
                          {"change", finite_or_null(result.change)},
                          {"different", result.different},
                          {"breaks", result.breaks},
                          {"chaotic", errors_->chaotic()},
                          {"within", errors_->within_tolerance(result)},
                          {"duration", problem.scene->duration},
                          {"truth", errors_->truth()},
                          {"truth_until", errors_->truth_until()},
                          {"truth_error", errors_->truth_error()},
                          {"compared_until", errors_->compared_until()},
                          {"phases", errors_->phases()}});
    Json choices = Json::array();
    for (const Choice& one : model_.engine->chooses(*problem.scene, model_.settings)) {
      choices.push_back({{"setting", one.option + "=" + one.value}, {"reason", one.reason}});
    }
    if (!choices.empty()) output.values["choices"] = std::move(choices);
    return output;
  }

  // s per simulated second; NaN for a model that did not run.
  double cost() const {
    if (!able_) return std::numeric_limits<double>::quiet_NaN();
    return step_cost(*errors_->problem().scene, model_, errors_->dt());
  }

 private:
  std::shared_ptr<const ModelError> errors_;
  EngineConfig model_;
  Json about_;
  bool able_ = false;
};

std::vector<Job> jobs_of(const Json& configuration) {
  const EngineConfig full = full_of(configuration);
  const double dt = parse_dt(configuration.at("dt").get<std::string>());
  const double tolerance = tolerance_of(configuration);
  std::vector<Job> jobs;
  for (Case& problem : select_cases(configuration.at("scenarios"), configuration.at("all"), extra_cases)) {
    const std::string case_name = problem.scenario->name + "/" + problem.variant;
    const auto errors = std::make_shared<ModelError>(std::move(problem), full, dt, tolerance);
    const auto add = [&](const std::string& name, const EngineConfig& model, Json about) {
      const auto model_run = std::make_shared<ModelRun>(errors, model, std::move(about));
      jobs.push_back({.key = fmt::format("model|{}|{}", case_name, name),
                      .run = [model_run] { return model_run->output(); },
                      .repetition = [model_run] { return model_run->cost(); },
                      .group = case_name,
                      .prepare = [errors] { errors->find(); }});
    };
    add("full", full, {{"role", "full"}});
    for (const FeatureDrop& drop : single_drops(full)) {
      FeatureLevels levels(model_features().size(), 0);
      levels[drop.feature] = drop.step;
      const Feature& feature = model_features()[drop.feature];
      add(drop.setting, model_at(full, levels),
          {{"role", "drop"},
           {"feature", feature.name},
           {"without", feature.steps[drop.step - 1].without},
           {"setting", drop.setting}});
    }
    add("auto", automatic_model(full), {{"role", "auto"}});
    const auto seconds = std::make_shared<double>(JobLimits{}.seconds);
    jobs.push_back({.key = fmt::format("model|{}|least", case_name),
                    .run = [errors, seconds] { return search_least_model(*errors, *seconds); },
                    .alone = true,
                    .prepare = [errors] { errors->find(); },
                    .within = [seconds](double limit) { *seconds = limit; }});
  }
  return jobs;
}

Json configuration_of(const ModelOptions& options) {
  Json configuration{
      {"scenarios", options.scenarios}, {"all", options.all},
      {"engine", options.engine},       {"dt", options.dt},
      {"tolerance", options.tolerance}, {"scenes", hash_of(select_cases(options.scenarios, options.all, extra_cases))}};
  require_distinct_keys(jobs_of(configuration));
  return configuration;
}

// The results of one case.
struct CaseResults {
  std::string name;
  const JobResult* full = nullptr;
  const JobResult* automatic = nullptr;
  const JobResult* least = nullptr;
  std::vector<const JobResult*> drops;
  std::string why_no_least;
};

// The jobs of a case follow each other. A job that did not finish has no values, but its key names the case:
// model|SCENARIO/VARIANT|NAME.
std::vector<CaseResults> by_case(const std::vector<JobResult>& results) {
  std::vector<CaseResults> cases;
  for (const JobResult& result : results) {
    const std::size_t begin = result.key.find('|') + 1;
    const std::string name = result.key.substr(begin, result.key.rfind('|') - begin);
    if (cases.empty() || cases.back().name != name) cases.push_back({.name = name});
    CaseResults& found = cases.back();
    if (result.ending != Ending::done) {
      if (result.key.ends_with("|least"))
        found.why_no_least = std::string(name_of(result.ending)) + ", " + result.reason;
      continue;
    }
    const std::string role = result.output.values.value("role", "");
    if (role == "full") found.full = &result;
    if (role == "auto") found.automatic = &result;
    if (role == "least") found.least = &result;
    if (role == "drop") found.drops.push_back(&result);
  }
  return cases;
}

Json ratio_or_null(const Json& over, const Json& under) {
  if (!over.is_number() || !under.is_number() || !(under.get<double>() > 0)) return nullptr;
  return over.get<double>() / under.get<double>();
}

Json median_of(const Json& times) { return times.contains("median") ? times.at("median") : Json(nullptr); }

// impulse:auto promises to be no less accurate than the full model, within the tolerance.
Json promise_of(const CaseResults& results) {
  if (results.automatic == nullptr) return {{"case", results.name}, {"kept", false}, {"change", nullptr}};
  const Json& values = results.automatic->output.values;
  return {{"case", results.name}, {"kept", values.at("within")}, {"change", values.at("change")}};
}

// The cheapest single drop of those that add at most `tolerance`, in m, and break nothing: what a coarser question
// would allow.
Json cheapest_within(const CaseResults& results, double tolerance, const Json& full) {
  Json best = nullptr;
  for (const JobResult* drop : results.drops) {
    const Json& values = drop->output.values;
    if (!values.contains("change") || !values.at("change").is_number() || values.at("change").get<double>() > tolerance)
      continue;
    if (!values.at("breaks").get<std::string>().empty()) continue;
    const Json ratio = ratio_or_null(full, median_of(drop->output.times));
    if (!ratio.is_number() || (best.is_object() && best.at("cheaper") >= ratio)) continue;
    best = {{"tolerance", tolerance}, {"line", values.at("line")}, {"cheaper", ratio}, {"change", values.at("change")}};
  }
  return best;
}

// How many times cheaper than the full model, from the quartiles of both: the two did not take turns.
Json times_cheaper(const Json& full, const Json& other) {
  return {{"median", ratio_or_null(median_of(full), median_of(other))},
          {"low", ratio_or_null(full.at("low"), other.at("high"))},
          {"high", ratio_or_null(full.at("high"), other.at("low"))}};
}

// What stands in for a search that had no time to find it: the cheapest model that lacks one feature and loses nothing.
// null if none is surely cheaper than what the search found.
Json least_known(const CaseResults& results, const Json& least) {
  const JobResult& full = *results.full;
  Json best = nullptr;
  for (const JobResult* drop : results.drops) {
    const Json& values = drop->output.values;
    if (!values.value("within", false) || !drop->output.times.contains("high")) continue;
    Json cheaper = times_cheaper(full.output.times, drop->output.times);
    const double before = best.is_object()    ? best.at("cheaper").at("median").get<double>()
                          : least.is_object() ? least.at("cheaper").at("median").get<double>()
                                              : 1;
    if (!cheaper.at("low").is_number() || cheaper.at("low") <= before) continue;
    best = {{"line", values.at("line")},
            {"error", values.at("error")},
            {"change", values.at("change")},
            {"cheaper", std::move(cheaper)},
            {"dropped", Json::array({{{"feature", values.at("feature")}, {"without", values.at("without")}}})}};
  }
  if (!best.is_object()) return nullptr;
  const bool timed = results.automatic != nullptr && results.automatic->output.times.contains("high");
  best["auto_cheaper"] = least.is_object() ? least.at("auto_cheaper")
                         : timed           ? times_cheaper(full.output.times, results.automatic->output.times)
                                           : Json(nullptr);
  return best;
}

Json costs_of(const CaseResults& results) {
  const Json full = median_of(results.full->output.times);
  Json drops = Json::array();
  for (const JobResult* drop : results.drops) {
    drops.push_back({{"setting", drop->output.values.at("setting")},
                     {"ratio", ratio_or_null(median_of(drop->output.times), full)}});
  }
  const bool chaotic = results.full->output.values.value("chaotic", false);
  Json coarser = Json::array();
  for (const double tolerance : {1e-3, 1e-2, 1e-1}) {
    Json found = chaotic ? Json(nullptr) : cheapest_within(results, tolerance, full);
    if (!found.is_object() || found.at("cheaper") <= 1.0) continue;
    if (coarser.empty() || coarser.back().at("line") != found.at("line")) coarser.push_back(std::move(found));
  }
  Json costs{{"case", results.name}, {"full", full},      {"drops", std::move(drops)},  {"coarser", std::move(coarser)},
             {"least", nullptr},     {"complete", false}, {"why", results.why_no_least}};
  if (results.least != nullptr) {
    const Json& values = results.least->output.values;
    costs["complete"] = values.value("complete", true);
    costs["why"] = values.value("why", "");
    if (results.least->output.times.contains("line")) costs["least"] = results.least->output.times;
  }
  if (costs.at("complete")) return costs;
  if (Json known = least_known(results, costs.at("least")); known.is_object()) costs["least"] = std::move(known);
  return costs;
}

// "heap/steep: impulse:sleeping=on is 5.7 times cheaper than the full model", and what is not known.
std::string finding_of(const Json& cost, bool auto_kept) {
  const Json& least = cost.at("least");
  std::string text = cost.at("case").get<std::string>() + ": ";
  if (!least.is_object()) {
    const std::string why = cost.at("why");
    return text + "no least model: " + (why.empty() ? "the search did not end" : why) +
           (why.find("timed out") == std::string::npos ? "" : "; give it more with --time-limit") + "\n";
  }
  const double cheaper = least.at("cheaper").at("median");
  const bool any = !least.at("dropped").empty();
  const bool complete = cost.at("complete");
  text += any        ? fmt::format("{:.2g} times cheaper than the full model: --engine {}", cheaper,
                                   least.at("line").get<std::string>())
          : complete ? "the full model is the least"
                     : "nothing cheaper was found in time";
  text += complete ? "\n" : " (out of time: maybe not the least; --time-limit gives the search more)\n";
  if (const Json& automatic = least.at("auto_cheaper"); automatic.is_object() && automatic.at("median").is_number()) {
    text += fmt::format("  impulse:auto: {:.2g} times cheaper, {}\n", automatic.at("median").get<double>(),
                        auto_kept ? "as accurate" : "LESS ACCURATE");
  }
  return text;
}

std::string text_of(const Json& promises, const Json& costs) {
  std::string text;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    text += finding_of(costs[i], promises[i].at("kept"));
    for (const Json& one : costs[i].at("coarser")) {
      const Json& least = costs[i].at("least");
      if (least.is_object() && one.at("cheaper") <= least.at("cheaper").at("median")) continue;
      text += fmt::format("  if {:g} mm may be lost: {:.2g} times cheaper: --engine {}\n",
                          one.at("tolerance").get<double>() * 1000, one.at("cheaper").get<double>(),
                          one.at("line").get<std::string>());
    }
  }
  const auto kept =
      std::count_if(promises.begin(), promises.end(), [](const Json& one) { return one.at("kept").get<bool>(); });
  return text +
         fmt::format("impulse:auto is as accurate as the full model in {} of {} cases.\n", kept, promises.size());
}

Findings conclude(const std::vector<JobResult>& results) {
  Json promises = Json::array();
  Json costs = Json::array();
  for (const CaseResults& one : by_case(results)) {
    if (one.full == nullptr) continue;
    promises.push_back(promise_of(one));
    costs.push_back(costs_of(one));
  }
  Findings found;
  found.findings = {{"promises", promises}};
  found.timings = {{"cases", costs}};
  found.text = text_of(promises, costs);
  return found;
}

// Of the first engine that can leave features out, if there is one.
std::optional<std::vector<std::string>> summary_of(const std::vector<std::string>& engines) {
  const std::vector<std::string> options{"--scenarios", "free-bodies", "flush-tiles:smooth", "stacking:one"};
  if (engines.empty()) return options;
  for (const std::string& word : engines) {
    const EngineConfig config = parse_engine(word);
    if (can_leave_out(config) && !leaves_out_by_itself(config)) return with_engines(options, {word});
  }
  return std::nullopt;
}

const Catalog<Study>::Entry model_entry{
    {.name = "model",
     .about = "The least model that a scene needs: what each feature is worth, in error and in cost",
     .examples = "  plumb study model                                   one scene of each kind\n"
                 "  plumb study model --scenarios gas rain              some scenarios\n"
                 "  plumb study model --tolerance 1e-3 --dt 1/30        coarser\n"
                 "  plumb study model --engine impulse:substeps=8       another full model\n",
     .attach = [](CLI::App& app) -> std::function<Json()> {
       const auto options = std::make_shared<ModelOptions>();
       CommandOptions add(app);
       add.add("--scenarios", "NAME", options->scenarios, "NAME, NAME:LABEL or NAME:parameter=value,...");
       add.flag("--all", options->all, "Every scenario");
       add.add("--tolerance", "M", options->tolerance, "m, by which a model may be worse than the full one");
       add.add("--engine", "ENGINE", options->engine, "The full model: impulse[:key=value,...]");
       add.add("--dt", "STEP", options->dt, "Time step in s, a number or a fraction");
       return [options] { return configuration_of(*options); };
     },
     .plan = [](const Json& configuration) -> StudyPlan {
       return {jobs_of(configuration), conclude};
     },
     .summary = summary_of}};

}  // namespace
}  // namespace plumb
