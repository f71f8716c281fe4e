#include <fmt/core.h>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>

#include "reports/cli/command.h"
#include "reports/gate/baseline_json.h"
#include "reports/gate/compare.h"
#include "reports/gate/timing.h"
#include "reports/gate/options.h"
#include "reports/gate/writers.h"
#include "reports/system/files.h"
#include "scenarios/catalog.h"

namespace plumb::commands::check {
namespace {

constexpr std::size_t shown = 10;  // regressions; the files have them all

struct Check {
  GateOptions gate;
  std::vector<std::string> against;
  TimingOptions times;
  std::map<std::string, std::string> files;  // by writer
};

Baseline baseline_of_set(const std::string& file) {
  if (std::filesystem::exists(file)) return read_baseline(file);
  throw std::invalid_argument(file + ": there is no baseline; `plumb accept` makes one of what runs give now");
}

Baseline before(const Check& asked) {
  return asked.against.empty() ? baseline_of_set(asked.gate.baseline_file()) : read_results(asked.against.front());
}

GateResult result_of(const Check& asked) {
  if (asked.against.size() == 2) return compare(before(asked), read_results(asked.against.back()));
  const Baseline accepted = before(asked);
  const Plan plan = plan_of(accepted, asked.gate);
  return compare(selected(accepted, asked.gate, plan), run_plan(plan));
}

std::optional<TimingReport> times_of(const Check& asked) {
  if (asked.times.against.empty()) return std::nullopt;
  if (asked.against.size() == 2)
    throw std::invalid_argument("--time-against: with two results nothing is run, and so nothing timed");
  const Plan plan = plan_of(before(asked), asked.gate);
  return time_against(asked.times, plan.cases, plan.dt);
}

int check(const Check& asked) {
  std::vector<std::pair<const GateWriter*, NewFile>> files;
  for (const auto& [name, path] : asked.files) {
    if (path.empty()) continue;
    files.emplace_back(Catalog<GateWriter>::find(name), path);
    if (std::filesystem::is_directory(path) || !files.back().second.write("")) {
      throw std::invalid_argument("--" + name + ": \"" + path + "\" cannot be written");
    }
  }
  const std::optional<TimingReport> times = times_of(asked);
  GateResult result = result_of(asked);
  const bool as_accepted = result.passed();
  if (times) add_times(result, *times, asked.times.engine);
  for (auto& [writer, file] : files) {
    if (!file.write(writer->text(result))) throw std::runtime_error("--" + writer->name + ": the disk is full");
    file.put_in_place();
  }
  fmt::print("{}", text_of(result, shown));
  if (!as_accepted && asked.against.empty())
    fmt::print("If this is as it should be: plumb accept, with the same options.\n");
  if (times) fmt::print("{}", timing_text(*times));
  return result.passed() ? 0 : 1;
}

const Catalog<Command>::Entry entry{
    {.name = "check",
     .about = "Compare with the accepted baseline; exit code 1 when anything is not as accepted",
     .examples =
         "  plumb check                                  the canonical scenarios\n"
         "  plumb check --all                            every scenario, against a baseline of all\n"
         "  plumb check bounce --engine impulse          some of the baseline\n"
         "  plumb check --junit check.xml --markdown check.md    for CI and pull requests\n"
         "  plumb check --against old/report.json        against the results of another build\n"
         "  plumb check --against old/report.json new/report.json    two results, nothing is run\n"
         "  plumb check --time-against old/plumb         and steps take no longer than those of another build\n",
     .attach = [](CLI::App& app) {
       const auto asked = std::make_shared<Check>();
       asked->gate.attach_to(app);
       app.add_option("--against", asked->against,
                      "A report.json or a baseline to compare with instead; a second one is compared with the first")
           ->expected(1, 2)
           ->type_name("FILE");
       asked->times.attach_to(app);
       for (const GateWriter* writer : Catalog<GateWriter>::all()) {
         app.add_option("--" + writer->name, asked->files[writer->name], "Write " + writer->about)->type_name("FILE");
       }
       return [asked] { return check(*asked); };
     }}};

}  // namespace
}  // namespace plumb::commands::check
