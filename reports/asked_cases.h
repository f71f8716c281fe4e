#pragma once

#include <span>
#include <string>
#include <vector>

#include "reports/run.h"
#include "reports/study/point.h"

/// The cases that a study is asked about.
namespace plumb {

/// What the words mean (see parse_cases). No words: every variant of the canonical scenarios and `besides`, or of all.
std::vector<Case> cases_asked(const std::vector<std::string>& words, bool all, const std::vector<std::string>& besides);

/// Tells a scene that has changed since from the one that was run.
std::string hash_of(const std::vector<Case>&);

/// Throws std::invalid_argument, naming it, for a point that is asked for twice.
void must_differ(std::span<const Point>);

}  // namespace plumb
