#pragma once

#include <functional>
#include <string>

#include "reports/gate/result.h"

namespace plumb {

/// A form in which others take what a gate says; `plumb check --NAME FILE` writes it.
struct GateWriter {
  std::string name;
  std::string about;  // one line
  std::function<std::string(const GateResult&)> text;
};

/// "worse: bounce e=0.5, impulse: energy_drift: 0.1 J, now 0.2 J, allowed 1e-09 off: why"
std::string in_words(const Regression&);

/// The verdict, the worst `most` regressions and on what it rests, a line each.
std::string text_of(const GateResult&, std::size_t most);

}  // namespace plumb
