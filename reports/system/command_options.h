#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace plumb {

/// Adds options to a command for code that need not see the headers of CLI11, which take seconds to compile. The value
/// that an option has now is its default, which --help shows; `type` stands for its value there.
class CommandOptions {
 public:
  explicit CommandOptions(CLI::App& command) : command_(command) {}

  void flag(const char* name, bool& into, const std::string& about);
  void add(const char* name, const char* type, std::string& into, const std::string& about);
  /// Takes all words up to the next option.
  void add(const char* name, const char* type, std::vector<std::string>& into, const std::string& about);
  /// Takes one word each time that it is given.
  void add_repeated(const char* name, const char* type, std::vector<std::string>& into, const std::string& about);
  void add(const char* name, const char* type, int& into, int least, int most, const std::string& about);
  void add(const char* name, const char* type, double& into, double least, double most, const std::string& about);
  /// A hidden flag of earlier releases, which prints a notice and does nothing.
  void retired(const char* name, const char* notice);

  /// An option is refused without another, or beside it.
  void needs(const char* name, const char* other);
  void excludes(const char* name, const char* other);

 private:
  CLI::App& command_;
};

/// Reads words as the options of a command, which `declare` adds. Throws std::invalid_argument if they are not.
void read_words(const std::vector<std::string>& words, const std::function<void(CLI::App&)>& declare);

}  // namespace plumb
