// The least model that a scene needs: what each feature of our engine is worth there, in error and in cost.

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

#include "reports/report.h"
#include "reports/run/selection.h"
#include "reports/run/timings.h"
#include "reports/statistics.h"
#include "reports/study/asked_cases.h"
#include "reports/study/model/least_model.h"
#include "reports/study/model/model_findings.h"
#include "reports/study/model/yardstick.h"
#include "reports/study/study.h"
#include "reports/timing/repetitions.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

struct Asked {
  std::vector<std::string> scenarios;
  bool all = false;
  std::string engine = "impulse";
  std::string dt = "1/60";
  std::string tolerance = "1e-4";
};

// Beside the canonical ones, one of a kind: flight, forces, smooth, heaps, joints, crowds.
const std::vector<std::string> besides{"free-bodies",         "orbit:ellipse",  "spring:w=4",     "disc-pile",
                                       "flush-tiles:smooth",  "billiard:table", "pi-billiard:31", "pyramid:five",
                                       "hanging-chain:still", "rain:seed 1"};

EngineConfig full_of(const Json& configuration) {
  const std::string word = configuration.at("engine");
  EngineConfig full = parse_engine(word);
  if (!full.engine->chooses) {
    throw std::invalid_argument(word + " cannot leave features out; ask about impulse, or impulse:key=value,...");
  }
  if (full.settings.at("model") != complete(*full.engine, {}).at("model")) {
    throw std::invalid_argument(word + " leaves features out by itself, and is no full model to drop them from");
  }
  return full;
}

double tolerance_of(const Json& configuration) {
  const double tolerance = parse_number("--tolerance", configuration.at("tolerance").get<std::string>());
  if (tolerance > 0) return tolerance;
  throw std::invalid_argument("--tolerance must be above 0 m");
}

