#include "reports/find/complaint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "reports/study/job.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

// JSON has no infinity: null stands for whatever is not finite, which no tolerance covers.
double number_of(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

Json number_or_nothing(const std::optional<double>& value) { return value ? finite_or_null(*value) : Json("none"); }

std::optional<double> optional_of(const Json& json) {
  return json.is_string() ? std::nullopt : std::optional(number_of(json));
}

}  // namespace

std::string Complaint::reason() const { return judge + " " + what + (sign == 0 ? "" : sign > 0 ? " +" : " -"); }

std::string Complaint::words() const {
  const std::string place = where.empty() ? "" : ": " + where;
  if (judge == "run" && time == 0) return what + place;  // unknown when
  if (judge == "run") return fmt::format("{} at {:.3g} s{}", what, time, place);
  const std::string verb = judge == "invariant" || judge == "relation" ? "breaks the " + judge : "is off the " + judge;
  const std::string far =
      ratio < 1.005 ? "just over what is allowed" : fmt::format("{:.3g} times what is allowed", ratio);
  return fmt::format("{} {} by {:.3g} {}, {}, at {:.3g} s{}", verb, what, value, unit, far, time, place);
}

const Complaint* Opinion::of(const std::string& reason) const {
  const auto found = std::ranges::find_if(complaints, [&](const Complaint& one) { return one.reason() == reason; });
  return found == complaints.end() ? nullptr : &*found;
}

Json as_json(const Complaint& of) {
  return {{"judge", of.judge},
          {"what", of.what},
          {"sign", of.sign},
          {"where", of.where},
          {"unit", of.unit},
          {"value", finite_or_null(of.value)},
          {"tolerance", finite_or_null(of.tolerance)},
          {"ratio", finite_or_null(of.ratio)},
          {"time", finite_or_null(of.time)}};
}

Complaint complaint_of(const Json& json) {
  return {.judge = json.at("judge"),
          .what = json.at("what"),
          .sign = json.at("sign"),
          .where = json.at("where"),
          .unit = json.at("unit"),
          .value = number_of(json.at("value")),
          .tolerance = number_of(json.at("tolerance")),
          .ratio = number_of(json.at("ratio")),
          .time = number_of(json.at("time"))};
}

Json as_json(const Opinion& of) {
  Json complaints = Json::array();
  for (const Complaint& one : of.complaints) complaints.push_back(as_json(one));
  return {{"status", of.status},
          {"note", of.note},
          {"by_laws_alone", of.by_laws_alone},
          {"complaints", std::move(complaints)},
          {"energy_rise", number_or_nothing(of.energy_rise)},
          {"overlap", number_or_nothing(of.overlap)}};
}

Opinion opinion_of(const Json& json) {
  Opinion of{.status = json.at("status"),
             .note = json.at("note"),
             .by_laws_alone = json.at("by_laws_alone"),
             .complaints = {},
             .energy_rise = optional_of(json.at("energy_rise")),
             .overlap = optional_of(json.at("overlap"))};
  for (const Json& one : json.at("complaints")) of.complaints.push_back(complaint_of(one));
  return of;
}

}  // namespace plumb
