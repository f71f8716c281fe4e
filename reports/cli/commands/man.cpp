#include <fmt/format.h>

#include "reports/cli/command_line.h"
#include "reports/system/environment.h"
#include "scenarios/catalog.h"

namespace plumb::commands::man {
namespace {

// Text in roff: no escapes, and no line that begins as a request does.
std::string roff(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    const bool begins = out.empty() || out.back() == '\n';
    if (begins && (letter == '.' || letter == '\'')) out += "\\&";
    out += letter == '\\' ? "\\e" : letter == '-' ? "\\-" : std::string(1, letter);
  }
  return out;
}

std::string option_text(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::string value = option.get_expected_max() == 0 || type.empty() ? "" : " " + type.substr(0, type.find(':'));
  const std::string otherwise = option.get_default_str().empty() ? "" : " Default: " + option.get_default_str() + ".";
  const std::string name = option.get_positional() ? option.get_name(true) : option.get_name(false, true);
  return fmt::format(".TP\n.B {}\n{}\n", roff(name + value), roff(option.get_description() + "." + otherwise));
}

std::string options_of(const CLI::App& app) {
  std::string text;
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_group().empty() && option->get_name() != "--help") text += option_text(*option);
  }
  return text;
}

// Without its heading.
std::string examples_of(const CLI::App& app) {
  const std::string footer = app.get_footer();
  const std::size_t begin = footer.find('\n');
  if (begin == std::string::npos) return "";
  return ".PP\n.nf\n" + roff(footer.substr(begin + 1, footer.find("\n\n") - begin - 1)) + "\n.fi\n";
}

std::string command_text(const CLI::App& command, const std::string& path) {
  std::string text = fmt::format(".SS {}\n{}.\n{}", roff(path), roff(command.get_description()), options_of(command));
  text += examples_of(command);
  for (const CLI::App* one : commands_of(command)) text += command_text(*one, path + " " + one->get_name());
  return text;
}

std::string page() {
  const CommandLine line;
  std::string text = fmt::format(".TH PLUMB 1 \"\" \"plumb {}\"\n.SH NAME\nplumb \\- {}\n", version(),
                                 roff(line.app().get_description()));
  text += ".SH SYNOPSIS\n.B plumb\nCOMMAND [OPTION]...\n.SH OPTIONS\n" + options_of(line.app());
  text += ".SH COMMANDS\n";
  for (const CLI::App* one : commands_of(line.app())) text += command_text(*one, "plumb " + one->get_name());
  text += ".SH EXIT STATUS\n";
  for (const ExitCode& one : exit_codes()) text += fmt::format(".TP\n.B {}\n{}\n", one.code, roff(one.about));
  return text + ".SH EXAMPLES\n" + examples_of(line.app());
}

const Catalog<Command>::Entry entry{{.name = "man",
                                     .about = "Print the manual page, in roff",
                                     .examples = "  plumb man > plumb.1 && man ./plumb.1\n",
                                     .attach = [](CLI::App&) {
                                       return [] {
                                         fmt::print("{}", page());
                                         return 0;
                                       };
                                     }}};

}  // namespace
}  // namespace plumb::commands::man