EngineConfig choosing(const EngineConfig& full) {
  EngineConfig chosen = full;
  chosen.settings["model"] = "auto";
  return chosen;
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

// One model of a case.
class Tried {
 public:
  Tried(std::shared_ptr<const Yardstick> by, EngineConfig model, Json about)
      : by_(std::move(by)), model_(std::move(model)), about_(std::move(about)) {}

  Row row() {
    const Case& asked = by_->asked();
    const Yardstick::Reading reading = by_->read(model_);
    able_ = reading.status == Status::ok;
    Row row;
    row.values = {{"scenario", asked.scenario->name}, {"variant", asked.variant}};
    row.values.update(about_);
    row.values.update({{"line", label_of(model_.engine->name, model_.method())},
                       {"status", name_of(reading.status)},
                       {"why", reading.reason},
                       {"error", number(reading.error)},
                       {"change", number(reading.change)},
                       {"within", by_->within(reading)},
                       {"duration", asked.scene->duration},
                       {"truth", by_->truth()},
                       {"truth_until", by_->truth_until()},
                       {"truth_error", by_->truth_error()},
                       {"compared_until", by_->compared_until()},
                       {"phases", by_->phases()}});
    Json choices = Json::array();
    for (const Choice& one : model_.engine->chooses(*asked.scene, model_.settings)) {
      choices.push_back({{"setting", one.option + "=" + one.value}, {"reason", one.reason}});
    }
    if (!choices.empty()) row.values["choices"] = std::move(choices);
    return row;
  }

  double time() const {
    if (!able_) return std::numeric_limits<double>::quiet_NaN();
    return step_cost(*by_->asked().scene, model_, by_->dt());
  }

 private:
  std::shared_ptr<const Yardstick> by_;
  EngineConfig model_;
  Json about_;
  bool able_ = false;
};

// s per simulated second, as far as the machine did nothing else.
double undisturbed_cost(const Yardstick& by, const EngineConfig& model) {
  constexpr double slow = 0.01;  // s, in which something else is always done
  const Scene& scene = *by.asked().scene;
  double least = step_cost(scene, model, by.dt());
  for (int i = 0; i < 2 && least * scene.duration < slow; ++i)
    least = std::min(least, step_cost(scene, model, by.dt()));
  return least;
}

// Of a's cost to b's; timed until `decided`.
Quartiles cost_ratio(const Yardstick& by, const EngineConfig& a, const EngineConfig& b,
                     const std::function<bool(const Quartiles&)>& decided) {
  constexpr std::size_t few = 4;
  constexpr std::size_t most = 15;
  return time_ratio([&] { return undisturbed_cost(by, a); }, [&] { return undisturbed_cost(by, b); }, few, most,
                    decided);
}

// A share of the cost that a drop must save, in three turns of four, to be worth it.
constexpr double worth = 0.03;

bool decided(const Quartiles& ratio) { return ratio.high < 1 - worth || ratio.low > 1 - worth; }
bool steady(const Quartiles& ratio) { return ratio.high - ratio.low < worth * ratio.median; }

Json json_of(const Quartiles& of) { return {{"median", of.median}, {"low", of.low}, {"high", of.high}}; }

// What is cheapest hangs on the clock, and so does everything that follows from it.
Row find_least(const Yardstick& by) {
  const EngineConfig& full = by.full();
  Row row;
  row.values = {{"scenario", by.asked().scenario->name}, {"variant", by.asked().variant}, {"role", "least"}};
  if (!by.within(by.read(full))) {
    row.values["why"] = "the full model itself does not run to the end";
    return row;
  }
  const auto ratio = [&](const Levels& a, const Levels& b) {
    return cost_ratio(by, model_at(full, a), model_at(full, b), decided);
  };
  const Trials trials{.sufficient = [&](const Levels& levels) { return by.within(by.read(model_at(full, levels))); },
                      .cost_ratio = [&](const Levels& a, const Levels& b) { return ratio(a, b).median; },
                      .cheaper = [&](const Levels& a, const Levels& b) { return ratio(a, b).high < 1 - worth; }};
  const std::vector<Drop> drops = single_drops(full);
  const Levels least = least_model(drops, model_features().size(), trials);
  const EngineConfig model = model_at(full, least);
  const Yardstick::Reading reading = by.read(model);
  row.times = {{"line", label_of(model.engine->name, model.method())},
               {"error", number(reading.error)},
               {"change", number(reading.change)},
               {"cheaper", json_of(cost_ratio(by, full, model, steady))},
               {"auto_cheaper", json_of(cost_ratio(by, full, choosing(full), steady))}};
  Json dropped = Json::array();
  for (std::size_t f = 0; f < least.size(); ++f) {
    if (least[f] == 0) continue;
    const Feature& feature = model_features()[f];
    dropped.push_back({{"feature", feature.name}, {"without", feature.rungs[least[f] - 1].without}});
  }
  row.times["dropped"] = std::move(dropped);
  return row;
}

std::vector<Point> points_of(const Json& configuration) {
  const EngineConfig full = full_of(configuration);
  const double dt = parse_dt(configuration.at("dt").get<std::string>());
  const double tolerance = tolerance_of(configuration);
  std::vector<Point> points;
  for (Case& one : cases_asked(configuration.at("scenarios"), configuration.at("all"), besides)) {
    const std::string place = one.scenario->name + "/" + one.variant;
    const auto by = std::make_shared<Yardstick>(std::move(one), full, dt, tolerance);
    const auto add = [&](const std::string& name, const EngineConfig& model, Json about) {
      const auto tried = std::make_shared<Tried>(by, model, std::move(about));
      points.push_back({.key = fmt::format("model|{}|{}", place, name),
                        .run = [tried] { return tried->row(); },
                        .turn = [tried] { return tried->time(); },
                        .group = place,
                        .prepare = [by] { by->find(); }});
    };
    add("full", full, {{"role", "full"}});
    for (const Drop& drop : single_drops(full)) {
      Levels levels(model_features().size(), 0);
      levels[drop.feature] = drop.rung;
      const Feature& feature = model_features()[drop.feature];
      add(drop.setting, model_at(full, levels),
          {{"role", "drop"},
           {"feature", feature.name},
           {"without", feature.rungs[drop.rung - 1].without},
           {"setting", drop.setting}});
    }
    add("auto", choosing(full), {{"role", "auto"}});
    points.push_back({.key = fmt::format("model|{}|least", place),
                      .run = [by] { return find_least(*by); },
                      .alone = true,
                      .prepare = [by] { by->find(); }});
  }
  return points;
}

Json configuration_of(const Asked& asked) {
  Json configuration{
      {"scenarios", asked.scenarios}, {"all", asked.all},
      {"engine", asked.engine},       {"dt", asked.dt},
      {"tolerance", asked.tolerance}, {"scenes", hash_of(cases_asked(asked.scenarios, asked.all, besides))}};
  must_differ(points_of(configuration));
  return configuration;
}

const Catalog<Study>::Entry model_entry{
    {.name = "model",
     .about = "The least model that a scene needs: what each feature is worth, in error and in cost",
     .examples = "  plumb study model                                   one scene of each kind\n"
                 "  plumb study model --scenarios gas rain              some scenarios\n"
                 "  plumb study model --tolerance 1e-3 --dt 1/30        coarser\n"
                 "  plumb study model --engine impulse:substeps=8       another full model\n",
     .attach = [](CLI::App& app) -> std::function<Json()> {
       const auto asked = std::make_shared<Asked>();
       app.add_option("--scenarios", asked->scenarios, "NAME, NAME:LABEL or NAME:parameter=value,...")
           ->type_name("NAME");
       app.add_flag("--all", asked->all, "Every scenario");
       app.add_option("--tolerance", asked->tolerance, "m, by which a model may be worse than the full one")
           ->capture_default_str()
           ->type_name("M");
       app.add_option("--engine", asked->engine, "The full model: impulse[:key=value,...]")
           ->capture_default_str()
           ->type_name("ENGINE");
       app.add_option("--dt", asked->dt, "Time step in s, a number or a fraction")
           ->capture_default_str()
           ->type_name("STEP");
       return [asked] { return configuration_of(*asked); };
     },
     .plan = [](const Json& configuration) -> StudyPlan {
       return {points_of(configuration), model_findings};
     },
     .brief = {{"--scenarios", "free-bodies", "flush-tiles:smooth", "stacking:one"}}}};

}  // namespace
}  // namespace plumb
