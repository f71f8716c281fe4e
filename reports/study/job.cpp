#include "reports/study/job.h"

#include <cmath>
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
  throw std::invalid_argument("unknown ending of a job: \"" + name + "\"");
}

}  // namespace

const char* name_of(Ending wanted) {
  for (const auto& [ending, word] : endings) {
    if (ending == wanted) return word;
  }
  return "";
}

std::string to_line(const JobResult& result) {
  // An engine's error message may not be valid UTF-8: `replace` keeps dump from throwing.
  return Json{{"key", result.key},
              {"ending", name_of(result.ending)},
              {"reason", result.reason},
              {"values", result.output.values},
              {"times", result.output.times}}
             .dump(-1, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

JobResult from_line(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    return {.key = json.at("key"),
            .ending = ending_of(json.at("ending")),
            .reason = json.at("reason"),
            .output = {json.at("values"), json.at("times")}};
  } catch (const Json::exception& error) {
    throw std::invalid_argument(error.what());
  }
}

Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

}  // namespace plumb
