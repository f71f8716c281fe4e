// Times the steps of our engine and of all others, through their adapters.

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "reports/run/selection.h"
#include "reports/system/files.h"
#include "results.h"
#include "scenarios/scene/nearest.h"

namespace plumb::benchmarks {
namespace {

struct BenchmarkOptions {
  std::vector<std::string> scenes;
  std::vector<std::string> engines;
  std::string against;
  std::string window;
  std::string json;
  int rounds = 5;
  int threads = 1;
  double patience = 60;  // s
  bool settled = false, moving = false, list = false;
};

// Engines call their number of threads "workers".
bool takes_threads(const Engine& engine) {
  return std::any_of(engine.options.begin(), engine.options.end(),
                     [](const Option& option) { return option.key == "workers"; });
}

std::string label(const EngineConfig& config) {
  const std::string method = config.method();
  return method.empty() ? config.engine->name : config.engine->name + ":" + method;
}

// Every engine with its defaults, except that it uses float if it has the choice, as games do.
std::vector<std::string> usual_engines() {
  std::vector<std::string> words;
  for (const EngineConfig& config : default_engines()) {
    if (!config.method().empty()) continue;
    words.push_back(config.engine->name + (config.settings.contains("precision") ? ":precision=float" : ""));
  }
  return words;
}

struct NamedConfig {
  std::string name;
  EngineConfig config;
};

std::vector<NamedConfig> engines(const BenchmarkOptions& options) {
  std::vector<NamedConfig> all;
  for (const std::string& word : options.engines.empty() ? usual_engines() : options.engines) {
    EngineConfig config = parse_engine(word);
    std::string name = label(config);
    if (options.threads > 1) {
      if (!takes_threads(*config.engine)) {
        fmt::print(stderr, "{} has only one thread: left out\n", config.engine->name);
        continue;
      }
      config.settings["workers"] = std::to_string(options.threads);
    }
    all.push_back({std::move(name), std::move(config)});
  }
  return all;
}

// The index of the engine with that label, or that name.
std::size_t reference_index(const std::vector<NamedConfig>& all, const std::string& against) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].name == against || all[i].config.engine->name == against) return i;
    names.push_back(all[i].name);
  }
  throw std::invalid_argument("--against: " + unknown("engine", against, names));
}

std::string usual_reference(const std::vector<NamedConfig>& all) {
  for (const char* const name : {"box2d-v3", "box2d"}) {
    for (const NamedConfig& one : all) {
      if (one.config.engine->name == name) return name;
    }
  }
  return all.front().name;
}

std::vector<const BenchmarkScene*> scenes(const BenchmarkOptions& options) {
  if (options.scenes.empty()) return Catalog<BenchmarkScene>::all();
  std::vector<const BenchmarkScene*> chosen;
  for (const std::string& name : options.scenes) {
    chosen.push_back(Catalog<BenchmarkScene>::find(name));
    if (chosen.back() != nullptr) continue;
    std::vector<std::string> names;
    for (const BenchmarkScene* scene : Catalog<BenchmarkScene>::all()) names.push_back(scene->name);
    throw std::invalid_argument("--scenes: " + unknown("scene", name, names));
  }
  return chosen;
}

// "FROM:TO"
StepWindow parse_window(const std::string& text) {
  StepWindow window;
  int read = 0;
  const bool whole = std::sscanf(text.c_str(), "%d:%d%n", &window.from, &window.to, &read) == 2 &&
                     read == static_cast<int>(text.size());
  if (whole && window.from >= 0 && window.to > window.from) return window;
  throw std::invalid_argument("--window: \"" + text + "\" should read FROM:TO, two numbers of steps");
}

struct NamedWindow {
  std::string name;
  StepWindow window;
};

// The parts of a scene's run to time.
std::vector<NamedWindow> windows(const BenchmarkScene& scene, const BenchmarkOptions& options) {
  if (!options.window.empty()) return {{scene.name, parse_window(options.window)}};
  const bool both = !options.settled && !options.moving;
  std::vector<NamedWindow> chosen;
  if ((both || options.settled) && scene.settled.steps() > 0)
    chosen.push_back({scene.name + "/settled", scene.settled});
  if ((both || options.moving) && scene.moving.steps() > 0) chosen.push_back({scene.name + "/moving", scene.moving});
  return chosen;
}

