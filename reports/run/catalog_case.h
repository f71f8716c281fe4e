#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/run/run.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/nearest.h"

/// Parses the words that name cases of the catalog, and the parts of such words. The parsers throw
/// std::invalid_argument, which suggests the nearest name for an unknown one.
namespace plumb {

/// The text before and after the first `mark`; all of it before, if there is none.
std::pair<std::string, std::string> split(std::string_view text, char mark);
std::vector<std::string> split_at_commas(std::string_view text);

/// "key=value"; `context` begins the message if it is anything else.
std::pair<std::string, std::string> parse_assignment(const std::string& context, const std::string& text);

/// A number, or a fraction of two: "0.01", "1/60".
double parse_number(std::string_view what, std::string_view text);

/// The same for a time step, which must be > 0 and <= 1 s.
double parse_dt(std::string_view text);

/// A whole number, without anything around it.
std::optional<int> parse_integer(std::string_view text);

/// The entry of a catalog by its name, among those that are offered.
template <class T>
const T& find_entry(
    const char* kind, const std::string& name, bool (*offered)(const T&) = [](const T&) { return true; }) {
  const T* found = Catalog<T>::find(name);
  if (found != nullptr && offered(*found)) return *found;
  std::vector<std::string> names;
  for (const T* entry : Catalog<T>::all()) {
    if (offered(*entry)) names.push_back(entry->name);
  }
  throw std::invalid_argument(unknown(kind, name, names));
}

/// "NAME": all variants of a scenario. "NAME:LABEL": one of them. "NAME:parameter=value,...": a variant of your own.
std::vector<Case> catalog_cases(std::string_view word);

/// The same for one case: "NAME" means the defaults of its parameters.
Case catalog_case(std::string_view word);

/// Every variant of the canonical scenarios, or of all scenarios.
std::vector<Case> default_cases(bool all);

}  // namespace plumb
