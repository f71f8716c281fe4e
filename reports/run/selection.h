#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reports/run/run.h"

/// What the words of a command line mean. All throw std::invalid_argument, with the nearest name where one is unknown.
namespace plumb {

/// A number, or a fraction of two: "0.01", "1/60".
double parse_number(std::string_view what, std::string_view text);

/// The same for a time step, which must be above 0 and at most 1 s.
double parse_dt(std::string_view text);

/// "NAME": all variants of a scenario. "NAME:LABEL": one of them. "NAME:parameter=value,...": one of your own.
/// "FILE.json": what that scene file asks.
std::vector<Case> parse_cases(std::string_view word);

/// One case of the catalogue: "NAME" means the family's defaults.
Case parse_case(std::string_view word);

/// Every variant of the canonical scenarios, or of all.
std::vector<Case> default_cases(bool all);

/// "NAME" or "NAME:key=value,...": an engine and its settings. "NAME:word" sets the one option that has this choice.
EngineConfig parse_engine(std::string_view word);

/// Every engine with its defaults; Plumb's own leads, so that the others are compared with it.
std::vector<EngineConfig> default_engines();

}  // namespace plumb
