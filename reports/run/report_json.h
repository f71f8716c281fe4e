#pragma once

#include <functional>
#include <initializer_list>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "reports/report.h"
#include "scenarios/scene/json_reader.h"

/// Reading report.json, and the kinds of field it shares with baselines and histories. Everything here throws
/// std::invalid_argument, naming the file and the place in it, for what it cannot read.
namespace plumb {

/// Version of report.json. It grows when a reader of the previous version would misread the new one.
constexpr int report_format = 4;

/// Reads the runs with their metrics, checks and times, the engines, the environment and the command of a report.json
/// of this version or an older one. Scenes, traces, comparisons and notes on other names are left out.
Report report_from(nlohmann::json, const std::string& file);

/// NaN for null, which stands for a number that is not finite.
double number_or_null(const JsonReader&);

/// One line of text.
std::string any_text(const JsonReader&);
std::vector<std::string> text_list_from(const JsonReader&);
std::map<std::string, std::string> text_map_from(const JsonReader&);

Verdict verdict_from(const JsonReader&);
CheckStatus check_status_from(const JsonReader&);

/// Calls `take(name, value)` for every member of an object.
void for_each_member(const JsonReader& object, const std::function<void(const std::string&, const JsonReader&)>& take);

/// Calls `take(entry)` for every entry of a list. Refuses entries that lack any of the keys.
void for_each_entry(const JsonReader& list, std::initializer_list<const char*> keys,
                    const std::function<void(const JsonReader&)>& take);

/// Renames a key of an object that was written by an older version; does nothing if the key is not there.
void rename_key(nlohmann::json& object, const char* old_key, const char* new_key);

/// Replaces what version 1 of reports and baselines called the status and the tolerance of a check.
void update_check(nlohmann::json& check);

}  // namespace plumb
