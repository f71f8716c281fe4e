// The study `find`: random scenes in which engines are wrong, each cut down to the smallest that still shows it.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>

#include "reports/find/finding.h"
#include "reports/find/isolated.h"
#include "reports/find/kind.h"
#include "reports/find/shrink.h"
#include "reports/find/summary.h"
#include "reports/run/selection.h"
#include "reports/study/job.h"
#include "reports/study/results_file.h"
#include "reports/study/study.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/scene_json.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

struct SearchOptions {
  std::vector<std::string> engines, kinds;
  std::uint64_t seed = 1;
  int count = 200;
  int budget = 150;
  int each = 3;
  double limit = 10;
};

/// What all jobs of a search share.
struct Search {
  std::vector<Suspect> suspects;
  std::vector<Suspect> others;  // that films of findings show beside them
  std::vector<const Kind*> kinds;
  std::uint64_t seed = 0;
  int count = 0, budget = 0, each = 0;
  RunLimits limits;

  const Suspect& suspect(const std::string& name) const { return *std::ranges::find(suspects, name, &Suspect::name); }
};

std::vector<const Kind*> kinds_named(const std::vector<std::string>& names) {
  std::vector<const Kind*> kinds;
  kinds.reserve(names.size());
  for (const std::string& name : names) kinds.push_back(&find_kind(name));
  return kinds.empty() ? Catalog<Kind>::all() : kinds;
}

std::shared_ptr<const Search> search_of(const Json& configuration) {
  auto search = std::make_shared<Search>();
  search->suspects = parse_suspects(configuration.at("engines").get<std::vector<std::string>>());
  search->others = parse_suspects(std::vector<std::string>{});
  std::stable_partition(search->others.begin(), search->others.end(),
                        [](const Suspect& one) { return one.name == ours; });
  search->kinds = kinds_named(configuration.at("kinds"));
  search->seed = configuration.at("seed");
  search->count = configuration.at("count");
  search->budget = configuration.at("budget");
  search->each = configuration.at("each");
  search->limits.seconds = configuration.at("run_limit");
  return search;
}

// All suspects in one scene.
JobOutput look(const Search& search, const Kind& kind, int n) {
  const Scene scene = drawn(kind, search.seed, n);
  const std::vector<Opinion> judged = judged_apart(scene, kind.posed, search.suspects, {}, search.limits);
  Json opinions = Json::object();
  std::string wrong;
  for (std::size_t i = 0; i < judged.size(); ++i) {
    const std::string& name = search.suspects[i].name;
    if (!judged[i].complaints.empty()) wrong += (wrong.empty() ? "" : ", ") + name;
    opinions[name] = as_json(judged[i]);
  }
  return {
      .values = {
          {"scene", scene.name}, {"bodies", scene.bodies.size()}, {"wrong", wrong}, {"opinions", std::move(opinions)}}};
}

std::vector<Job> looks(const std::shared_ptr<const Search>& search) {
  std::vector<Job> jobs;
  const auto kinds = static_cast<int>(search->kinds.size());
  for (int i = 0; i < search->count; ++i) {
    const Kind& kind = *search->kinds[static_cast<std::size_t>(i % kinds)];
    jobs.push_back({.key = fmt::format("find|{}/{}", kind.name, i / kinds),
                    .run = [search, &kind, n = i / kinds] { return look(*search, kind, n); }});
  }
  return jobs;
}

/// A scene in which a suspect is wrong, to be cut down.
struct Lead {
  std::string engine, reason, scene;
  std::size_t bodies = 0;
};

JobOutput cut_down(const Search& search, const Lead& lead) {
  const Kind& kind = find_kind(lead.scene.substr(0, lead.scene.find('/')));
  Scene scene = drawn(lead.scene, search.seed);
  const Suspect& suspect = search.suspect(lead.engine);
  const Judges judges = Judges::of_reason(lead.reason);
  const CutTrial trial{
      .fails = [&](const Scene& candidate) -> std::optional<Complaint> {
        const auto opinions = judged_apart(candidate, kind.posed, {&suspect, 1}, judges, search.limits);
        const Complaint* same = opinions.front().of(lead.reason);
        return same == nullptr ? std::nullopt : std::optional(*same);
      },
      .states = [&](const Scene& candidate,
                    double time) { return states_apart(candidate, suspect, time, search.limits); },
      .stated = stated_by(suspect.config.engine->stepping(suspect.config.settings, search_step))};
  const auto first = trial.fails(scene);
  if (!first) throw std::runtime_error("the second run of the scene did not fail: the engine is not deterministic");
  Shrunk shrunk = shrink(scene, *first, trial, search.budget);
  Finding finding{.engine = lead.engine,
                  .complaint = shrunk.complaint,
                  .from = lead.scene,
                  .posed = kind.posed,
                  .scene = std::move(shrunk.scene),
                  .drawn_bodies = static_cast<int>(scene.bodies.size()),
                  .runs = shrunk.runs};
  finding.scene.name = "scene";
  finding.scene.about.clear();
  finding.run = shown_apart(finding.scene, finding.complaint, suspect, search.others, search.limits);
  return {.values = as_json(finding)};
}

