#include "reports/timing/google_benchmark.h"

#include <fmt/chrono.h>

#include <ctime>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "reports/system/environment.h"

namespace plumb::google_benchmark {

Json entry(const std::string& name, const char* type, int repetitions, int threads, std::size_t iterations) {
  return {{"name", name},       {"run_name", name},        {"run_type", type}, {"repetitions", repetitions},
          {"threads", threads}, {"iterations", iterations}};
}

void add_times(Json& entry, double wall, double cpu) {
  constexpr double micro = 1e6;
  entry["real_time"] = micro * wall;
  entry["cpu_time"] = micro * cpu;
  entry["time_unit"] = "us";
}

void name_median(Json& entry) {
  entry["name"] = entry["run_name"].get<std::string>() + "_median";
  entry["aggregate_name"] = "median";
  entry["aggregate_unit"] = "time";
}

void add_error(Json& entry, const std::string& why) {
  entry["error_occurred"] = true;
  entry["error_message"] = why;
}

std::string text_of(Json entries) { return text_of(std::move(entries), Json::object()); }

std::string text_of(Json entries, const Json& facts) {
  Json context{{"date", fmt::format("{:%Y-%m-%dT%H:%M:%S+00:00}", fmt::gmtime(std::time(nullptr)))},
               {"num_cpus", std::thread::hardware_concurrency()}};
  for (const auto& [key, value] : environment()) context[key] = value;
  context["library_build_type"] = context["build_type"] == "Release" ? "release" : "debug";
  context.update(facts);
  return Json{{"context", std::move(context)}, {"benchmarks", std::move(entries)}}.dump(
             2, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

}  // namespace plumb::google_benchmark
