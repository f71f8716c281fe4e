#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "reports/cli/command.h"
#include "reports/prove/prove.h"
#include "reports/prove/report.h"
#include "reports/prove/sensitivity_report.h"
#include "reports/run/selection.h"
#include "reports/system/files.h"
#include "reports/system/jobs.h"
#include "reports/system/terminal.h"
#include "scenarios/scene/nearest.h"

namespace plumb::commands::prove_command {
namespace {

struct Options {
  std::vector<std::string> faults;
  std::vector<std::string> scenarios;
  int clean = 10;
  bool sensitivity = false;
  bool markdown = false;
  std::string dt = "1/60";
  std::string out;
  int jobs = default_jobs();
};

// Those of all that have the given names, or all if there are none.
template <class Named>
std::vector<Named> chosen_from(const std::vector<Named>& all, const char* what, const std::vector<std::string>& words) {
  if (words.empty()) return all;
  std::vector<std::string> names;
  for (const Named& one : all) names.push_back(one.name);
  std::vector<Named> chosen;
  for (const std::string& word : words) {
    const auto found = std::find(names.begin(), names.end(), word);
    if (found == names.end()) throw std::invalid_argument(unknown(what, word, names));
    chosen.push_back(all[static_cast<std::size_t>(found - names.begin())]);
  }
  return chosen;
}

std::vector<Case> cases_of(const std::vector<std::string>& words, double dt) {
  if (words.empty()) return cases_to_prove_by(dt);
  std::vector<Case> cases;
  for (const std::string& word : words) {
    for (Case& one : parse_cases(word)) cases.push_back(std::move(one));
  }
  return cases;
}

// The file for all figures, opened before anything runs; none if none is asked for.
std::optional<NewFile> opened(const std::string& out) {
  if (out.empty()) return std::nullopt;
  NewFile file(out);
  if (std::filesystem::is_directory(out) || !file.write(""))
    throw std::invalid_argument("--out: \"" + out + "\" cannot be written");
  return file;
}

void finish(std::optional<NewFile>& file, const std::string& out, const nlohmann::ordered_json& figures) {
  if (!file) return;
  if (!file->write(figures.dump(1) + "\n")) throw std::invalid_argument("--out: \"" + out + "\" cannot be written");
  file->put_in_place();
}

int measure_sensitivity(const Options& options) {
  const double dt = parse_dt(options.dt);
  const auto parameters = chosen_from(all_perturbations(), "parameter", options.faults);
  const std::vector<Case> cases = cases_of(options.scenarios, dt);
  std::optional<NewFile> file = opened(options.out);
  SensitivityReport report{.statements = engine_statements(), .cases = cases.size(), .dt = dt};
  {
    const ProgressLine line;
    const auto show = [&](const std::string& what, std::size_t done, std::size_t of) {
      line.show(fmt::format("[{}/{}] {}", done + 1, of, what));
    };
    report.found = sensitivities(parameters, cases, report.statements, dt, options.jobs, show);
  }
  fmt::print("{}", options.markdown ? markdown_of(report) : text_of(report));
  finish(file, options.out, to_json(report));
  return report.passed() ? 0 : 1;
}

int prove_harness(const Options& options) {
  if (options.sensitivity) return measure_sensitivity(options);
  const double dt = parse_dt(options.dt);
  const auto faults = chosen_from(all_faults(), "fault", options.faults);
  const std::vector<Case> cases = cases_of(options.scenarios, dt);
  std::optional<NewFile> file = opened(options.out);
  ProveReport report;
  {
    const ProgressLine line;
    const auto show = [&](const std::string& what, std::size_t done, std::size_t of) {
      line.show(fmt::format("[{}/{}] {}", done + 1, of, what));
    };
    report.faults = prove(faults, cases, dt, options.jobs, show);
    report.clean = clean_runs(options.clean, cases, dt, options.jobs, show);
  }
  report.cases = cases.size();
  fmt::print("{}", text_of(report));
  finish(file, options.out, to_json(report));
  return report.passed() ? 0 : 1;
}

const Catalog<Command>::Entry entry{
    {.name = "prove",
     .about = "Test the harness: every fault in our engine must be caught, and the unharmed engine raise no alarm; "
              "exit code 1 if not",
     .examples = "  plumb prove                                  every fault, and 10 runs of the unharmed engine\n"
                 "  plumb prove --sensitivity --out fine.json    the smallest error seen in each parameter\n"
                 "  plumb prove --clean 100 --out prove.json     more clean runs, and all figures as JSON\n"
                 "  plumb prove gravity-twice energy-leak --scenario bounce --clean 0\n",
     .attach = [](CLI::App& app) {
       const auto options = std::make_shared<Options>();
       app.add_option("fault", options->faults, "Names of faults or, with --sensitivity, of parameters; default: all")
           ->type_name("FAULT");
       app.add_option("--scenario", options->scenarios,
                      "NAME, NAME:LABEL or NAME:parameter=value,...; may be repeated. Default: all small ones")
           ->allow_extra_args(false)
           ->type_name("NAME");
       app.add_option(
              "--clean", options->clean,
              "Runs of the unharmed engine with other seeds, precisions, threads, lanes and broad phases; none may "
              "raise an alarm")
           ->capture_default_str()
           ->check(CLI::Range(0, 100000))
           ->type_name("N");
       CLI::Option* sensitivity = app.add_flag("--sensitivity", options->sensitivity,
                                               "Instead: the smallest error in each parameter of our engine that some "
                                               "case calls wrong, by our own, Box2D's "
                                               "and Chipmunk's statements; exit code 1 if it misses its goal");
       app.add_flag("--markdown", options->markdown, "Print the sensitivities as a Markdown table")->needs(sensitivity);
       app.add_option("--dt", options->dt, "Time step in s, a number or a fraction")
           ->capture_default_str()
           ->type_name("STEP");
       app.add_option("--jobs", options->jobs, "Runs at the same time; results are the same for any number")
           ->capture_default_str()
           ->check(CLI::Range(1, 1024))
           ->type_name("N");
       app.add_option("--out", options->out, "File for all figures as JSON")->type_name("FILE");
       return [options] { return prove_harness(*options); };
     }}};

}  // namespace
}  // namespace plumb::commands::prove_command
