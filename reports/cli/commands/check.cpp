#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>

#include "reports/cli/command_line.h"
#include "reports/gate/baseline.h"
#include "reports/gate/options.h"
#include "reports/gate/result.h"
#include "reports/gate/timing.h"
#include "reports/gate/writers.h"
#include "reports/system/files.h"
#include "scenarios/catalog.h"

namespace plumb::commands::check {
namespace {

constexpr std::size_t shown = 10;  // regressions; the files have all of them

struct Check {
  GateOptions gate;
  std::vector<std::string> against;
  TimingOptions times;
  std::map<std::string, std::string> files;  // by writer; "-": standard output
  bool quiet = false;

  bool on_standard_output() const {
    return std::ranges::any_of(files, [](const auto& file) { return file.second == "-"; });
  }
};

Baseline baseline_of_set(const std::string& file) {
  if (std::filesystem::exists(file)) return read_baseline(file);
  throw std::invalid_argument(file + ": there is no baseline; `plumb accept` makes one from the current results");
}

Baseline before(const Check& options) {
  return options.against.empty() ? baseline_of_set(options.gate.baseline_file())
                                 : read_results(options.against.front());
}

GateResult result_of(const Check& options) {
  if (options.against.size() == 2) return compare(before(options), read_results(options.against.back()));
  const Baseline accepted = before(options);
  const Plan plan = plan_of(accepted, options.gate);
  GateResult result = compare(selected(accepted, options.gate, plan), run_plan(plan));
  if (options.gate.engines.empty() && options.against.empty() && accepted.all) {
    for (const std::string& engine : engines_missing_in(accepted))
      result.notes.push_back(fmt::format("Not gated: {}, which the baseline does not have.", engine));
  }
  return result;
}

std::optional<TimingReport> times_of(const Check& options) {
  if (options.times.against.empty()) return std::nullopt;
  if (options.against.size() == 2)
    throw std::invalid_argument("--time-against: with two results nothing runs, so nothing can be timed");
  const Baseline accepted = before(options);
  GateOptions gate = options.gate;
  if (gate.scenarios.empty()) gate.canonical |= accepted.all;  // to time every case takes hours
  const Plan plan = plan_of(accepted, gate);
  return time_against(options.times, plan.cases, plan.dt);
}

void print(const Check& options, const GateResult& result, bool as_accepted, const std::optional<TimingReport>& times) {
  fmt::print("{}", text_of(result, shown));
  if (!as_accepted && options.against.empty())
    fmt::print("If this is intended: plumb accept, with the same options.\n");
  if (times) fmt::print("{}", timing_text(*times));
}

int check(const Check& options) {
  std::vector<std::pair<const GateWriter*, NewFile>> files;
  for (const auto& [name, path] : options.files) {
    if (path.empty() || path == "-") continue;
    files.emplace_back(Catalog<GateWriter>::find(name), path);
    if (std::filesystem::is_directory(path) || !files.back().second.write("")) {
      throw std::invalid_argument("--" + name + ": \"" + path + "\" cannot be written");
    }
  }
  const std::optional<TimingReport> times = times_of(options);
  GateResult result = result_of(options);
  const bool as_accepted = result.passed();
  if (times) add_times(result, *times, options.times.engine);
  for (auto& [writer, file] : files) {
    file.write_all(writer->text(result));
    file.put_in_place();
  }
  for (const auto& [name, path] : options.files) {
    if (path == "-") fmt::print("{}", Catalog<GateWriter>::find(name)->text(result));
  }
  if (!options.quiet && !options.on_standard_output()) print(options, result, as_accepted, times);
  return result.passed() ? 0 : 1;
}

const Catalog<Command>::Entry entry{
    {.name = "check",
     .about = "Compare with the accepted baseline; exit code 1 if anything is not as accepted",
     .examples = "  plumb check                                  every case, in less than a minute\n"
                 "  plumb check --canonical                      the canonical scenarios, in seconds\n"
                 "  plumb check bounce --engine impulse          some of the baseline\n"
                 "  plumb check --junit check.xml --markdown check.md    for CI and pull requests\n"
                 "  plumb check --json -                         the result as JSON, on standard output\n"
                 "  plumb check --against old/report.json        against the results of another build\n"
                 "  plumb check --against old/report.json new/report.json    two results; nothing runs\n"
                 "  plumb check --time-against old/plumb         also: steps take no longer than in another build\n",
     .attach = [](CLI::App& app) {
       const auto options = std::make_shared<Check>();
       options->gate.attach_to(app);
       app.add_option("--against", options->against,
                      "A report.json or a baseline to compare with instead; a second one is compared with the first")
           ->expected(1, 2)
           ->type_name("FILE");
       options->times.attach_to(app);
       for (const GateWriter* writer : Catalog<GateWriter>::all()) {
         app.add_option("--" + writer->name, options->files[writer->name],
                        "Write " + writer->about + "; -: print it instead")
             ->type_name("FILE");
       }
       app.add_flag("--quiet", options->quiet, "Print nothing: the exit code says it all");
       return [options] { return check(*options); };
     }}};

}  // namespace
}  // namespace plumb::commands::check
