#include <fmt/core.h>

#include <memory>
#include <stdexcept>

#include "reports/cli/command.h"
#include "reports/cli/descriptions.h"
#include "reports/cli/session.h"
#include "reports/run/scene_file.h"
#include "reports/run/selection.h"
#include "reports/system/terminal.h"
#include "scenarios/catalog.h"

namespace plumb::commands::show {
namespace {

int show(const std::string& name) {
  const std::size_t width = terminal_width(100);
  const Engine* engine = Catalog<Engine>::find(name);
  if (engine != nullptr && Catalog<Scenario>::find(name) == nullptr) {
    fmt::print("{}\n{}", name, description_of(*engine, width));
    return 0;
  }
  const Case one = is_scene_file(name) ? case_of_file(name) : parse_case(name);
  warn_about_files({&one, 1});
  fmt::print("{}\n{}", one.scenario->name, description_of(one, width));
  return 0;
}

const Catalog<Command>::Entry entry{
    {.name = "show",
     .about = "Show a scenario's question, parameters, variants and truth, or an engine's options",
     .examples = "  plumb show bounce\n"
                 "  plumb show impulse\n"
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
