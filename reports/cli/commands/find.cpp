#include "reports/study/study.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "reports/cli/command_line.h"
#include "reports/find/again.h"
#include "reports/study/conduct.h"
#include "scenarios/catalog.h"

namespace plumb::commands::find_command {
namespace {

struct Find {
  const Study* study = nullptr;
  std::function<nlohmann::ordered_json()> configuration;
  StudyOptions options;
  std::string time, again;
};

// "90", "90s", "10m" or "2h" as seconds. Throws std::invalid_argument for anything else.
double parse_time(const std::string& text) {
  std::size_t used = 0;
  double value = 0;
  try {
    value = std::stod(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  const std::string unit = text.substr(used);
  const double factor = unit.empty() || unit == "s" ? 1 : unit == "m" ? 60 : unit == "h" ? 3600 : 0;
  if (used == 0 || factor == 0 || !(value > 0)) {
    throw std::invalid_argument("--time: \"" + text + "\" is not a time such as 90s, 10m or 2h");
  }
  return value * factor;
}

// More than any time allows.
constexpr int countless = 50'000;

// A corpus says itself which scenes to run.
void refuse_beside_again(const CLI::App& app) {
  for (const char* option :
       {"--kind", "--seed", "--count", "--time", "--budget", "--each", "--shard", "--resume", "--fresh"}) {
    if (app.count(option) == 0) continue;
    throw std::invalid_argument(fmt::format(
        "{}: --again runs the scenes of a folder as they are, and neither draws any nor cuts any down", option));
  }
}

int execute(Find& find, const CLI::App& app) {
  if (!find.again.empty()) refuse_beside_again(app);
  nlohmann::ordered_json configuration = find.configuration();
  if (!find.again.empty()) {
    AgainOptions options{
        .out = find.options.out, .parallel = find.options.parallel, .run_limit = configuration.at("run_limit")};
    if (app.count("--engine") > 0) options.engines = configuration.at("engines");
    return run_again(find.again, options);
  }
  if (!find.time.empty()) {
    find.options.enough = parse_time(find.time);
    configuration["count"] = countless;
  }
  return conduct(*find.study, configuration, find.options);
}

const Catalog<Command>::Entry entry{
    {.name = "find",
     .about = "Look for scenes in which an engine is wrong, and cut each down to the smallest",
     .examples = "  plumb find                                    200 scenes, every engine\n"
                 "  plumb find --time 10m --engine impulse        as many as ten minutes allow\n"
                 "  plumb find --kind heap --kind tower --seed 7  other scenes, of two kinds\n"
                 "  plumb find --engine fault:all                 which of prove's faults random scenes find\n"
                 "  plumb find --shard 1/4                        a part, for plumb merge\n"
                 "  plumb find --again out/found                  run what was found again; exit code 1 if it fails\n",
     .attach = [](CLI::App& app) -> std::function<int()> {
       const auto find = std::make_shared<Find>();
       find->study = Catalog<Study>::find("find");
       find->configuration = find->study->attach(app);
       find->options.seconds = 3600;  // a job has many runs, each with a limit of its own
       find->options.attach_to(app);
       app.add_option("--time", find->time, "As many scenes as this allows: 90s, 10m, 2h; a third is for cutting down")
           ->excludes(app.get_option("--count"))
           ->excludes(app.get_option("--shard"))
           ->type_name("TIME");
       app.add_option("--again", find->again,
                      "Run the scenes of a folder again, each by the engine that it was found "
                      "in or by --engine; exit code 1 if one fails")
           ->type_name("DIR");
       return [find, &app] { return execute(*find, app); };
     }}};

}  // namespace
}  // namespace plumb::commands::find_command