// Of every engine and reason the smallest scenes, of kinds that differ as long as there are any: the first of each
// reason before the second of any. A fault is one mistake, so it has one reason.
std::vector<Lead> leads_in(const Search& search, const std::vector<JobResult>& results) {
  std::map<std::pair<std::size_t, std::string>, std::vector<Lead>> by_reason;
  for (const JobResult& result : results) {
    if (result.ending != Ending::done) continue;
    const Json& values = result.output.values;
    for (std::size_t s = 0; s < search.suspects.size(); ++s) {
      const std::string& name = search.suspects[s].name;
      const Opinion opinion = opinion_of(values.at("opinions").at(name));
      for (const Complaint& one : opinion.complaints) {
        const std::string group = search.suspects[s].right ? "" : one.reason();
        by_reason[{s, group}].push_back({name, one.reason(), values.at("scene"), values.at("bodies")});
      }
    }
  }
  std::vector<std::vector<Lead>> ranks(static_cast<std::size_t>(search.each));
  for (auto& [key, leads] : by_reason) {
    std::ranges::stable_sort(leads, {}, &Lead::bodies);
    std::set<std::string> kinds;
    std::size_t taken = 0;
    const std::size_t most = key.second.empty() ? 1 : ranks.size();
    for (const Lead& lead : leads) {
      if (!kinds.insert(lead.scene.substr(0, lead.scene.find('/'))).second) continue;
      if (taken < most) ranks[taken++].push_back(lead);
    }
  }
  std::vector<Lead> all;
  for (const auto& rank : ranks) all.insert(all.end(), rank.begin(), rank.end());
  return all;
}

std::vector<Job> cuts_of(const std::shared_ptr<const Search>& search, const std::vector<JobResult>& results) {
  std::vector<Job> jobs;
  for (const Lead& lead : leads_in(*search, results)) {
    jobs.push_back({.key = fmt::format("cut|{}|{}|{}", lead.engine, lead.reason, lead.scene),
                    .run = [search, lead] { return cut_down(*search, lead); }});
  }
  return jobs;
}

// Changes when another version draws other scenes.
std::string definitions_hash(const std::vector<const Kind*>& kinds, std::uint64_t seed) {
  std::vector<std::string> scenes;
  scenes.reserve(kinds.size());
  for (const Kind* kind : kinds) scenes.push_back(write_scene({.scene = drawn(*kind, seed, 0), .truth = {}}));
  return hash_of_lines(scenes);
}

Json configuration_of(const SearchOptions& options) {
  std::vector<std::string> suspects;
  for (const Suspect& suspect : parse_suspects(options.engines)) suspects.push_back(suspect.name);
  require_distinct(suspects);
  const auto kinds = kinds_named(options.kinds);
  std::vector<std::string> names;
  names.reserve(kinds.size());
  for (const Kind* kind : kinds) names.push_back(kind->name);
  require_distinct(names);
  return {{"engines", suspects},        {"kinds", names},
          {"seed", options.seed},       {"count", options.count},
          {"budget", options.budget},   {"each", options.each},
          {"run_limit", options.limit}, {"definitions", definitions_hash(kinds, options.seed)}};
}

const Catalog<Study>::Entry find_entry{
    {.name = "find",
     .about = "Random scenes in which engines are wrong, each cut down to the smallest that still shows it",
     .examples =
         "  plumb find                                    200 scenes, every engine\n"
         "  plumb find --time 10m --engine impulse        as many as ten minutes allow\n"
         "  plumb find --kind heap --kind tower --seed 7  other scenes, of two kinds\n"
         "  plumb find --engine fault:all                 which of prove's faults random scenes find\n"
         "  plumb find --engine closed-form:all           what judges say of closed forms; exit code 1 unless nothing\n"
         "  plumb find --again out/found                  run what was found again; exit code 1 if it fails\n",
     .attach = [](CLI::App& app) -> std::function<Json()> {
       const auto options = std::make_shared<SearchOptions>();
       std::string names;
       for (const Kind* kind : Catalog<Kind>::all()) names += (names.empty() ? "" : ", ") + kind->name;
       app.add_option(
              "--engine", options->engines,
              "NAME[:key=value,...], fault:NAME, closed-form:NAME or fault:all, closed-form:all; may be repeated. "
              "Default: every engine")
           ->allow_extra_args(false)
           ->type_name("ENGINE");
       app.add_option("--kind", options->kinds, "Any of: " + names + ". Default: all")
           ->allow_extra_args(false)
           ->type_name("KIND");
       app.add_option("--seed", options->seed, "Other scenes for another seed")->capture_default_str()->type_name("N");
       app.add_option("--count", options->count, "Scenes to draw, of each kind in turn")
           ->capture_default_str()
           ->check(CLI::Range(1, 1'000'000))
           ->type_name("N");
       app.add_option("--budget", options->budget, "Runs that cutting down one scene may take")
           ->capture_default_str()
           ->check(CLI::Range(0, 100'000))
           ->type_name("N");
       app.add_option("--each", options->each, "Scenes to cut down for each reason for which an engine fails")
           ->capture_default_str()
           ->check(CLI::Range(1, 100))
           ->type_name("N");
       app.add_option("--run-limit", options->limit, "Seconds of a processor that one run of an engine may take")
           ->capture_default_str()
           ->check(CLI::Range(0.1, 3600.0))
           ->type_name("S");
       return [options] { return configuration_of(*options); };
     },
     .plan = [](const Json& configuration) -> StudyPlan {
       const auto search = search_of(configuration);
       return {
           .jobs = looks(search),
           .conclude = [configuration](
                           const std::vector<JobResult>& results) { return conclude_search(configuration, results); },
           .follow_up = [search](const std::vector<JobResult>& results) { return cuts_of(search, results); }};
     }}};

}  // namespace
}  // namespace plumb
