#pragma once

#include <span>
#include <string>
#include <vector>

#include "reports/run/experiment.h"
#include "reports/run/run.h"

/// The cases and engines that the words of a command line select.
namespace plumb {

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
