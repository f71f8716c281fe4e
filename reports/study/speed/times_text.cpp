#include "reports/study/speed/work_precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "reports/report.h"
#include "reports/system/layout.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_tables = 4;  // cases that have a table of their own; more have one together

std::string duration(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.3g} us", seconds * 1e6);
  return seconds < 1 ? fmt::format("{:.3g} ms", seconds * 1e3) : fmt::format("{:.3g} s", seconds);
}

std::string target_name(double error, bool of_scale) {
  if (of_scale) return fmt::format("{:g} %", error * 100);
  return error >= 0.01 ? fmt::format("{:g} cm", error * 100) : fmt::format("{:g} mm", error * 1000);
}

// With how its code runs, unless that is native.
std::string name_of_method(const Json& method) {
  return method.at("engine").get<std::string>() + execution_mark(method.at("execution"));
}

// What a sentence says that compares two methods, unless their code runs alike.
std::string unlike(const Json& a, const Json& b) {
  return a.at("execution") == b.at("execution") ? "" : ", but the two run differently: no factor of method alone";
}

// Engines as they are by default: the others are methods of ours.
bool is_default(const std::string& engine) { return engine.find(':') == std::string::npos; }

// The index of 1 mm; the coarser one if no method gets there, and so on.
std::size_t headline_target(const Json& targets) {
  std::size_t target = 1;
  while (target > 0 && targets[target].at("reached_by_any") == 0) --target;
  return target;
}

std::string one_case(const Json& one, std::size_t target, double error) {
  std::vector<std::pair<double, const Json*>> times;
  std::vector<std::string> never;
  for (const Json& method : one.at("engines")) {
    const Json& reading = method.at("time_for_error")[target];
    if (reading.is_object())
      times.emplace_back(reading.at("value").get<double>(), &method);
    else if (is_default(method.at("engine")))
      never.push_back(name_of_method(method));
  }
  const std::string name =
      fmt::format("{}, {}", one.at("scenario").get<std::string>(), one.at("variant").get<std::string>());
  if (times.empty()) return fmt::format("Nothing gets within {} in {}.", target_name(error, false), name);
  std::stable_sort(times.begin(), times.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string text = fmt::format("{}: {} is the fastest to {}: {} for a simulated second", name,
                                 name_of_method(*times[0].second), target_name(error, false), duration(times[0].first));
  if (times.size() > 1) {
    text += fmt::format("; next is {}, {:.2g} times that{}", name_of_method(*times[1].second),
                        times[1].first / times[0].first, unlike(*times[0].second, *times[1].second));
  }
  text += ".";
  if (!never.empty()) text += fmt::format(" Never that accurate: {}.", enumerated(never));
  return text;
}

std::string all_cases(const Json& target) {
  std::vector<std::string> parts;
  const Json* best = nullptr;
  for (const Json& row : target.at("engines")) {
    if (best == nullptr || row.at("fastest") > best->at("fastest")) best = &row;
    if (is_default(row.at("engine")))
      parts.push_back(fmt::format("{} in {}", name_of_method(row), row.at("reached").get<int>()));
  }
  if (best == nullptr) return "No case was timed.";
  return fmt::format("To {}, {} is the fastest in {} of {} cases. Cases in which an engine gets there: {}.",
                     target_name(target.at("error"), target.at("unit") == "scale"), name_of_method(*best),
                     best->at("fastest").get<int>(), target.at("cases").get<int>(), enumerated(parts));
}

std::string cell(const Json& reading) {
  if (!reading.is_object()) return "never";
  return (reading.at("bound").get<bool>() ? "<= " : "") + duration(reading.at("value"));
}

// Of each method, by what it is to be close to. Where there is no room, shares of the scale go first, and last all but
// the accuracy of the headline.
TextTable table_of(const Json& timings, std::size_t width) {
  std::vector<TextTable::Column> columns{{"method", 0, true}};
  const std::size_t headline = headline_target(timings.at("targets"));
  for (const double error : timings.at("error_targets"))
    columns.push_back({target_name(error, false), columns.size() == headline + 1 ? 0 : 1});
  for (const double error : timings.at("scale_targets")) columns.push_back({target_name(error, true), 2});
  return {std::move(columns), 2, width};
}

std::string case_table(const Json& one, const Json& timings, std::size_t width) {
  TextTable table = table_of(timings, width);
  for (const Json& method : one.at("engines")) {
    std::vector<TextTable::Cell> cells{{name_of_method(method)}};
    for (const char* kind : {"time_for_error", "time_for_scale"}) {
      for (const Json& reading : method.at(kind)) cells.push_back({cell(reading)});
    }
    table.add(std::move(cells));
  }
  const std::string heading = fmt::format("{}, {}: time for a simulated second, to be this close; 100 % is {:.2g} m",
                                          one.at("scenario").get<std::string>(), one.at("variant").get<std::string>(),
                                          one.at("scale").get<double>());
  return "\n" + wrapped(heading, 0, width) + table.text();
}

// Whether not all code runs alike.
bool several_kinds(const Json& cases) {
  std::set<std::string> kinds;
  for (const Json& one : cases) {
    for (const Json& method : one.at("engines")) kinds.insert(method.at("execution"));
  }
  return kinds.size() > 1;
}

std::string table_over_cases(const Json& timings, std::size_t width) {
  const Json& targets = timings.at("targets");
  TextTable table = table_of(timings, width);
  for (std::size_t i = 0; i < targets.front().at("engines").size(); ++i) {
    std::vector<TextTable::Cell> cells{{name_of_method(targets.front().at("engines")[i])}};
    for (const Json& target : targets) {
      const Json& row = target.at("engines")[i];
      cells.push_back({row.at("median").is_number()
                           ? fmt::format("{:.2g} ({})", row.at("median").get<double>(), row.at("reached").get<int>())
                           : "never"});
    }
    table.add(std::move(cells));
  }
  const std::string heading = fmt::format(
      "Over {} cases: time over the fastest method's, median of the cases where the method gets as close (how many)",
      timings.at("cases").size());
  return "\n" + wrapped(heading, 0, width) + table.text();
}

}  // namespace

std::string times_text(const Json& timings, std::size_t width) {
  const Json& cases = timings.at("cases");
  if (cases.empty()) return "No case was timed.\n";
  const std::size_t target = headline_target(timings.at("targets"));
  std::string text;
  if (cases.size() == 1) {
    text = wrapped(one_case(cases.front(), target, timings.at("error_targets")[target]), 0, width);
  } else {
    text = wrapped(all_cases(timings.at("targets")[target]), 0, width) + table_over_cases(timings, width);
  }
  if (cases.size() <= most_tables) {
    for (const Json& one : cases) text += case_table(one, timings, width);
  }
  if (several_kinds(cases)) {
    text += "\n" + wrapped(
                       "Native, WebAssembly, JIT-compiled and interpreted code: factors between them are not of the "
                       "methods alone.",
                       0, width);
  }
  return text + "\n" +
         wrapped(
             "Read off each method's best runs, by a power law between two of them, never beyond. <=: its cheapest run "
             "is closer.",
             0, width);
}

}  // namespace plumb
