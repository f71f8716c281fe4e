#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "reports/cli/command_line.h"
#include "reports/cli/descriptions.h"
#include "reports/system/terminal.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/nearest.h"

namespace plumb::commands::help {
namespace {

// The help of "study speed", for example; "" if the words are no command.
std::string help_of_command(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* command = &app;
  std::string path = app.get_name();
  for (const std::string& word : words) {
    const auto all = commands_of(*command);
    const auto found = std::ranges::find_if(all, [&](const CLI::App* one) { return one->get_name() == word; });
    if (found == all.end()) return "";
    command = *found;
    if (&word != &words.back()) path += " " + word;
  }
  return command->help(path);
}

int explain(const std::vector<std::string>& words) {
  CommandLine line;
  if (words.empty()) {
    fmt::print(
        "{}\nplumb help WORD explains a command, and every scenario, engine, metric, invariant, relation and "
        "word of a report.\n",
        line.app().help());
    return 0;
  }
  std::string text = help_of_command(line.app(), words);
  std::string name;
  for (const std::string& word : words) name += (name.empty() ? "" : " ") + word;
  std::vector<std::string> names;
  for (const CLI::App* command : commands_of(line.app())) names.push_back(command->get_name());
  const std::size_t width = terminal_width(100);
  for (const Topic& topic : topics()) {
    names.push_back(topic.name);
    if (topic.name != name) continue;
    text += fmt::format("{}{} ({})\n{}", text.empty() ? "" : "\n", name, topic.kind, topic.text(width));
  }
  if (text.empty()) throw std::invalid_argument(unknown("word", name, names));
  fmt::print("{}", text);
  return 0;
}

const Catalog<Command>::Entry entry{
    {.name = "help",
     .about = "Explain a command, a scenario, an engine, or a word of a report",
     .examples = "  plumb help run                a command, as plumb run --help does\n"
                 "  plumb help bounce             a scenario: its question, parameters and truth\n"
                 "  plumb help coarse             a verdict\n"
                 "  plumb help error / scale      a word of the glossary; also metrics, invariants and relations\n",
     .attach = [](CLI::App& app) {
       const auto words = std::make_shared<std::vector<std::string>>();
       app.add_option("word", *words, "What to explain; default: the whole program")->type_name("WORD");
       return [words] { return explain(*words); };
     }}};

}  // namespace
}  // namespace plumb::commands::help
