#pragma once

#include <map>
#include <string>

#include "reports/report.h"
#include "scenarios/scene/json_reader.h"

/// What baselines and reports have in common as files. All throw std::invalid_argument, naming the place.
namespace plumb {

/// Null stands where a number was not finite.
double number_or_null(const JsonReader&);

/// One line of text.
std::string any_text(const JsonReader&);

std::map<std::string, std::string> texts_from(const JsonReader&);

Verdict verdict_from(const JsonReader&);
CheckStatus check_status_from(const JsonReader&);

/// Calls `take(name, value)` for every member of an object.
template <class Take>
void for_each_member(const JsonReader& object, Take take) {
  if (!object.value().is_object()) object.expected("an object");
  for (const auto& member : object.value().items()) take(member.key(), object[member.key().c_str()]);
}

}  // namespace plumb
