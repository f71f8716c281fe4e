#pragma once

#include <string>
#include <vector>

#include "reports/run/run.h"

namespace plumb {

/// A method of an engine, and what makes it work harder.
struct Method {
  EngineConfig config;
  WorkLadder ladder;  // its option is "" where there is none
};

/// Every method of every engine, Plumb's own first. Of an engine that names none: its default, and what is shown beside
/// that.
std::vector<Method> default_methods();

/// What each word means ("NAME", or "NAME:key=value,..."), with the ladder of its method, where it has one and the word
/// has not set that option; no words: all methods. Throws std::invalid_argument, naming the nearest, for what is
/// unknown.
std::vector<Method> methods_asked(const std::vector<std::string>& words);

}  // namespace plumb
