#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "reports/cli/command_line.h"
#include "reports/cli/session.h"
#include "reports/compare/divergence.h"
#include "reports/run/run.h"
#include "reports/run/scene_file.h"
#include "reports/run/selection.h"
#include "reports/system/files.h"
#include "scenarios/catalog.h"

namespace plumb::commands::diff {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string scenario, a, b;
  std::string dt = "1/60";
  std::string tolerance;
  std::string json;
};

// A run and its side of the comparison.
struct Contestant {
  EngineConfig config;
  Outcome outcome;
  ComparedRun side;

  bool failed() const { return outcome.status == Status::failed; }
  // Whether there is something to compare.
  bool steps() const { return outcome.trace && outcome.trace->size() > 1; }
};

EngineConfig config_of(const std::string& word, const Case& options) {
  if (word != "exact") return parse_engine(word);
  if (options.closed_form == nullptr) throw std::invalid_argument(options.scenario->name + " has no closed form");
  return {options.closed_form, complete(*options.closed_form, {})};
}

Contestant run_of(const std::string& word, const Case& options, double dt) {
  const EngineConfig config = config_of(word, options);
  Contestant one{config, run(*options.scene, config, dt), {}};
  one.side.name = word;
  if (one.steps()) {
    one.side.trace = one.outcome.trace.get();
    one.side.stepping = config.engine->stepping(config.settings, dt);
  } else if (!one.failed()) {
    throw std::invalid_argument(
        fmt::format("{} does not run {}: {}", word, options.scenario->name,
                    one.outcome.reason.empty() ? "its closed form ends before the first step" : one.outcome.reason));
  }
  return one;
}

std::optional<double> tolerance_of(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const double tolerance = parse_number("--tolerance", text);
  if (tolerance >= 0) return tolerance;
  throw std::invalid_argument("--tolerance: \"" + text + "\" must not be below 0");
}

std::string number(const std::optional<double>& value) { return value ? fmt::format("{:.12g}", *value) : "-"; }

std::string row(const ValueDifference& figure) {
  const bool both = figure.a && figure.b;
  return fmt::format("  {:<44}{:>20}{:>20}{:>12}{:>12}\n",
                     figure.what + (figure.unit.empty() ? "" : ", " + figure.unit), number(figure.a), number(figure.b),
                     both ? fmt::format("{:.3g}", figure.difference) : "-", fmt::format("{:.2g}", figure.tolerance));
}

std::string text_of(const Options& options, const TraceComparison& compared) {
  const std::string why = options.tolerance.empty() ? "round-off explains" : "the tolerance is";
  if (!compared.divergence) {
    return fmt::format(
        "{} and {} never diverge in {} steps ({:.4g} s): the largest difference is {}, {:.3g} {}; {} {:.2g}.\n",
        options.a, options.b, compared.steps, compared.until, compared.largest.what, compared.largest.difference,
        compared.largest.unit, why, compared.largest.tolerance);
  }
  const Divergence& divergence = *compared.divergence;
  std::string text =
      fmt::format("{} and {} diverge in step {} of {} ({:.4g} s): {} differs by {:.3g} {}; {} {:.2g}.\n", options.a,
                  options.b, divergence.step, compared.steps, divergence.time, divergence.first.what,
                  divergence.first.difference, divergence.first.unit, why, divergence.first.tolerance);
  text += fmt::format("Stage: {}. {}\n\n", name_of(divergence.stage), divergence.advice);
  text += fmt::format("  {:<44}{:>20}{:>20}{:>12}{:>12}\n", fmt::format("after step {}", divergence.step), "first",
                      "second", "apart", "tolerance");
  for (const ValueDifference& figure : divergence.values) text += row(figure);
  text += fmt::format("\n  {:>13}{:>8}{:>10}{:>12} {}\n", "grown to", "step", "s", "apart,", divergence.first.unit);
  for (const DivergenceGrowth& growth : divergence.growth) {
    text += fmt::format("  {:>12.4g}x{:>8}{:>10.4g}{:>12.3g}{}\n", growth.factor, growth.step, growth.time,
                        growth.difference, growth.step == compared.steps ? " at the end" : "");
  }
  return text;
}

