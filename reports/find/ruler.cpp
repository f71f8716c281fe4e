#include "reports/find/ruler.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "reports/statistics.h"
#include "reports/study/job.h"

namespace plumb {
namespace {

bool is_failure(const Complaint& one) { return one.judge == "run"; }

// Nine in ten are at most that; 0 of none.
double nine_in_ten(std::vector<double> values) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[(values.size() * 9 + 9) / 10 - 1];
}

double share_above(const std::vector<double>& values, double limit) {
  const auto above = std::ranges::count_if(values, [&](double one) { return one > limit; });
  return values.empty() ? 0 : static_cast<double>(above) / static_cast<double>(values.size());
}

}  // namespace

std::vector<RulerSummary> measured_alike(const std::vector<std::pair<std::string, std::vector<Opinion>>>& engines) {
  const std::size_t scenes = engines.empty() ? 0 : engines.front().second.size();
  std::vector<bool> all_ran(scenes, true);
  for (const auto& [name, opinions] : engines) {
    for (std::size_t i = 0; i < scenes; ++i) all_ran[i] = all_ran[i] && opinions[i].status == "ok";
  }
  std::vector<RulerSummary> all;
  for (const auto& [name, opinions] : engines) {
    RulerSummary one{.engine = name};
    std::vector<double> rises;
    std::vector<double> overlaps;
    for (std::size_t i = 0; i < scenes; ++i) {
      const Opinion& opinion = opinions[i];
      ++one.scenes;
      if (opinion.status == "not supported") ++one.not_supported;
      if (std::ranges::any_of(opinion.complaints, is_failure)) ++one.failed;
      if (std::ranges::any_of(opinion.complaints, std::not_fn(is_failure))) ++one.wrong;
      if (!all_ran[i]) continue;
      ++one.compared;
      if (opinion.energy_rise) rises.push_back(*opinion.energy_rise);
      if (opinion.overlap) overlaps.push_back(*opinion.overlap);
    }
    one.closed = static_cast<int>(rises.size());
    one.above_thousandth = share_above(rises, 0.001);
    one.above_hundredth = share_above(rises, 0.01);
    one.rise_median = quartiles(rises).median;
    one.overlap_median = quartiles(overlaps).median;
    one.overlap_high = nine_in_ten(overlaps);
    all.push_back(one);
  }
  return all;
}

nlohmann::ordered_json as_json(const RulerSummary& of) {
  return {{"engine", of.engine},
          {"scenes", of.scenes},
          {"not_supported", of.not_supported},
          {"failed", of.failed},
          {"wrong", of.wrong},
          {"compared", of.compared},
          {"closed", of.closed},
          {"energy_rise_median", finite_or_null(of.rise_median)},
          {"energy_rise_above_0.1_percent", of.above_thousandth},
          {"energy_rise_above_1_percent", of.above_hundredth},
          {"overlap_median", finite_or_null(of.overlap_median)},
          {"overlap_nine_in_ten", finite_or_null(of.overlap_high)}};
}

std::vector<std::vector<std::string>> rows_of(const std::vector<RulerSummary>& engines) {
  std::vector<std::vector<std::string>> rows{{"engine", "scenes", "not supported", "failed", "wrong",
                                              "energy up > .1 %", "> 1 %", "median rise", "deepest overlap, median",
                                              "9 in 10"}};
  for (const RulerSummary& one : engines) {
    const auto percent = [](double share) { return fmt::format("{:.0f} %", 100 * share); };
    rows.push_back({one.engine, std::to_string(one.scenes), std::to_string(one.not_supported),
                    std::to_string(one.failed), std::to_string(one.wrong), percent(one.above_thousandth),
                    percent(one.above_hundredth), fmt::format("{:.2g} %", 100 * one.rise_median),
                    fmt::format("{:.2g} mm", 1e3 * one.overlap_median),
                    fmt::format("{:.2g} mm", 1e3 * one.overlap_high)});
  }
  return rows;
}

}  // namespace plumb
