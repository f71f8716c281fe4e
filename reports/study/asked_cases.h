#pragma once

#include <span>
#include <string>
#include <vector>

#include "reports/run/experiment.h"
#include "reports/run/run.h"
#include "reports/study/point.h"

/// The cases that a study is asked about.
namespace plumb {

/// What the words mean (see parse_cases). No words: every variant of the canonical scenarios and `besides`, or of all.
std::vector<Case> cases_asked(const std::vector<std::string>& words, bool all, const std::vector<std::string>& besides);

/// The cases, and what each word of `engines` means (see parse_engine); no words: every engine. The rest of the plan
/// is left to the caller. Throws std::invalid_argument, naming it, for what is unknown or asked for twice.
Plan plan_asked(const std::vector<std::string>& words, bool all, const std::vector<std::string>& engines);

/// Tells a scene that has changed since from the one that was run.
std::string hash_of(const std::vector<Case>&);

/// Throws std::invalid_argument, naming it, for a point that is asked for twice.
void must_differ(std::span<const Point>);

}  // namespace plumb
