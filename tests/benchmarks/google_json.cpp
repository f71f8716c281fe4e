#include <utility>

#include "contest.h"
#include "reports/timing/google_benchmark.h"

namespace plumb::benchmarks {
namespace {

using google_benchmark::Json;

Json entry(const Contest& contest, const Contest::Row& row, const char* type) {
  return google_benchmark::entry(contest.scene + "/" + row.engine, type, contest.rounds, contest.threads,
                                 static_cast<std::size_t>(contest.window.steps()));
}

void add_times(Json& to, double wall, double cpu, double speed, const Contest& contest, const Contest::Row& row) {
  google_benchmark::add_times(to, wall, cpu);
  if (speed > 0) to["speed_against_" + contest.against] = speed;
  to["first_step"] = contest.window.from;
  to["mean_overlap"] = row.finish.overlap.mean;
  to["deepest_overlap"] = row.finish.overlap.most;
}

void add(Json& all, const Contest& contest, const Contest::Row& row) {
  if (!row.finish.no_result.empty()) {
    Json failed = entry(contest, row, "iteration");
    google_benchmark::add_error(failed, row.finish.no_result);
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
  google_benchmark::name_median(median);
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
  return google_benchmark::text_of(std::move(benchmarks));
}

}  // namespace plumb::benchmarks
