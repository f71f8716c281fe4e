// The study of statistics: ensembles of random scenes of which only means and distributions are known, with intervals.
// Each run of an ensemble is one job.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "reports/report.h"
#include "reports/run/catalog_case.h"
#include "reports/run/selection.h"
#include "reports/study/job.h"
#include "reports/study/results_file.h"
#include "reports/study/statistics/verdict.h"
#include "reports/study/study.h"
#include "reports/system/command_options.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

struct StatisticsOptions {
  std::vector<std::string> ensembles, engines;
  bool large = false;
  bool controls = false;
};

const Ensemble& find_ensemble(const std::string& name) { return find_entry<Ensemble>("ensemble", name); }

std::vector<const Ensemble*> ensembles_of(const Json& configuration) {
  std::vector<const Ensemble*> ensembles;
  for (const std::string name : configuration.at("ensembles")) ensembles.push_back(&find_ensemble(name));
  return ensembles.empty() ? Catalog<Ensemble>::all() : ensembles;
}

// Without words: each engine with its default settings.
std::vector<EngineConfig> engines_of(const Json& configuration) {
  std::vector<EngineConfig> engines;
  for (const std::string word : configuration.at("engines")) engines.push_back(parse_engine(word));
  if (!engines.empty()) return engines;
  for (const EngineConfig& config : default_engines()) {
    if (config.method().empty()) engines.push_back(config);
  }
  return engines;
}

JobOutput output_of(const Ensemble& ensemble, const EngineConfig& config, const std::string& label, bool control,
                    std::uint64_t seed) {
  const RunResult result = run_ensemble(ensemble, config, seed);
  JobOutput output;
  output.values = {
      {"ensemble", ensemble.name}, {"engine", label},      {"execution", name_of(config.engine->execution)},
      {"control", control},        {"seed", seed},         {"status", name_of(result.status)},
      {"why", result.reason},      {"draws", result.draws}};
  for (std::size_t i = 0; i < ensemble.statistics.size() && !result.draws.empty(); ++i) {
    double sum = 0;
    for (const EnsembleDraw& draw : result.draws) sum += draw[i];
    output.values[ensemble.statistics[i].name] = finite_or_null(sum / static_cast<double>(result.draws.size()));
  }
  output.times = {{"stepping", result.stepping}};
  return output;
}

std::vector<Job> jobs_of(const Json& configuration) {
  const bool large = configuration.at("large");
  const std::vector<EngineConfig> engines = engines_of(configuration);
  std::vector<Job> jobs;
  for (const Ensemble* ensemble : ensembles_of(configuration)) {
    const auto add = [&](const EngineConfig& config, const std::string& label, bool control, int runs,
                         const std::shared_ptr<const Engine>& owner) {
      for (int seed = 1; seed <= runs; ++seed) {
        jobs.push_back({.key = fmt::format("statistics|{}|{}|seed {}", ensemble->name, label, seed), .run = [=] {
                          EngineConfig own = config;
                          if (owner) own.engine = owner.get();
                          return output_of(*ensemble, own, label, control, static_cast<std::uint64_t>(seed));
                        }});
      }
    };
    const int runs = large ? ensemble->large : ensemble->runs;
    for (const EngineConfig& config : engines)
      add(config, label_of(config.engine->name, config.method()), false, runs, nullptr);
    if (!configuration.at("controls").get<bool>()) continue;
    const auto control = std::make_shared<const Engine>(engine_of(ensemble->control()));
    add({control.get(), complete(*control, {})}, "control:" + control->name, true, ensemble->runs, control);
  }
  return jobs;
}

// Changes when the definition of an ensemble changes.
std::string definitions_hash(const std::vector<const Ensemble*>& ensembles) {
  std::vector<std::string> descriptions;
  descriptions.reserve(ensembles.size());
  for (const Ensemble* ensemble : ensembles) descriptions.push_back(description_of(*ensemble).dump());
  return hash_of_lines(descriptions);
}

Json configuration_of(const StatisticsOptions& options) {
  Json configuration{{"ensembles", options.ensembles},
                     {"engines", options.engines},
                     {"large", options.large},
                     {"controls", options.controls}};
  configuration["definitions"] = definitions_hash(ensembles_of(configuration));
  require_distinct_keys(jobs_of(configuration));
  return configuration;
}

const Catalog<Study>::Entry statistics_entry{
    {.name = "statistics",
     .about = "Are means and distributions right where single motions are chaotic? Ensembles with intervals",
     .examples = "  plumb study statistics                              every ensemble, every engine: about a minute\n"
                 "  plumb study statistics --ensembles silo galton      some ensembles\n"
                 "  plumb study statistics --large --engine box2d       twenty times as many draws of one engine\n"
                 "  plumb study statistics --controls                   and an engine in each that must differ\n",
     .attach = [](CLI::App& app) -> std::function<Json()> {
       const auto options = std::make_shared<StatisticsOptions>();
       std::string names;
       for (const Ensemble* one : Catalog<Ensemble>::all()) names += (names.empty() ? "" : ", ") + one->name;
       CommandOptions add(app);
       add.add("--ensembles", "NAME", options->ensembles, "Any of: " + names + ". Default: all");
       add.add_repeated("--engine", "ENGINE", options->engines,
                        "NAME[:key=value,...]; may be repeated. Default: every engine with its default settings");
       add.flag("--large", options->large, "About twenty times as many draws, in many minutes");
       add.flag("--controls", options->controls, "Also an engine in each ensemble that must differ");
       return [options] { return configuration_of(*options); };
     },
     .plan = [](const Json& configuration) -> StudyPlan {
       return {jobs_of(configuration),
               [ensembles = ensembles_of(configuration)](const std::vector<JobResult>& results) {
                 return conclude_statistics(ensembles, results);
               }};
     },
     .summary = [](const std::vector<std::string>& engines) -> std::optional<std::vector<std::string>> {
       return with_engines({"--ensembles", "equipartition", "galton", "sinai"}, engines);
     }}};

}  // namespace
}  // namespace plumb
