#include <fmt/core.h>

#include <memory>
#include <optional>
#include <string>

#include "reference/programs/program_engine.h"
#include "reports/cli/command_line.h"
#include "reports/cli/descriptions.h"
#include "reports/cli/session.h"
#include "reports/engines/installed.h"
#include "reports/run/scene_file.h"
#include "reports/run/selection.h"
#include "reports/system/terminal.h"
#include "scenarios/catalog.h"

namespace plumb::commands::show {
namespace {

// Of an engine of the catalogue, one of npm, or a program; nullopt for other words, and for one that is a scenario's,
// too.
std::optional<std::string> engine_description(const std::string& word, std::size_t width) {
  if (Catalog<Scenario>::find(word) != nullptr) return std::nullopt;
  if (word.starts_with(program_prefix)) return description_of(*parse_engine(word).engine, width);
  if (const Engine* engine = Catalog<Engine>::find(word)) return description_of(*engine, width);
  for (const PackagedEngine& one : packaged_engines()) {
    if (one.name == word) return description_of(one, width);
  }
  return std::nullopt;
}

int show(const std::string& name) {
  const std::size_t width = terminal_width(100);
  if (const auto engine = engine_description(name, width)) {
    fmt::print("{}\n{}", name, *engine);
    return 0;
  }
  const Case one = is_scene_file(name) ? case_of_file(name) : parse_case(name);
  warn_about_files({&one, 1});
  fmt::print("{}\n{}", one.scenario->name, description_of(one, width));
  return 0;
}

const Catalog<Command>::Entry entry{
    {.name = "show",
     .about = "Show a scenario's question, parameters, variants and truth, or an engine's options and caveats",
     .examples = "  plumb show bounce\n"
                 "  plumb show impulse\n"
                 "  plumb show rapier                 an engine that plumb engine add installs\n"
                 "  plumb show mine.json              a scene file of your own\n",
     .attach = [](CLI::App& app) {
       const auto name = std::make_shared<std::string>();
       app.add_option("name", *name, "A scenario, tracker:NAME, FILE.json, or an engine; see plumb list")
           ->required()
           ->type_name("NAME");
       return [name] { return show(*name); };
     }}};

}  // namespace
}  // namespace plumb::commands::show
