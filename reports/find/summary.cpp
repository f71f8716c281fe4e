#include "reports/find/summary.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <utility>

#include "reports/find/finding.h"
#include "reports/find/judge.h"
#include "reports/statistics.h"
#include "reports/study/job.h"
#include "reports/system/files.h"
#include "reports/system/layout.h"
#include "reports/system/terminal.h"
#include "reports/writers/junit.h"

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

namespace {

struct RulerHead {
  const char* text;
  int rank;  // of its column, see TextTable
};

constexpr std::array<RulerHead, 10> ruler_heads{{{"engine", 0},
                                                 {"scenes", 1},
                                                 {"not supported", 1},
                                                 {"failed", 1},
                                                 {"wrong", 0},
                                                 {"energy up > .1 %", 3},
                                                 {"> 1 %", 3},
                                                 {"median rise", 2},
                                                 {"deepest overlap, median", 2},
                                                 {"9 in 10", 2}}};

}  // namespace

std::vector<std::vector<std::string>> rows_of(const std::vector<RulerSummary>& engines) {
  std::vector<std::vector<std::string>> rows(1);
  for (const RulerHead& head : ruler_heads) rows.front().emplace_back(head.text);
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

namespace {

using Json = nlohmann::ordered_json;

bool is_look(const JobResult& result) { return result.key.starts_with("find|"); }

// Whether a finding tells more than another of its signature: fewer moving bodies, then a shorter scene, then by name.
bool tells_more(const Finding& a, const Finding& b) {
  const auto rank = [](const Finding& one) {
    return std::tuple(one.moving_bodies(), one.scene.bodies.size(), one.file(0).size(), one.name());
  };
  return rank(a) < rank(b);
}

/// Findings of one signature.
struct Told {
  Finding finding;
  std::string job;  // the key of that which found it
  int times = 0;
};

// In the order in which they were found; each signature once.
std::vector<Told> told_once(const std::vector<JobResult>& results) {
  std::vector<Told> all;
  std::map<std::string, std::size_t> places;
  for (const JobResult& result : results) {
    if (is_look(result) || result.ending != Ending::done) continue;
    Finding finding = finding_of(result.output.values);
    const auto [place, added] = places.emplace(finding.signature(), all.size());
    if (added) all.push_back({finding, result.key, 0});
    Told& told = all[place->second];
    if (tells_more(finding, told.finding)) told = {std::move(finding), result.key, told.times};
    ++told.times;
  }
  return all;
}

using OpinionsByEngine = std::vector<std::pair<std::string, std::vector<Opinion>>>;

OpinionsByEngine opinions_in(const Json& configuration, const std::vector<JobResult>& results) {
  OpinionsByEngine all;
  for (const std::string engine : configuration.at("engines")) {
    std::vector<Opinion> opinions;
    for (const JobResult& result : results) {
      if (!is_look(result) || result.ending != Ending::done) continue;
      opinions.push_back(opinion_of(result.output.values.at("opinions").at(engine)));
    }
    all.emplace_back(engine, std::move(opinions));
  }
  return all;
}

std::string path_of(const Finding& finding, const char* ending) { return "found/" + finding.name() + ending; }

Json json_of(const Told& told) {
  const Finding& finding = told.finding;
  return {{"name", finding.name()},
          {"job", told.job},
          {"engine", finding.engine},
          {"reason", finding.complaint.reason()},
          {"words", finding.complaint.words()},
          {"ratio", finite_or_null(finding.complaint.ratio)},
          {"signature", finding.signature()},
          {"times", told.times},
          {"from", finding.from},
          {"posed", name_of(finding.posed)},
          {"drawn_bodies", finding.drawn_bodies},
          {"bodies", finding.scene.bodies.size()},
          {"moving_bodies", finding.moving_bodies()},
          {"file", path_of(finding, scene_ending)},
          {"image", finding.run.image ? Json(path_of(finding, image_ending)) : Json()}};
}

std::vector<std::vector<std::string>> rows_of(const std::vector<Told>& told) {
  std::vector<std::vector<std::string>> rows{{"engine", "what", "moving bodies", "scene"}};
  for (const auto& [finding, job, times] : told) {
    rows.push_back({finding.engine, finding.complaint.words(), std::to_string(finding.moving_bodies()),
                    path_of(finding, scene_ending)});
  }
  return rows;
}

// "Of 60 random scenes, impulse is wrong in 6 and box2d in 8: ", like the page, or without engines if they are many.
std::string wrong_sentence(const std::vector<RulerSummary>& engines, std::ptrdiff_t scenes) {
  constexpr std::size_t most_named = 5;
  std::vector<std::string> parts;
  parts.reserve(engines.size());
  for (const RulerSummary& one : engines) {
    parts.push_back(fmt::format("{}{} in {}", one.engine, parts.empty() ? " is wrong" : "", one.wrong));
  }
  const bool are_few = !parts.empty() && parts.size() <= most_named;
  return fmt::format("Of {} random scenes{}{}: ", scenes, are_few ? ", " : "", are_few ? enumerated(parts) : "");
}

// Of each engine.
std::string rulers_text(const std::vector<RulerSummary>& engines, std::size_t width) {
  const auto rows = rows_of(engines);
  std::vector<TextTable::Column> columns;
  columns.reserve(ruler_heads.size());
  for (const RulerHead& head : ruler_heads) columns.push_back({head.text, head.rank, columns.empty()});
  TextTable table(std::move(columns), 0, width);
  for (const auto& row : std::span(rows).subspan(1)) {
    std::vector<TextTable::Cell> cells;
    cells.reserve(row.size());
    for (const std::string& text : row) cells.push_back({text});
    table.add(std::move(cells));
  }
  return table.text();
}

// Each finding beside its engine.
std::string told_text(const std::vector<Told>& told, std::size_t width) {
  std::size_t names = 0;
  for (const Told& one : told) names = std::max(names, columns_of(one.finding.engine));
  std::string text;
  for (const auto& [finding, job, times] : told) {
    const int moving = finding.moving_bodies();
    text += beside(finding.engine, std::min<std::size_t>(names + 2, 30),
                   fmt::format("{}; {} moving {}: {}", finding.complaint.words(), moving,
                               moving == 1 ? "body" : "bodies", path_of(finding, scene_ending)),
                   width);
  }
  return text;
}

// How many of the engines that are ours with a fault are wrong where the right one is not; nullopt without such.
std::string faults_sentence(const std::vector<RulerSummary>& engines) {
  int faults = 0;
  int found = 0;
  std::string missed;
  for (const RulerSummary& one : engines) {
    if (!one.engine.starts_with("fault:")) continue;
    ++faults;
    if (one.wrong + one.failed > 0) {
      ++found;
    } else {
      missed += (missed.empty() ? "" : ", ") + one.engine.substr(6);
    }
  }
  if (faults == 0) return "";
  return fmt::format("{} of {} faults found{}.\n", found, faults, missed.empty() ? "" : "; not " + missed);
}

// What closed forms are said to break, which only judges can have got wrong; "" if none was searched.
std::string closed_forms_sentence(const std::vector<RulerSummary>& engines) {
  int closed_forms = 0;
  int alarms = 0;
  for (const RulerSummary& one : engines) {
    if (!is_closed_form(one.engine)) continue;
    ++closed_forms;
    alarms += one.wrong + one.failed;
  }
  if (closed_forms == 0) return "";
  if (alarms == 0) return fmt::format("No false alarm of {} closed forms.\n", closed_forms);
  return fmt::format("{} FALSE {} of {} closed forms: the judges' mistakes.\n", alarms,
                     alarms == 1 ? "ALARM" : "ALARMS", closed_forms);
}

// How often judging by more than laws took too long, which the findings then lack; "" if never.
std::string hurried_sentence(const OpinionsByEngine& engines, double seconds) {
  std::ptrdiff_t hurried = 0;
  for (const auto& [engine, opinions] : engines) hurried += std::ranges::count_if(opinions, &Opinion::by_laws_alone);
  if (hurried == 0) return "";
  return fmt::format(
      "{} {} judged by laws alone: the rest took more than {} s of a processor (--run-limit), or crashed.\n", hurried,
      hurried == 1 ? "run was" : "runs were", seconds);
}

// Jobs without a result, which engines cannot cause; "" if there are none.
std::string lost_sentence(const std::vector<JobResult>& results) {
  std::string lost;
  int count = 0;
  for (const JobResult& result : results) {
    if (result.ending == Ending::done) continue;
    if (++count <= 3) lost += fmt::format("{}{} ({})", lost.empty() ? "" : "; ", result.key, result.reason);
  }
  if (count == 0) return "";
  return fmt::format("{} {} lost: {}{}.\n", count, count == 1 ? "job was" : "jobs were", lost,
                     count > 3 ? "; ..." : "");
}

double median_moving(const std::vector<Told>& told) {
  std::vector<int> counts;
  counts.reserve(told.size());
  for (const Told& one : told) counts.push_back(one.finding.moving_bodies());
  std::ranges::sort(counts);
  return counts.empty() ? 0 : counts[counts.size() / 2];
}

}  // namespace

Findings conclude_search(const Json& configuration, const std::vector<JobResult>& results) {
  const OpinionsByEngine opinions = opinions_in(configuration, results);
  const std::vector<RulerSummary> engines = measured_alike(opinions);
  const std::vector<Told> told = told_once(results);
  const auto scenes = std::ranges::count_if(results, is_look);
  const std::uint64_t seed = configuration.at("seed");
  Json engines_json = Json::array();
  for (const RulerSummary& one : engines) engines_json.push_back(as_json(one));
  Json found_json = Json::array();
  for (const Told& one : told) found_json.push_back(json_of(one));

  const std::string sizes =
      told.empty() ? "" : fmt::format(", half of them with at most {} moving bodies", median_moving(told));
  const std::size_t width = terminal_width(120);
  std::string head;  // in Markdown
  std::string headline;
  for (const std::string& sentence :
       {wrong_sentence(engines, scenes) + fmt::format("{} findings{}.\n", told.size(), sizes), faults_sentence(engines),
        closed_forms_sentence(engines), hurried_sentence(opinions, configuration.at("run_limit")),
        lost_sentence(results)}) {
    head += sentence;
    headline += wrapped(sentence, 0, width);
  }
  const std::string alike = fmt::format(
      "Energy and overlap: in the {} scenes that every engine ran to the end; energy relative to the "
      "scene's range, where none comes from outside.\n",
      engines.empty() ? 0 : engines.front().compared);
  Findings findings{.findings = {{"scenes", scenes}, {"engines", engines_json}, {"found", found_json}}};
  findings.text = headline + "\n" + rulers_text(engines, width) + wrapped(alike, 0, width) +
                  (told.empty() ? "" : "\n" + told_text(told, width)) + "\n";
  findings.failed = std::ranges::any_of(
      engines, [](const RulerSummary& one) { return is_closed_form(one.engine) && one.wrong + one.failed > 0; });
  findings.files.emplace_back("find.md", "### Plumb: find\n\n" + head + "\n" + markdown_table(rows_of(engines)) + "\n" +
                                             alike + "\n" + markdown_table(rows_of(told)));
  std::vector<TestCase> cases;
  for (const Told& one : told) {
    cases.push_back({one.finding.name(), one.finding.engine, one.finding.complaint.words()});
    findings.files.emplace_back(path_of(one.finding, scene_ending), one.finding.file(seed));
    if (one.finding.run.image)
      findings.files.emplace_back(path_of(one.finding, image_ending), one.finding.image_file());
  }
  findings.files.emplace_back("find.xml", junit("plumb find", cases));
  return findings;
}

}  // namespace plumb
