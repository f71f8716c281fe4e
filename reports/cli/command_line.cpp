#include "reports/cli/command_line.h"

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>

#include "reports/system/environment.h"
#include "reports/system/layout.h"
#include "reports/system/terminal.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

constexpr std::size_t usual_width = 100;  // columns

// Wraps what stands beside names to the width of the terminal.
class WrappingFormatter : public CLI::Formatter {
 public:
  std::string make_option_desc(const CLI::Option* option) const override { return fit(option->get_description()); }

  std::string make_subcommand(const CLI::App* command) const override {
    return beside("  " + command->get_name(), column_width_, command->get_description(), width_);
  }

 private:
  // CLI11 indents what follows a line break.
  std::string fit(const std::string& text) const {
    std::string lines = wrapped(text, 0, width_ - column_width_);
    if (!lines.empty()) lines.pop_back();
    return lines;
  }

  std::size_t width_ = terminal_width(usual_width);
};

std::string exit_code_table() {
  std::string table = "Exit codes:\n";
  for (const ExitCode& one : exit_codes())
    table += beside(fmt::format("  {}", one.code), 7, one.about, terminal_width(usual_width));
  table.pop_back();
  return table;
}

}  // namespace

CommandLine::CommandLine() : app_("Plumb tells whether a 2D physics engine is right.", "plumb") {
  app_.set_version_flag("--version", std::string("plumb ") + version());
  app_.require_subcommand(1);
  app_.formatter(std::make_shared<WrappingFormatter>());
  for (const Command* command : Catalog<Command>::all()) {
    CLI::App* added = app_.add_subcommand(command->name, command->about);
    added->footer("Examples:\n" + command->examples);
    actions_[added] = command->attach(*added);
  }
  app_.footer(
      "Examples:\n  plumb report\n  plumb run bounce --engine impulse\n  plumb list engines\n"
      "  plumb help coarse               what a word of a report means\n\n" +
      exit_code_table());
}

int CommandLine::run() const { return actions_.at(app_.get_subcommands().front())(); }

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

const std::vector<ExitCode>& exit_codes() {
  static const std::vector<ExitCode> codes{
      {0, "fine"},
      {1,
       "a run is wrong or failed (run, find --again), two runs diverge (diff), something is not as accepted (check), a "
       "fault is not caught (prove), judges complain of a closed form (find)"},
      {2, "bad usage or input, or a file that cannot be read or written"},
      {3, "an internal error"},
      {130, "interrupted (study, find)"}};
  return codes;
}

}  // namespace plumb
