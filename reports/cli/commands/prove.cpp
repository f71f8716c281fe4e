#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "reports/cli/command_line.h"
#include "reports/prove/controls.h"
#include "reports/prove/prove.h"
#include "reports/prove/report.h"
#include "reports/run/selection.h"
#include "reports/system/files.h"
#include "reports/system/jobs.h"
#include "reports/system/terminal.h"
#include "scenarios/scene/nearest.h"

namespace plumb::commands::prove_command {
namespace {

struct Options {
  std::vector<std::string> names;  // of faults, controls or parameters
  std::vector<std::string> scenarios;
  int clean = 10;
  bool controls = false;
  std::vector<std::string> statements{"impulse"};
  bool sensitivity = false;
  bool markdown = false;
  std::string dt = "1/60";
  std::string out;
  int jobs = default_jobs();
};

// Those of `all` that the words name; all of them if there is no word.
template <class Named>
std::vector<Named> chosen_from(const std::vector<Named>& all, const std::string& kind,
                               const std::vector<std::string>& words) {
  if (words.empty()) return all;
  std::vector<std::string> names;
  for (const Named& one : all) names.push_back(one.name);
  std::vector<Named> chosen;
  for (const std::string& word : words) {
    const auto found = std::find(names.begin(), names.end(), word);
    if (found == names.end()) throw std::invalid_argument(unknown(kind, word, names));
    chosen.push_back(all[static_cast<std::size_t>(found - names.begin())]);
  }
  return chosen;
}

std::vector<Case> cases_of(const std::vector<std::string>& words) {
  std::vector<Case> cases;
  for (const std::string& word : words) {
    for (Case& one : parse_cases(word)) cases.push_back(std::move(one));
  }
  return cases;
}

// The file of --out, which is put in place when everything has run.
class Output {
 public:
  explicit Output(const std::string& path) : path_(path) {
    if (path.empty()) return;
    file_.emplace(path);
    if (std::filesystem::is_directory(path) || !file_->write("")) refuse();
  }
  void finish(const nlohmann::ordered_json& json) {
    if (!file_) return;
    file_->write_all(json.dump(1) + "\n");
    file_->put_in_place();
  }

