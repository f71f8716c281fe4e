#include "reports/find/again.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>

#include "reports/find/finding.h"
#include "reports/find/isolated.h"
#include "reports/judge/verdict.h"
#include "reports/run/scene_file.h"
#include "reports/study/runner.h"
#include "reports/system/files.h"
#include "reports/system/layout.h"
#include "reports/system/terminal.h"
#include "reports/writers/junit.h"
#include "reports/writers/output.h"
#include "scenarios/scene/scene_json.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

// In the order of their names.
std::vector<fs::path> scenes_in(const std::string& folder) {
  if (!fs::is_directory(folder)) throw std::invalid_argument(folder + ": is not a folder");
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(scene_ending) && !name.ends_with(image_ending)) files.push_back(entry.path());
  }
  if (files.empty()) throw std::invalid_argument(folder + ": has no scene files; plumb find writes them to OUT/found");
  std::ranges::sort(files);
  return files;
}

std::vector<std::string> engines_of(const SceneFile& file, const AgainOptions& options) {
  if (!options.engines.empty()) return options.engines;
  return {file.origin ? file.origin->engine : ours};
}

// Why the engine that a scene was found in is not here; "" if it is.
std::string why_not_here(const std::string& engine) {
  try {
    parse_suspects(engine);
    return "";
  } catch (const std::invalid_argument& missing) {
    return missing.what();
  }
}

// What a run that ends gets wrong of what the file states.
std::vector<Complaint> contradictions(const Case& stated, const EngineConfig& config) {
  const Outcome outcome = run(*stated.scene, config, search_step);
  if (outcome.status != Status::ok) return {};
  const Stepping stepping = config.engine->stepping(config.settings, search_step);
  const std::vector<Expectation> expectations = stated.scenario->expectations(stated.parameters);
  return complaints_of("stated truth",
                       check_expectations(*stated.scene, expectations, *outcome.trace, stepping, nullptr));
}

// What each engine fails by in one scene.
JobOutput judged_again(const fs::path& path, const SceneFile& file, const AgainOptions& options) {
  const std::vector<Suspect> suspects = parse_suspects(engines_of(file, options));
  const Posed posed = file.origin ? file.origin->posed : Posed::well;
  const std::vector<Opinion> opinions = judged_apart(file.scene, posed, suspects, {}, {.seconds = options.run_limit});
  std::optional<Case> stated;
  if (!file.truth.empty()) stated = case_of_file(path.string());
  nlohmann::ordered_json lines = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < suspects.size(); ++i) {
    std::vector<Complaint> complaints = opinions[i].complaints;
    if (stated && opinions[i].status == name_of(Status::ok)) {
      std::ranges::move(contradictions(*stated, suspects[i].config), std::back_inserter(complaints));
    }
    std::string failure;
    for (const Complaint& one : complaints) failure += (failure.empty() ? "" : "; ") + one.words();
    const bool ran = opinions[i].status != name_of(Status::not_supported);
    lines.push_back({{"engine", suspects[i].name},
                     {"failure", failure},
                     {"what", !failure.empty() ? failure
                              : ran            ? "holds"
                                               : "not supported"}});
  }
  return {.values = {{"lines", std::move(lines)}}};
}

}  // namespace

int run_again(const std::string& folder, const AgainOptions& options) {
  parse_suspects(options.engines);  // refuses an unknown one before anything runs
  std::vector<Job> jobs;
  std::vector<std::vector<std::string>> rows{{"scene", "engine", "what"}};
  for (const fs::path& path : scenes_in(folder)) {
    const SceneFile file = read_scene(read_text(path.string(), largest_scene_file), path.string());
    const std::string name = path.stem().string();
    const std::string engine = engines_of(file, options).front();
    const std::string missing = why_not_here(engine);
    if (missing.empty()) {
      jobs.push_back({.key = name, .run = [path, file, &options] { return judged_again(path, file, options); }});
    } else {
      rows.push_back({name, engine, "not run: " + missing});
    }
  }
  const OutputFolder into(options.out);
  constexpr JobLimits limits{.seconds = 3600};  // each run has one of its own
  std::map<std::string, JobResult> results;
  execute(units_of(jobs), {.parallel = options.parallel, .limits = limits}, [&](std::span<const JobResult> arrived) {
    for (const JobResult& one : arrived) results.emplace(one.key, one);
  });

  std::vector<TestCase> cases;
  int failed = 0;
  const auto add = [&](const std::string& scene, const std::string& engine, const std::string& failure,
                       const std::string& what) {
    failed += failure.empty() ? 0 : 1;
    cases.push_back({scene, engine, failure});
    rows.push_back({scene, engine, what});
  };
  for (const auto& [scene, result] : results) {
    const std::string lost = fmt::format("{}: {}", name_of(result.ending), result.reason);
    if (result.ending != Ending::done) add(scene, "", lost, lost);
    const auto& values = result.output.values;
    for (const auto& line : values.value("lines", nlohmann::ordered_json::array())) {
      add(scene, line.at("engine"), line.at("failure"), line.at("what"));
    }
  }
  const std::string verdict = fmt::format("{} of {} fail.\n", failed, cases.size());
  const auto paths = into.put({{"again.md", "### Plumb: find --again\n\n" + verdict + "\n" + markdown_table(rows)},
                               {"again.xml", junit("plumb find --again", cases)}});
  fmt::print("{}\n", verdict);
  const std::size_t width = terminal_width(120);
  for (const auto& row : std::span(rows).subspan(1)) {
    fmt::print("{}", beside(row[0], 30, row[1].empty() ? row[2] : row[1] + ": " + row[2], width));
  }
  for (const auto& path : paths) fmt::print("{}\n", path.string());
  return failed > 0 ? 1 : 0;
}

}  // namespace plumb
