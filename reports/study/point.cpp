#include "reports/study/point.h"

#include <stdexcept>
#include <utility>

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::pair<Ending, const char*> endings[] = {{Ending::done, "done"},
                                                      {Ending::failed, "failed"},
                                                      {Ending::crashed, "crashed"},
                                                      {Ending::timed_out, "timed out"},
                                                      {Ending::out_of_memory, "out of memory"}};

Ending ending_of(const std::string& name) {
  for (const auto& [ending, word] : endings) {
    if (name == word) return ending;
  }
  throw std::invalid_argument("\"" + name + "\" is no way for a point to end");
}

}  // namespace

const char* name_of(Ending asked) {
  for (const auto& [ending, word] : endings) {
    if (ending == asked) return word;
  }
  return "";
}

std::string to_line(const PointResult& result) {
  // What a engine says need not be UTF-8.
  return Json{{"key", result.key},
              {"ending", name_of(result.ending)},
              {"reason", result.reason},
              {"values", result.row.values},
              {"times", result.row.times}}
             .dump(-1, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

PointResult from_line(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    return {.key = json.at("key"),
            .ending = ending_of(json.at("ending")),
            .reason = json.at("reason"),
            .row = {json.at("values"), json.at("times")}};
  } catch (const Json::exception& error) {
    throw std::invalid_argument(error.what());
  }
}

}  // namespace plumb
