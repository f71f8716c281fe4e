#pragma once

#include <sys/types.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "reports/timing/machine.h"

namespace plumb {

/// A program that steps on request (see timing_pace.h), begun anew.
class Pacer {
 public:
  using Json = nlohmann::ordered_json;

  struct Options {
    std::string without;   // a variable of the environment that it shall not see; "": none
    double patience = 60;  // s, for each answer
  };

  /// Throws std::invalid_argument, naming the program, where it cannot be run, or does not know how to step on request.
  Pacer(std::filesystem::path program, const Options&);
  explicit Pacer(std::filesystem::path program) : Pacer(std::move(program), Options{}) {}
  Pacer(const Pacer&) = delete;
  Pacer& operator=(const Pacer&) = delete;
  ~Pacer();

  const TimingFacts& facts() const { return facts_; }
  /// Why it counts no instructions; "" where it does.
  const std::string& uncounted() const { return uncounted_; }

  /// Throws std::runtime_error, naming the program, where it ends, takes longer than its patience, or answers what is
  /// no JSON object.
  Json ask(const Json& request);

 private:
  std::string line();
  [[noreturn]] void fail(const std::string& what) const;
  void greet();
  void end();

  std::filesystem::path program_;
  double patience_;  // s, for each answer
  pid_t process_ = 0;
  int to_and_from_ = -1;
  std::string heard_;  // beyond the last line
  TimingFacts facts_;
  std::string uncounted_;
};

/// The program that this is.
std::filesystem::path own_program();

}  // namespace plumb