BenchmarkResult result_of(const NamedWindow& timed, const BenchmarkScene& scene, const SceneSetup& setup,
                          const std::vector<NamedConfig>& all, const BenchmarkOptions& options) {
  std::vector<EngineConfig> configs;
  configs.reserve(all.size());
  for (const NamedConfig& one : all) configs.push_back(one.config);
  const std::vector<EngineTimes> times = time_window(setup, timed.window, configs, options.rounds, options.patience);
  BenchmarkResult result{.scene = timed.name,
                         .about = scene.about,
                         .window = timed.window,
                         .threads = options.threads,
                         .rounds = options.rounds,
                         .basis = options.threads == 1 ? TimeBasis::cpu : TimeBasis::wall,
                         .against = options.against};
  const std::vector<Elapsed>& reference = times[reference_index(all, options.against)].rounds;
  for (std::size_t i = 0; i < all.size(); ++i) {
    result.engines.push_back(
        {all[i].name, times[i], summarize(times[i].rounds, reference, timed.window.steps(), result.basis)});
  }
  return result;
}

void list_scenes() {
  for (const BenchmarkScene* scene : Catalog<BenchmarkScene>::all())
    fmt::print("  {:<14} {}\n", scene->name, scene->about);
}

NewFile written(const std::string& path, const std::string& text) {
  NewFile file(path);
  if (!file.write(text)) throw std::invalid_argument("--json: \"" + path + "\" cannot be written");
  return file;
}

void run_benchmarks(BenchmarkOptions options) {
  const std::vector<NamedConfig> all = engines(options);
  if (all.empty()) throw std::invalid_argument("no engine is left to be timed");
  if (options.against.empty()) options.against = usual_reference(all);
  reference_index(all, options.against);  // throws if it is unknown
  const std::vector<const BenchmarkScene*> chosen_scenes = scenes(options);
  if (!options.json.empty()) written(options.json, "");  // tried before anything is run
  std::vector<BenchmarkResult> results;
  for (const BenchmarkScene* scene : chosen_scenes) {
    const std::vector<NamedWindow> chosen = windows(*scene, options);
    if (chosen.empty()) continue;
    const SceneSetup setup = scene->setup();
    for (const NamedWindow& timed : chosen) {
      results.push_back(result_of(timed, *scene, setup, all, options));
      fmt::print("{}\n", table(results.back()));
      std::fflush(stdout);
      if (!options.json.empty()) written(options.json, google_json(results)).put_in_place();
    }
  }
}

int program(int argc, char** argv) {
  BenchmarkOptions options;
  CLI::App app{
      "Times the steps of engines on scenes that engines are commonly timed on. Sleeping is off, a step is 1/60 s."};
  app.add_option("--scenes", options.scenes, "The scenes; default: all (see --list)")->type_name("NAME");
  app.add_option("--engines", options.engines, "NAME or NAME:key=value,...; default: every engine, in float")
      ->type_name("NAME");
  app.add_option("--contenders", options.engines)->group("")->each([](const std::string&) {  // its name until 0.1
    fmt::print(stderr, "--contenders is called --engines now and will go\n");
  });
  app.add_option("--against", options.against, "The engine that speeds are relative to; default: box2d-v3 if present")
      ->type_name("NAME");
  app.add_option("--rounds", options.rounds, "The number of rounds, of which the median counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--threads", options.threads, "The number of threads; engines with only one are left out")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  app.add_option("--patience", options.patience,
                 "Seconds for the steps of a round; an engine that takes longer has no result")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("--settled", options.settled, "Time only scenes at rest");
  app.add_flag("--moving", options.moving, "Time only scenes in motion");
  app.add_option("--window", options.window, "Time these steps instead of the scene's own")->type_name("FROM:TO");
  app.add_option("--json", options.json, "Also write the times, in the format of Google Benchmark")->type_name("FILE");
  app.add_flag("--list", options.list, "List the scenes and exit");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    if (options.list) {
      list_scenes();
    } else {
      run_benchmarks(std::move(options));
    }
    return 0;
  } catch (const std::invalid_argument& error) {
    fmt::print(stderr, "plumb_benchmarks: {}\n", error.what());
    return 2;
  }
}

}  // namespace
}  // namespace plumb::benchmarks

int main(int argc, char** argv) { return plumb::benchmarks::program(argc, argv); }
