#include "reports/study/speed/times_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "reports/report.h"

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

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

// The index of 1 mm; the coarser one if no method gets there, and so on.
std::size_t headline_target(const Json& targets, std::size_t finest) {
  std::size_t target = finest;
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
  if (times.empty()) return fmt::format("Nothing gets within {} in {}.\n", target_name(error, false), name);
  std::stable_sort(times.begin(), times.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string text = fmt::format("{}: {} is the fastest to {}: {} for a simulated second", name,
                                 name_of_method(*times[0].second), target_name(error, false), duration(times[0].first));
  if (times.size() > 1) {
    text += fmt::format("; next is {}, {:.2g} times that{}", name_of_method(*times[1].second),
                        times[1].first / times[0].first, unlike(*times[0].second, *times[1].second));
  }
  text += ".\n";
  if (!never.empty()) text += fmt::format("Never that accurate: {}.\n", listed(never));
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
  if (best == nullptr) return "No case was timed.\n";
  return fmt::format("To {}, {} is the fastest in {} of {} cases. Cases in which an engine gets there: {}.\n",
                     target_name(target.at("error"), target.at("unit") == "scale"), name_of_method(*best),
                     best->at("fastest").get<int>(), target.at("cases").get<int>(), listed(parts));
}

std::string cell(const Json& reading) {
  if (!reading.is_object()) return "never";
  return (reading.at("bound").get<bool>() ? "<= " : "") + duration(reading.at("value"));
}

std::string row_text(const std::string& name, const std::vector<std::string>& cells) {
  std::string text = fmt::format("  {:<48}", name);
  for (const std::string& one : cells) text += fmt::format(" {:>10}", one);
  return text + "\n";
}

std::vector<std::string> heads_of(const Json& timings) {
  std::vector<std::string> heads;
  for (const double error : timings.at("error_targets")) heads.push_back(target_name(error, false));
  for (const double error : timings.at("scale_targets")) heads.push_back(target_name(error, true));
  return heads;
}

std::string case_table(const Json& one, const Json& timings) {
  std::string text = fmt::format("\n{}, {}: time for a simulated second, to be this close; 100 % is {:.2g} m\n",
                                 one.at("scenario").get<std::string>(), one.at("variant").get<std::string>(),
                                 one.at("scale").get<double>()) +
                     row_text("", heads_of(timings));
  for (const Json& method : one.at("engines")) {
    std::vector<std::string> cells;
    for (const char* kind : {"time_for_error", "time_for_scale"}) {
      for (const Json& reading : method.at(kind)) cells.push_back(cell(reading));
    }
    text += row_text(name_of_method(method), cells);
  }
  return text;
}

// Whether not all code runs alike.
bool several_kinds(const Json& cases) {
  std::set<std::string> kinds;
  for (const Json& one : cases) {
    for (const Json& method : one.at("engines")) kinds.insert(method.at("execution"));
  }
  return kinds.size() > 1;
}

std::string table_over_cases(const Json& timings) {
  const Json& targets = timings.at("targets");
  std::string text = fmt::format(
      "\nOver {} cases: time over the fastest method's, median of the cases where the method gets as close (how "
      "many)\n",
      timings.at("cases").size());
  text += row_text("", heads_of(timings));
  for (std::size_t i = 0; i < targets.front().at("engines").size(); ++i) {
    std::vector<std::string> cells;
    for (const Json& target : targets) {
      const Json& row = target.at("engines")[i];
      cells.push_back(row.at("median").is_number()
                          ? fmt::format("{:.2g} ({})", row.at("median").get<double>(), row.at("reached").get<int>())
                          : "never");
    }
    text += row_text(name_of_method(targets.front().at("engines")[i]), cells);
  }
  return text;
}

}  // namespace

std::string times_text(const Json& timings) {
  const Json& cases = timings.at("cases");
  if (cases.empty()) return "No case was timed.\n";
  const std::size_t target = headline_target(timings.at("targets"), 1);
  std::string text;
  if (cases.size() == 1) {
    text = one_case(cases.front(), target, timings.at("error_targets")[target]);
  } else {
    text = all_cases(timings.at("targets")[target]) + table_over_cases(timings);
  }
  if (cases.size() <= most_tables) {
    for (const Json& one : cases) text += case_table(one, timings);
  }
  if (several_kinds(cases)) {
    text +=
        "\nNative, WebAssembly, JIT-compiled and interpreted code: factors between them are not of the methods "
        "alone.\n";
  }
  return text +
         "\nRead off each method's best runs, by a power law between two of them, never beyond. <=: its cheapest run "
         "is "
         "closer.\n";
}

}  // namespace plumb
