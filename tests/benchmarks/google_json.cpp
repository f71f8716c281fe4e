#include <fmt/chrono.h>

#include <ctime>
#include <nlohmann/json.hpp>
#include <thread>

#include "reports/environment.h"
#include "tests/benchmarks/contest.h"

namespace plumb::benchmarks {
namespace {

using Json = nlohmann::ordered_json;

constexpr double micro = 1e6;

Json context() {
  Json all = {{"date", fmt::format("{:%Y-%m-%dT%H:%M:%S+00:00}", fmt::gmtime(std::time(nullptr)))},
              {"num_cpus", std::thread::hardware_concurrency()}};
  for (const auto& [key, value] : environment()) all[key] = value;
  all["library_build_type"] = all["build_type"] == "Release" ? "release" : "debug";
  return all;
}

Json entry(const Contest& contest, const Contest::Row& row, const char* type) {
  const std::string name = contest.scene + "/" + row.contender;
  return {{"name", name},
          {"run_name", name},
          {"run_type", type},
          {"repetitions", contest.rounds},
          {"threads", contest.threads},
          {"iterations", contest.window.steps()}};
}

void add_times(Json& to, double wall, double cpu, double speed, const Contest& contest, const Contest::Row& row) {
  to["real_time"] = micro * wall;
  to["cpu_time"] = micro * cpu;
  to["time_unit"] = "us";
  if (speed > 0) to["speed_against_" + contest.against] = speed;
  to["first_step"] = contest.window.from;
  to["mean_overlap"] = row.finish.overlap.mean;
  to["deepest_overlap"] = row.finish.overlap.most;
}

void add(Json& all, const Contest& contest, const Contest::Row& row) {
  if (!row.finish.no_result.empty()) {
    Json failed = entry(contest, row, "iteration");
    failed["error_occurred"] = true;
    failed["error_message"] = row.finish.no_result;
    all.push_back(failed);
    return;
  }
  for (std::size_t round = 0; round < row.finish.laps.size(); ++round) {
    const Lap& lap = row.finish.laps[round];
    Json one = entry(contest, row, "iteration");
    one["repetition_index"] = round;
    add_times(one, lap.wall / contest.window.steps(), lap.cpu / contest.window.steps(), 0, contest, row);
    one["disturbed"] = disturbed(lap) ? 1 : 0;
    all.push_back(one);
  }
  const Figures& figures = row.figures;
  Json median = entry(contest, row, "aggregate");
  median["name"] = median["run_name"].get<std::string>() + "_median";
  median["aggregate_name"] = "median";
  median["aggregate_unit"] = "time";
  add_times(median, figures.wall.median, figures.cpu.median, figures.speed.median, contest, row);
  median["speed_lower_quartile"] = figures.speed.low;
  median["speed_upper_quartile"] = figures.speed.high;
  median["disturbed"] = figures.disturbed;
  all.push_back(median);
}

}  // namespace

std::string google_json(const std::vector<Contest>& contests) {
  Json benchmarks = Json::array();
  for (const Contest& contest : contests) {
    for (const Contest::Row& row : contest.rows) add(benchmarks, contest, row);
  }
  return Json{{"context", context()}, {"benchmarks", benchmarks}}.dump(2) + "\n";
}

}  // namespace plumb::benchmarks
