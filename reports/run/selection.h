#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reports/run/catalog_case.h"
#include "reports/run/experiment.h"
#include "reports/run/run.h"

/// Parses the words of a command line that select cases and engines. The parsers throw std::invalid_argument, which
/// suggests the nearest name for an unknown one.
namespace plumb {

/// "NAME": all variants of a scenario. "NAME:LABEL": one of them. "NAME:parameter=value,...": a variant of your
/// own. "FILE.json": the case of that scene file. "tracker", "tracker:NAME": what users of engines reported, or one of
/// that.
std::vector<Case> parse_cases(std::string_view word);

/// One case of the catalog: "NAME" means the defaults of its parameters.
Case parse_case(std::string_view word);

/// "NAME" or "NAME:key=value,...": an engine and its settings. "NAME:word" sets the one option that has this choice.
/// "exec:COMMAND" or "exec:COMMAND:key=value,...": an engine that is a program of its own. Engines that Plumb does not
/// come with run in processes of their own; "isolated:NAME" and "in-process:NAME" decide otherwise.
EngineConfig parse_engine(std::string_view word);

/// Every engine with its default settings and the others it lists; Plumb's own comes first, so that the others are
/// compared with it.
std::vector<EngineConfig> default_engines();

/// The cases that the words name (see parse_cases). Without words: every variant of all scenarios if `all` is set, else
/// of the canonical scenarios, and the cases that `extra` names.
std::vector<Case> select_cases(const std::vector<std::string>& words, bool all, const std::vector<std::string>& extra);

/// A plan with these cases and the engines that the words of `engines` name (see parse_engine); every engine if there
/// are none. The other fields of the plan keep their defaults. Throws std::invalid_argument, naming it, if a word is
/// unknown or a case or engine is selected twice.
Plan select_plan(const std::vector<std::string>& words, bool all, const std::vector<std::string>& engines);

/// Throws std::invalid_argument, naming it, if a name occurs twice.
void require_distinct(std::span<const std::string> names);

}  // namespace plumb
