#include "reports/writers/html.h"

#include <nlohmann/json.hpp>

#include "reports/writers/json.h"
#include "reports/writers/output.h"
#include "reports/writers/packed.h"
#include "reports/writers/replay.h"
#include "reports/writers/run_curves.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view mark = "<!--plumb-data-->";

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
                        {"curves", series_by_case(curves)},
                        {"replays", replays_of(curves)},
                        {"studies", studies_of(report)}},
                   why_not);
}

}  // namespace plumb
