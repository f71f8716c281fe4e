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
  std::string dt = "1/60";
  std::string out;
  int jobs = default_jobs();
};

std::vector<Fault> faults_of(const std::vector<std::string>& words) {
  std::vector<Fault> all = all_faults();
  if (words.empty()) return all;
  std::vector<std::string> names;
  for (const Fault& fault : all) names.push_back(fault.name);
  std::vector<Fault> chosen;
  for (const std::string& word : words) {
    const auto found = std::find(names.begin(), names.end(), word);
    if (found == names.end()) throw std::invalid_argument(unknown("fault", word, names));
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

int prove_harness(const Options& options) {
  const double dt = parse_dt(options.dt);
  const std::vector<Fault> faults = faults_of(options.faults);
  const std::vector<Case> cases = cases_of(options.scenarios, dt);
  std::optional<NewFile> file;
  if (!options.out.empty()) {
    file.emplace(options.out);
    if (std::filesystem::is_directory(options.out) || !file->write(""))
      throw std::invalid_argument("--out: \"" + options.out + "\" cannot be written");
  }
  ProveReport report;
  {
    const ProgressLine line;
    const auto show = [&](const std::string& what, std::size_t done, std::size_t of) {
      line.show(fmt::format("[{}/{}] {}", done + 1, of, what));
    };
    report.faults = prove(faults, cases, dt, options.jobs, show);
    if (options.clean > 0) {
      // The cases that are too large to be run for every fault as well.
      const std::vector<Case> all = options.scenarios.empty() ? default_cases(true) : cases;
      report.clean = clean_runs(options.clean, cases, dt, options.jobs, show);
      report.clean.insert(report.clean.begin(), default_run(all, dt, options.jobs, show));
    }
  }
  report.cases = cases.size();
  fmt::print("{}", text_of(report));
  if (file) {
    if (!file->write(to_json(report).dump(1) + "\n")) {
      throw std::invalid_argument("--out: \"" + options.out + "\" cannot be written");
    }
    file->put_in_place();
  }
  return report.passed() ? 0 : 1;
}

const Catalog<Command>::Entry entry{
    {.name = "prove",
     .about = "Test the harness: every fault in our engine must be caught, and the unharmed engine raise no alarm; "
              "exit code 1 if not",
     .examples = "  plumb prove                                  every fault, and 10 runs of the unharmed engine\n"
                 "  plumb prove --clean 100 --out prove.json     more clean runs, and all figures as JSON\n"
                 "  plumb prove gravity-twice energy-leak --scenario bounce --clean 0\n",
     .attach = [](CLI::App& app) {
       const auto options = std::make_shared<Options>();
       app.add_option("fault", options->faults, "Names of faults; default: all")->type_name("FAULT");
       app.add_option("--scenario", options->scenarios,
                      "NAME, NAME:LABEL or NAME:parameter=value,...; may be repeated. Default: all small ones")
           ->allow_extra_args(false)
           ->type_name("NAME");
       app.add_option(
              "--clean", options->clean,
              "Runs of the unharmed engine with other seeds, precisions, threads, lanes and broad phases, besides one "
              "as it is; any check that one fails is a false alarm. 0: none at all")
           ->capture_default_str()
           ->check(CLI::Range(0, 100000))
           ->type_name("N");
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
