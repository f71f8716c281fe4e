#include "reports/system/command_options.h"

#include <fmt/core.h>

#include <CLI/App.hpp>
#include <cstdio>
#include <stdexcept>

namespace plumb {

void CommandOptions::flag(const char* name, bool& into, const std::string& about) {
  command_.add_flag(name, into, about);
}

void CommandOptions::add(const char* name, const char* type, std::string& into, const std::string& about) {
  command_.add_option(name, into, about)->capture_default_str()->type_name(type);
}

void CommandOptions::add(const char* name, const char* type, std::vector<std::string>& into, const std::string& about) {
  CLI::Option* option = command_.add_option(name, into, about)->type_name(type);
  if (!into.empty()) option->capture_default_str();
}

void CommandOptions::add_repeated(const char* name, const char* type, std::vector<std::string>& into,
                                  const std::string& about) {
  command_.add_option(name, into, about)->allow_extra_args(false)->type_name(type);
}

void CommandOptions::add(const char* name, const char* type, int& into, int least, int most, const std::string& about) {
  command_.add_option(name, into, about)->capture_default_str()->check(CLI::Range(least, most))->type_name(type);
}

void CommandOptions::add(const char* name, const char* type, double& into, double least, double most,
                         const std::string& about) {
  command_.add_option(name, into, about)->capture_default_str()->check(CLI::Range(least, most))->type_name(type);
}

void CommandOptions::retired(const char* name, const char* notice) {
  command_.add_flag_callback(name, [notice] { fmt::print(stderr, "{}\n", notice); })->group("");
}

void CommandOptions::needs(const char* name, const char* other) { command_.get_option(name)->needs(other); }

void CommandOptions::excludes(const char* name, const char* other) { command_.get_option(name)->excludes(other); }

void read_words(const std::vector<std::string>& words, const std::function<void(CLI::App&)>& declare) {
  CLI::App app;
  declare(app);
  std::vector<std::string> last_first(words.rbegin(), words.rend());
  try {
    app.parse(last_first);
  } catch (const CLI::ParseError& error) {
    throw std::invalid_argument(error.what());
  }
}

}  // namespace plumb