 private:
  [[noreturn]] void refuse() const { throw std::invalid_argument("--out: \"" + path_ + "\" cannot be written"); }
  std::string path_;
  std::optional<NewFile> file_;
};

Progress shown_on(const ProgressLine& line) {
  return [&line](const std::string& what, std::size_t done, std::size_t of) {
    line.show(fmt::format("[{}/{}] {}", done + 1, of, what));
  };
}

int prove_faults(const Options& options) {
  const double dt = parse_dt(options.dt);
  const std::vector<Fault> faults = chosen_from(all_faults(), "fault", options.names);
  const std::vector<Case> all = options.scenarios.empty() ? default_cases(true) : cases_of(options.scenarios);
  const std::vector<Case> cases = options.scenarios.empty() ? cases_to_prove_by(all, dt) : all;
  CaseTruths truths(dt);
  Output output(options.out);
  ProveReport report;
  {
    const ProgressLine line;
    report.faults = prove(faults, cases, truths, options.jobs, shown_on(line));
    if (options.clean > 0) {
      report.clean = clean_runs(options.clean, cases, truths, options.jobs, shown_on(line));
      // The cases that are too large to be run for every fault as well.
      report.clean.insert(report.clean.begin(), default_run(all, truths, options.jobs, shown_on(line)));
    }
  }
  report.cases = cases.size();
  fmt::print("{}", text_of(report));
  output.finish(to_json(report));
  return report.passed() ? 0 : 1;
}

int measure_sensitivity(const Options& options) {
  const double dt = parse_dt(options.dt);
  const auto parameters = chosen_from(all_perturbations(), "parameter", options.names);
  const std::vector<Case> cases =
      options.scenarios.empty() ? cases_to_prove_by(default_cases(true), dt) : cases_of(options.scenarios);
  CaseTruths truths(dt);
  Output output(options.out);
  SensitivityReport report{.statements = engine_statements(), .cases = cases.size(), .dt = dt};
  {
    const ProgressLine line;
    report.found = sensitivities(parameters, cases, report.statements, truths, options.jobs, shown_on(line));
  }
  fmt::print("{}", options.markdown ? markdown_of(report) : text_of(report));
  output.finish(to_json(report));
  return report.passed() ? 0 : 1;
}

int prove_by_controls(const Options& options) {
  CaseTruths truths(parse_dt(options.dt));
  std::vector<Control> all;
  for (const Control* control : Catalog<Control>::all()) all.push_back(*control);
  const std::vector<Control> controls = chosen_from(all, "control", options.names);
  const std::vector<Case> cases = options.scenarios.empty() ? default_cases(true) : cases_of(options.scenarios);
  std::vector<EngineConfig> stated;
  for (const std::string& word : options.statements) stated.push_back(parse_engine(word));
  Output output(options.out);
  std::vector<ControlReport> reports;
  {
    const ProgressLine line;
    reports = prove_controls(controls, cases, stated, truths, options.jobs, shown_on(line));
  }
  std::size_t passes = 0;
  for (const ControlReport& report : reports) {
    fmt::print("{}{}", &report == &reports.front() ? "" : "\n", text_of(report, !options.names.empty()));
    passes += report.passes();
  }
  output.finish(to_json(reports));
  return passes == 0 ? 0 : 1;
}

const Catalog<Command>::Entry entry{
    {.name = "prove",
     .about = "Test the harness: every fault in our engine must be caught, and the unharmed engine raise no alarm; "
              "with --controls, no engine without mechanics may be right; exit code 1 if not",
     .examples = "  plumb prove                                  every fault, and 10 runs of the unharmed engine\n"
                 "  plumb prove --sensitivity --out fine.json    the smallest error seen in each parameter\n"
                 "  plumb prove --clean 100 --out prove.json     more clean runs, and all figures as JSON\n"
                 "  plumb prove gravity-twice energy-leak --scenario bounce --clean 0\n"
                 "  plumb prove --controls                       every control, judged by what our engine states\n"
                 "  plumb prove --controls frozen                what became of one in each case\n"
                 "  plumb prove --controls --statement impulse --statement box2d\n",
     .attach = [](CLI::App& app) {
       const auto options = std::make_shared<Options>();
       app.add_option("name", options->names,
                      "Names of faults, with --controls of controls, or with --sensitivity of parameters; default: all")
           ->type_name("NAME");
       app.add_option("--scenario", options->scenarios,
                      "NAME, NAME:LABEL or NAME:parameter=value,...; may be repeated. Default: all small ones, with "
                      "--controls all")
           ->allow_extra_args(false)
           ->type_name("NAME");
       CLI::Option* controls = app.add_flag(
           "--controls", options->controls,
           "Run engines that lack a law of mechanics (frozen, weightless ...) instead of faults; none may be right or "
           "plausible where the law matters");
       app.add_option(
              "--statement", options->statements,
              "Engine by whose stated errors controls are judged, as --engine of plumb run takes it; may be repeated")
           ->needs(controls)
           ->allow_extra_args(false)
           ->capture_default_str()
           ->type_name("ENGINE");
       app.add_option(
              "--clean", options->clean,
              "Runs of the unharmed engine with other seeds, precisions, threads, lanes and broad phases, besides one "
              "as it is; any check that one fails is a false alarm. 0: none at all")
           ->capture_default_str()
           ->check(CLI::Range(0, 100000))
           ->excludes(controls)
           ->type_name("N");
       CLI::Option* sensitivity = app.add_flag("--sensitivity", options->sensitivity,
                                               "Instead: the smallest error in each parameter of our engine that some "
                                               "case calls wrong, by our own, Box2D's "
                                               "and Chipmunk's statements; exit code 1 if it misses its goal");
       app.add_flag("--markdown", options->markdown, "Print the sensitivities as a Markdown table")->needs(sensitivity);
       sensitivity->excludes(controls);
       app.add_option("--dt", options->dt, "Time step in s, a number or a fraction")
           ->capture_default_str()
           ->type_name("STEP");
       app.add_option("--jobs", options->jobs, "Runs at the same time; results are the same for any number")
           ->capture_default_str()
           ->check(CLI::Range(1, 1024))
           ->type_name("N");
       app.add_option("--out", options->out, "File for all figures as JSON")->type_name("FILE");
       return [options] {
         if (options->controls) return prove_by_controls(*options);
         return options->sensitivity ? measure_sensitivity(*options) : prove_faults(*options);
       };
     }}};

}  // namespace
}  // namespace plumb::commands::prove_command
