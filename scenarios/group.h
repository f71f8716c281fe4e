#pragma once

#include <string>

#include "scenarios/catalog.h"

namespace plumb {

/// What the families of one folder ask about; group.cpp has them all.
struct ScenarioGroup {
  std::string name;   // the folder
  std::string title;  // "chaos and statistics"
  std::string stake;  // what goes wrong in a game or a simulation if an engine fails here; a sentence
};

}  // namespace plumb