Json json_of(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json json_of(const ValueDifference& figure) {
  return {{"what", figure.what},
          {"unit", figure.unit},
          {"a", json_of(figure.a)},
          {"b", json_of(figure.b)},
          {"difference", figure.difference},
          {"tolerance", figure.tolerance}};
}

Json json_of(const Divergence& divergence) {
  Json figures = Json::array();
  for (const ValueDifference& figure : divergence.values) figures.push_back(json_of(figure));
  Json growth = Json::array();
  for (const DivergenceGrowth& one : divergence.growth) {
    growth.push_back({{"factor", one.factor}, {"step", one.step}, {"time", one.time}, {"difference", one.difference}});
  }
  return {{"step", divergence.step}, {"time", divergence.time},     {"stage", name_of(divergence.stage)},
          {"body", divergence.body}, {"other", divergence.other},   {"first", json_of(divergence.first)},
          {"figures", figures},      {"advice", divergence.advice}, {"growth", growth}};
}

Json json_of(const Options& options, const TraceComparison& compared, const std::vector<const Contestant*>& failed,
             double dt) {
  Json failures = Json::array();
  for (const Contestant* one : failed) {
    failures.push_back({{"engine", one->side.name}, {"reason", one->outcome.reason}});
  }
  return {{"scenario", options.scenario},
          {"a", options.a},
          {"b", options.b},
          {"dt", dt},
          {"steps", compared.steps},
          {"until", compared.until},
          {"largest", compared.divergence || compared.steps == 0 ? Json(nullptr) : json_of(compared.largest)},
          {"divergence", compared.divergence ? json_of(*compared.divergence) : Json(nullptr)},
          {"failed", failures}};
}

int diff(const Options& options) {
  const double dt = parse_dt(options.dt);
  const std::optional<double> tolerance = tolerance_of(options.tolerance);
  const Case one = is_scene_file(options.scenario) ? case_of_file(options.scenario) : parse_case(options.scenario);
  warn_about_files({&one, 1});
  std::optional<NewFile> file;
  const bool prints_json = options.json == "-";
  if (!options.json.empty() && !prints_json) {
    file.emplace(options.json);
    if (std::filesystem::is_directory(options.json) || !file->write(""))
      throw std::invalid_argument("--json: \"" + options.json + "\" cannot be written");
  }
  const Contestant a = run_of(options.a, one, dt);
  const Contestant b = run_of(options.b, one, dt);
  std::vector<const Contestant*> failed{&a, &b};
  std::erase_if(failed, [](const Contestant* contestant) { return !contestant->failed(); });
  TraceComparison compared;
  if (a.steps() && b.steps()) compared = compare_traces(*one.scene, a.side, b.side, tolerance);
  const std::string json = json_of(options, compared, failed, dt).dump(1) + "\n";
  if (prints_json) {
    fmt::print("{}", json);
  } else if (compared.steps > 0) {
    fmt::print("{}", text_of(options, compared));
  }
  for (const Contestant* contestant : failed) {
    fmt::print(prints_json ? stderr : stdout, "{} failed: {}\n", contestant->side.name, contestant->outcome.reason);
  }
  if (file) {
    file->write_all(json);
    file->put_in_place();
  }
  return compared.divergence || !failed.empty() ? 1 : 0;
}

const Catalog<Command>::Entry entry{
    {.name = "diff",
     .about = "Find the first step in which two runs diverge, and why; exit code 0 if they never do, 1 if they do",
     .examples = "  plumb diff spring impulse:integrator=rk4 impulse:integrator=explicit-euler   two methods\n"
                 "  plumb diff stacking impulse impulse:solver=article                           two solvers\n"
                 "  plumb diff bounce:e=0.5 impulse box2d --tolerance 0.01                       two engines\n"
                 "  plumb diff mine.json box2d exact --dt 1/240 --json diff.json                 an engine and the "
                 "closed form\n",
     .attach = [](CLI::App& app) {
       const auto options = std::make_shared<Options>();
       app.add_option("scenario", options->scenario, "NAME, NAME:LABEL, NAME:parameter=value,... or FILE.json")
           ->required()
           ->type_name("SCENARIO");
       app.add_option("first", options->a, "NAME[:key=value,...], or exact for the closed form")
           ->required()
           ->type_name("ENGINE");
       app.add_option("second", options->b, "The same")->required()->type_name("ENGINE");
       app.add_option("--dt", options->dt, "Time step in s, a number or a fraction")
           ->capture_default_str()
           ->type_name("STEP");
       app.add_option("--tolerance", options->tolerance,
                      "In m, rad, m/s and rad/s alike; default: what round-off explains")
           ->type_name("T");
       app.add_option("--json", options->json, "Write the same to a file, as JSON; -: print it instead")
           ->type_name("FILE");
       return [options] { return diff(*options); };
     }}};

}  // namespace
}  // namespace plumb::commands::diff
