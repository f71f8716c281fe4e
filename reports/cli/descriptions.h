#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "reference/simulation.h"
#include "reports/engines/installed.h"
#include "reports/run/run.h"
#include "scenarios/scenario.h"

/// Entries of the catalogs in words, for `plumb show`, `plumb list` and `plumb help`. Widths are in columns.
namespace plumb {

/// Question, parameters, variants, truth and checks of a scenario; a case of the tracker or of a file is one, too.
std::string description_of(const Case&, std::size_t width);

/// What an engine is, its options, and what it does differently.
std::string description_of(const Engine&, std::size_t width);

/// The same of an engine of npm that is installed; else what it is, and how to install it.
std::string description_of(const PackagedEngine&, std::size_t width);

/// One word that `plumb help` explains.
struct Topic {
  std::string kind;  // "scenario"
  std::string name;
  std::function<std::string(std::size_t width)> text;
};

/// Entries of all catalogs that users name, and the words of the glossary.
std::vector<Topic> topics();

/// All families of scenes as a table in Markdown, by group: name, cases, question, and what answers it, with the source
/// where that is a closed form of its own.
std::string family_table();

}  // namespace plumb
