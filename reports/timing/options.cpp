#include "reports/timing/options.h"

#include <fmt/format.h>

#include <optional>
#include <stdexcept>
#include <utility>

#include "reports/run/selection.h"
#include "reports/system/files.h"
#include "reports/system/terminal.h"
#include "reports/timing/measure.h"
#include "reports/timing/pacer.h"

namespace plumb {
namespace {

SideBySide side_by_side(const TimingOptions& options, const std::vector<Case>& cases, double dt) {
  parse_engine(options.engine);
  try {
    SideBySide sides(options.against, own_program(), cases, options.engine, dt);
    const std::string other = other_machine(sides.facts_before(), sides.facts_now());
    if (other.empty()) return sides;
    throw std::invalid_argument(fmt::format(
        "{} runs on another machine ({}): times can only be judged side by side on one", options.against, other));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("--time-against: {}", error.what()));
  }
}

void write(NewFile& file, const TimingOptions& options, const std::string& text) {
  if (!file.write(text)) throw std::invalid_argument("--times: \"" + options.file + "\" cannot be written");
}

}  // namespace

void TimingOptions::attach_to(CLI::App& app) {
  app.add_option("--time-against", against,
                 "Another build of plumb, of the branch to merge into for instance: steps that take longer than there, "
                 "timed side by side, fail the check")
      ->type_name("PROGRAM");
  app.add_option("--time-engine", engine, "NAME[:key=value,...], whose steps are timed")
      ->capture_default_str()
      ->needs("--time-against")
      ->type_name("ENGINE");
  app.add_option("--times", file, "Write the times there too, in Google Benchmark's shape")
      ->needs("--time-against")
      ->type_name("FILE");
}

TimingReport time_against(const TimingOptions& options, const std::vector<Case>& cases, double dt) {
  std::optional<NewFile> file;
  if (!options.file.empty()) write(file.emplace(options.file), options, "");
  const SideBySide sides = side_by_side(options, cases, dt);
  TimingReport report{.program_before = options.against,
                      .program_now = own_program().string(),
                      .facts_before = sides.facts_before(),
                      .facts_now = sides.facts_now(),
                      .uncounted = sides.uncounted()};
  {
    const ProgressLine line;
    report.cases = judge_times(
        [&](std::span<const std::size_t> which, int sittings) {
          std::size_t done = 0;
          return sides.measure(which, sittings, [&](const std::string& name) {
            line.show(
                fmt::format("[{}/{}] times: {}", ++done, which.size() * static_cast<std::size_t>(sittings), name));
          });
        },
        cases.size(), report.rule);
  }
  report.load_after = timing_facts().at("load");
  if (file) {
    write(*file, options, timing_json(report));
    file->put_in_place();
  }
  return report;
}

}  // namespace plumb
