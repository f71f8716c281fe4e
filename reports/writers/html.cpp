#include "reports/writers/html.h"

#include <cmath>

#include "reports/judge/mechanics.h"
#include "reports/writers/json.h"
#include "reports/writers/page.h"
#include "reports/writers/replay.h"
#include "reports/writers/writer.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view mark = "<!--plumb-data-->";

// Six significant digits: more than a chart can show, and a third of the bytes.
double rounded(double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  const double unit = std::pow(10.0, 5 - static_cast<int>(std::floor(std::log10(std::abs(value)))));
  return std::isfinite(unit) && unit > 0 ? std::round(value * unit) / unit : value;
}

Json series_of(const Course& course, std::size_t most) {
  const RunRecord& run = *course.run;
  const Trace& trace = *run.trace;
  const Conserved conserved(*run.scene);
  Json series{{"scenario", run.scenario}, {"variant", run.variant}, {"engine", run.engine}, {"method", run.method}};
  for (const char* column :
       {"t", "energy", "momentum_x", "momentum_y", "angular_momentum", "pose_difference", "overlap"}) {
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
    series["pose_difference"].push_back(moment < course.apart.size() ? Json(rounded(course.apart[moment].position))
                                                                     : Json());
    series["overlap"].push_back(rounded(course.deepest[moment].depth));
  }
  return series;
}

const Catalog<Writer>::Entry html_entry{
    {.name = "html", .file = "index.html", .text = [](const Report& report, std::string& why_not) {
       return fill_page(page_template(), report, why_not);
     }}};

Json studies_of(const Report& report) {
  Json all = Json::array();
  for (const auto& study : report.studies) all.push_back(*study);
  return all;
}

}  // namespace

Json series_of(std::span<const Course> courses, std::size_t most) {
  Json all = Json::array();
  for (const Course& course : courses) all.push_back(series_of(course, most));
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
  // In ASCII: one letter beyond Latin 1 makes browsers keep, and read, two bytes for each of millions.
  constexpr bool ascii = true;
  // No tag can begin inside the data: a name in it must not end the script early.
  for (const char letter : data.dump(-1, ' ', ascii)) {
    if (letter == '<') {
      filled += "\\u003c";
    } else {
      filled += letter;
    }
  }
  filled += "</script>";
  filled += page.substr(place + mark.size());
  return filled;
}

std::optional<std::string> fill_page(std::string_view page, const Report& report, std::string& why_not) {
  const std::vector<Course> courses = courses_of(report);
  return fill_page(page,
                   Json{{"report", to_json(report)},
                        {"series", series_of(courses)},
                        {"replays", replays_of(courses)},
                        {"studies", studies_of(report)}},
                   why_not);
}

}  // namespace plumb
