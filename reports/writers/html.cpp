#include "reports/writers/html.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/judge/mechanics.h"
#include "reports/judge/states.h"
#include "reports/writers/json.h"
#include "reports/writers/output.h"
#include "reports/writers/packed.h"
#include "reports/writers/replay.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view mark = "<!--plumb-data-->";

// Six significant digits: more than a chart can show, in a third of the bytes.
double rounded(double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  const double unit = std::pow(10.0, 5 - static_cast<int>(std::floor(std::log10(std::abs(value)))));
  return std::isfinite(unit) && unit > 0 ? std::round(value * unit) / unit : value;
}

Json series_of(const RunCurves& curves, std::size_t most) {
  const RunRecord& run = *curves.run;
  const Trace& trace = *run.trace;
  const Conserved conserved(*run.scene);
  Json series{{"scenario", run.scenario}, {"variant", run.variant}, {"engine", run.engine}, {"method", run.method}};
  for (const char* column :
       {"t", "energy", "momentum_x", "momentum_y", "angular_momentum", "fastest", "pose_difference", "overlap"}) {
    series[column] = Json::array();
  }
  const std::size_t last = trace.size() - 1;
  const std::size_t shown = std::min(trace.size(), most);
  for (std::size_t i = 0; i < shown; ++i) {
    const std::size_t moment = shown == 1 ? last : i * last / (shown - 1);
    const auto states = trace.states(moment);
    const Momentum momentum = conserved.momentum(states);
    series["t"].push_back(rounded(trace.time(moment)));
    series["energy"].push_back(rounded(conserved.energy(states).total()));
    series["momentum_x"].push_back(rounded(momentum.linear.x));
    series["momentum_y"].push_back(rounded(momentum.linear.y));
    series["angular_momentum"].push_back(rounded(momentum.angular));
    series["fastest"].push_back(rounded(fastest_speed(*run.scene, states)));
    series["pose_difference"].push_back(
        moment < curves.difference.size() ? Json(rounded(curves.difference[moment].position)) : Json());
    series["overlap"].push_back(rounded(curves.deepest[moment].depth));
  }
  return series;
}

const Catalog<Writer>::Entry html_entry{
    {.name = "html", .file = "index.html", .text = [](const Report& report, std::string& why_not) {
       return fill_page(page_template(), report, why_not);
     }}};

// By case, in the report's order, each packed: the page reads those of the cases that are opened.
Json curves_of(std::span<const RunCurves> runs) {
  struct Case {
    std::string scenario, variant;
    Json series = Json::array();
  };
  std::vector<Case> cases;
  for (Json& one : series_of(runs)) {
    const auto same = [&](const Case& item) {
      return one["scenario"] == item.scenario && one["variant"] == item.variant;
    };
    auto found = std::find_if(cases.begin(), cases.end(), same);
    if (found == cases.end()) found = cases.insert(cases.end(), Case{one["scenario"], one["variant"]});
    found->series.push_back(std::move(one));
  }
  Json all = Json::array();
  for (const Case& item : cases) {
    all.push_back({{"scenario", item.scenario}, {"variant", item.variant}, {"series", packed(item.series.dump())}});
  }
  return all;
}

Json studies_of(const Report& report) {
  Json all = Json::array();
  for (const auto& study : report.studies) all.push_back(*study);
  return all;
}

}  // namespace

Json series_of(std::span<const RunCurves> runs, std::size_t most) {
  Json all = Json::array();
  for (const RunCurves& curves : runs) all.push_back(series_of(curves, most));
  return all;
}

std::optional<std::string> fill_page(std::string_view page, const Json& data, std::string& why_not) {
  if (page.empty()) {
    why_not = "built without Node.js: no page";
    return std::nullopt;
  }
  const auto place = page.find(mark);
  if (place == std::string_view::npos) {
    why_not = "the built page has no mark " + std::string(mark);
    return std::nullopt;
  }
  std::string filled(page.substr(0, place));
  filled += R"(<script type="application/json" id="plumb-data">)";
  // ASCII only: one character beyond Latin-1 makes browsers store the whole text with two bytes a character.
  constexpr bool ascii = true;
  // No tag may begin inside the data: a body's name must not end the script.
  // A folder's name need not be UTF-8.
  for (const char character : data.dump(-1, ' ', ascii, Json::error_handler_t::replace)) {
    if (character == '<') {
      filled += "\\u003c";
    } else {
      filled += character;
    }
  }
  filled += "</script>";
  filled += page.substr(place + mark.size());
  return filled;
}

std::optional<std::string> fill_page(std::string_view page, const Report& report, std::string& why_not) {
  const std::vector<RunCurves> curves = run_curves(report);
  return fill_page(page,
                   Json{{"report", packed(to_json(report).dump())},
                        {"curves", curves_of(curves)},
                        {"replays", replays_of(curves)},
                        {"studies", studies_of(report)}},
                   why_not);
}

}  // namespace plumb
