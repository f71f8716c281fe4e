#include "reports/gate/timing.h"

#include <fmt/format.h>

#include <optional>
#include <stdexcept>

#include "reports/run/selection.h"
#include "reports/statistics.h"
#include "reports/system/command_options.h"
#include "reports/system/files.h"
#include "reports/system/terminal.h"
#include "reports/timing/side_by_side.h"
#include "reports/timing/worker.h"
#include "scenarios/scene/scene_json.h"

namespace plumb {
namespace {

std::vector<TimedScene> timed_scenes(const std::vector<Case>& cases, double dt) {
  std::vector<TimedScene> scenes;
  for (const Case& one : cases) {
    const std::string& name = one.scenario->name;
    scenes.push_back({.name = one.variant.empty() ? name : name + ":" + one.variant,
                      .scene = write_scene({*one.scene, {}}),
                      .steps = steps_in(one.scene->duration, dt)});
  }
  return scenes;
}

SideBySide comparable_programs(const TimingOptions& options, const std::vector<Case>& cases, double dt) {
  parse_engine(options.engine);
  try {
    SideBySide sides(options.against, own_program(), timed_scenes(cases, dt), options.engine, dt);
    const std::string difference = machine_difference(sides.facts_before(), sides.facts_now());
    if (difference.empty()) return sides;
    throw std::invalid_argument(fmt::format(
        "{} runs on another machine ({}): times can only be compared on the same one", options.against, difference));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("--time-against: {}", error.what()));
  }
}

void write_times(NewFile& file, const TimingOptions& options, const std::string& text) {
  if (!file.write(text)) throw std::invalid_argument("--times: \"" + options.file + "\" cannot be written");
}

std::string step_time_text(const std::vector<double>& seconds) {
  return fmt::format("{:.4g} us a step", 1e6 * quartiles(seconds).median);
}

Regression time_regression(const RunKey& run, const JudgedTime& one, double least) {
  return {.run = run,
          .metric = "time",
          .before = step_time_text(one.pair.before.cpu),
          .now = step_time_text(one.pair.now.cpu),
          .tolerance = fmt::format("{:.1f} % more", 100 * least),
          .why = fmt::format("{:+.1f} %, by chance with p = {:.1g}", 100 * (one.time.ratio - 1), one.time.p),
          .rule = Rule::time,
          .change = Change::worse,
          .times = (one.time.ratio - 1) / least};
}

}  // namespace

void TimingOptions::attach_to(CLI::App& app) {
  CommandOptions add(app);
  add.add("--time-against", "PROGRAM", against,
          "Another build of plumb, for instance of the branch to merge into: the check fails if steps take longer "
          "than there, timed side by side");
  add.add("--time-engine", "ENGINE", engine, "NAME[:key=value,...], the engine to time");
  add.needs("--time-engine", "--time-against");
  add.add("--times", "FILE", file, "Also write the times, in the format of Google Benchmark");
  add.needs("--times", "--time-against");
}

TimingReport time_against(const TimingOptions& options, const std::vector<Case>& cases, double dt) {
  std::optional<NewFile> file;
  if (!options.file.empty()) write_times(file.emplace(options.file), options, "");
  const SideBySide sides = comparable_programs(options, cases, dt);
  TimingReport report{.program_before = options.against,
                      .program_now = own_program().string(),
                      .facts_before = sides.facts_before(),
                      .facts_now = sides.facts_now(),
                      .uncounted = sides.uncounted()};
  {
    const ProgressLine line;
    report.cases = judge_times(
        [&](std::span<const std::size_t> which, int rounds) {
          std::size_t done = 0;
          return sides.measure(which, rounds, [&](const std::string& name) {
            line.show(fmt::format("[{}/{}] times: {}", ++done, which.size() * static_cast<std::size_t>(rounds), name));
          });
        },
        cases.size(), report.rule);
  }
  report.load_after = timing_facts().at("load");
  if (file) {
    write_times(*file, options, timing_json(report));
    file->put_in_place();
  }
  return report;
}

void add_times(GateResult& result, const TimingReport& report, const std::string& engine) {
  std::size_t slower = 0;
  for (const JudgedTime& one : report.cases) {
    const RunKey run{.scenario = "time", .variant = one.pair.name, .engine = engine};
    result.runs.push_back(run);
    if (one.change == TimeChange::no_result)
      result.notes.push_back(one.pair.name + " was not timed: " + one.pair.no_result);
    if (one.change != TimeChange::slower) continue;
    ++slower;
    result.regressions.push_back(time_regression(run, one, report.rule.least));
  }
  result.verdict += slower == 0 ? "; no step takes longer"
                                : fmt::format("; steps take LONGER in {} of {} cases", slower, report.cases.size());
  sort(result.regressions);
}

}  // namespace plumb
