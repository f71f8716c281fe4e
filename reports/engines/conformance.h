#pragma once

#include <functional>
#include <string>

/// What a program must do to be an engine (see reference/programs/README.md), tried on it point by point.
namespace plumb {

struct ConformancePoint {
  enum class Result { kept, broken, skipped };
  std::string name;
  Result result = Result::kept;
  std::string detail;  // what was seen and, if it is broken, what to mend
};

/// Starts the command and tries it. `found` is told of each point as it is known. Returns whether none is broken.
bool check_conformance(const std::string& command, const std::function<void(const ConformancePoint&)>& found);

}  // namespace plumb
