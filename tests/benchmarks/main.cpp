// What a step costs: our engine beside every rival, all through their adapters.

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "contest.h"
#include "reports/run/selection.h"
#include "reports/system/files.h"
#include "scenarios/scene/nearest.h"

namespace plumb::benchmarks {
namespace {

struct Asked {
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

// "workers" is what engines call their number of threads.
bool takes_threads(const Engine& engine) {
  return std::any_of(engine.options.begin(), engine.options.end(),
                     [](const Option& option) { return option.key == "workers"; });
}

std::string label(const EngineConfig& config) {
  const std::string method = config.method();
  return method.empty() ? config.engine->name : config.engine->name + ":" + method;
}

// Every engine with its defaults, in float where it can choose, as games run it.
std::vector<std::string> usual_engines() {
  std::vector<std::string> words;
  for (const EngineConfig& config : default_engines()) {
    const Engine& engine = *config.engine;
    if (!config.method().empty()) continue;
    const bool chooses = config.settings.contains("precision");
    words.push_back(engine.name + (chooses ? ":precision=float" : ""));
  }
  return words;
}

struct Named {
  std::string name;
  EngineConfig config;
};

std::vector<Named> engines(const Asked& asked) {
  std::vector<Named> all;
  for (const std::string& word : asked.engines.empty() ? usual_engines() : asked.engines) {
    EngineConfig config = parse_engine(word);
    std::string name = label(config);
    if (asked.threads > 1) {
      if (!takes_threads(*config.engine)) {
        fmt::print(stderr, "{} has one thread: left out\n", config.engine->name);
        continue;
      }
      config.settings["workers"] = std::to_string(asked.threads);
    }
    all.push_back({std::move(name), std::move(config)});
  }
  return all;
}

// By its whole name, or by its engine's.
std::size_t reference_of(const std::vector<Named>& all, const std::string& against) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].name == against || all[i].config.engine->name == against) return i;
    names.push_back(all[i].name);
  }
  throw std::invalid_argument("--against: " + unknown("engine", against, names));
}

std::string usual_reference(const std::vector<Named>& all) {
  for (const char* const name : {"box2d-v3", "box2d"}) {
    for (const Named& one : all) {
      if (one.config.engine->name == name) return name;
    }
  }
  return all.front().name;
}

std::vector<const Course*> courses(const Asked& asked) {
  if (asked.scenes.empty()) return Catalog<Course>::all();
  std::vector<const Course*> chosen;
  for (const std::string& name : asked.scenes) {
    chosen.push_back(Catalog<Course>::find(name));
    if (chosen.back() != nullptr) continue;
    std::vector<std::string> names;
    for (const Course* course : Catalog<Course>::all()) names.push_back(course->name);
    throw std::invalid_argument("--scenes: " + unknown("scene", name, names));
  }
  return chosen;
}

// "FROM:TO"
Window parse_window(const std::string& text) {
  Window window;
  int read = 0;
  const bool whole = std::sscanf(text.c_str(), "%d:%d%n", &window.from, &window.to, &read) == 2 &&
                     read == static_cast<int>(text.size());
  if (whole && window.from >= 0 && window.to > window.from) return window;
  throw std::invalid_argument("--window: \"" + text + "\" should read FROM:TO, two numbers of steps");
}

// The parts of its run that are timed, and what they are called.
std::vector<std::pair<std::string, Window>> windows(const Course& course, const Asked& asked) {
  if (!asked.window.empty()) return {{course.name, parse_window(asked.window)}};
  const bool either = !asked.settled && !asked.moving;
  std::vector<std::pair<std::string, Window>> chosen;
  if ((either || asked.settled) && course.settled.steps() > 0)
    chosen.emplace_back(course.name + "/settled", course.settled);
  if ((either || asked.moving) && course.moving.steps() > 0)
    chosen.emplace_back(course.name + "/moving", course.moving);
  return chosen;
}

Contest contest_of(const std::string& scene, const Course& course, const Start& start, Window window,
                   const std::vector<Named>& all, const Asked& asked) {
  std::vector<EngineConfig> configs;
  configs.reserve(all.size());
  for (const Named& one : all) configs.push_back(one.config);
  const std::vector<Finish> finishes = race(start, window, configs, asked.rounds, asked.patience);
  Contest contest{.scene = scene,
                  .about = course.about,
                  .window = window,
                  .threads = asked.threads,
                  .rounds = asked.rounds,
                  .basis = asked.threads == 1 ? Basis::cpu : Basis::wall,
                  .against = asked.against};
  const std::vector<Lap>& reference = finishes[reference_of(all, asked.against)].laps;
  for (std::size_t i = 0; i < all.size(); ++i) {
    contest.rows.push_back(
        {all[i].name, finishes[i], figures(finishes[i].laps, reference, window.steps(), contest.basis)});
  }
  return contest;
}

void list() {
  for (const Course* course : Catalog<Course>::all()) fmt::print("  {:<14} {}\n", course->name, course->about);
}

NewFile written(const std::string& path, const std::string& text) {
  NewFile file(path);
  if (!file.write(text)) throw std::invalid_argument("--json: \"" + path + "\" cannot be written");
  return file;
}

void carry_out(Asked asked) {
  if (asked.list) return list();
  const std::vector<Named> all = engines(asked);
  if (all.empty()) throw std::invalid_argument("nobody is left to be timed");
  if (asked.against.empty()) asked.against = usual_reference(all);
  reference_of(all, asked.against);
  const std::vector<const Course*> chosen_courses = courses(asked);
  if (!asked.json.empty()) written(asked.json, "");  // tried before anything is run
  std::vector<Contest> contests;
  for (const Course* course : chosen_courses) {
    const auto chosen = windows(*course, asked);
    if (chosen.empty()) continue;
    const Start start = course->start();
    for (const auto& [scene, window] : chosen) {
      contests.push_back(contest_of(scene, *course, start, window, all, asked));
      fmt::print("{}\n", table(contests.back()));
      std::fflush(stdout);
      if (!asked.json.empty()) written(asked.json, google_json(contests)).put_in_place();
    }
  }
}

int program(int argc, char** argv) {
  Asked asked;
  CLI::App app{"What a step costs on scenes that engines are commonly timed on. Sleeping is off, a step is 1/60 s."};
  app.add_option("--scenes", asked.scenes, "Which; all by default (see --list)")->type_name("NAME");
  app.add_option("--engines", asked.engines, "NAME or NAME:key=value,...; every engine in float by default")
      ->type_name("NAME");
  app.add_option("--against", asked.against, "Whose time the others' are told against; box2d-v3 where it is there")
      ->type_name("NAME");
  app.add_option("--rounds", asked.rounds, "From how many the medians are")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--threads", asked.threads, "Of those engines that can have several")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  app.add_option("--patience", asked.patience, "After how many seconds over a round's steps a engine drops out")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("--settled", asked.settled, "Only what has come to rest");
  app.add_flag("--moving", asked.moving, "Only what moves");
  app.add_option("--window", asked.window, "Steps to be timed instead of the scene's own")->type_name("FROM:TO");
  app.add_option("--json", asked.json, "Write the rounds there too, in Google Benchmark's shape")->type_name("FILE");
  app.add_flag("--list", asked.list, "Name the scenes, and time nothing");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    carry_out(asked);
    return 0;
  } catch (const std::invalid_argument& error) {
    fmt::print(stderr, "plumb_benchmarks: {}\n", error.what());
    return 2;
  }
}

}  // namespace
}  // namespace plumb::benchmarks

int main(int argc, char** argv) { return plumb::benchmarks::program(argc, argv); }
