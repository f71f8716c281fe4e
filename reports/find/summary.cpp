#include "reports/find/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "reports/find/finding.h"
#include "reports/find/ruler.h"
#include "reports/find/tables.h"
#include "reports/system/files.h"
#include "reports/writers/junit.h"

namespace plumb {
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
    if (added) all.push_back({finding, 0});
    Told& told = all[place->second];
    if (tells_more(finding, told.finding)) told.finding = std::move(finding);
    ++told.times;
  }
  return all;
}

std::vector<std::pair<std::string, std::vector<Opinion>>> opinions_in(const Json& configuration,
                                                                      const std::vector<JobResult>& results) {
  std::vector<std::pair<std::string, std::vector<Opinion>>> all;
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

Json json_of(const Told& told) {
  const Finding& finding = told.finding;
  return {{"name", finding.name()},
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
          {"file", "found/" + finding.name() + ".json"}};
}

std::vector<std::vector<std::string>> rows_of(const std::vector<Told>& told) {
  std::vector<std::vector<std::string>> rows{{"engine", "what", "moving bodies", "scene"}};
  for (const auto& [finding, times] : told) {
    rows.push_back({finding.engine, finding.complaint.words(), std::to_string(finding.moving_bodies()),
                    "found/" + finding.name() + ".json"});
  }
  return rows;
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
  const std::vector<RulerSummary> engines = measured_alike(opinions_in(configuration, results));
  const std::vector<Told> told = told_once(results);
  const auto scenes = std::ranges::count_if(results, is_look);
  const std::uint64_t seed = configuration.at("seed");
  Json engines_json = Json::array();
  for (const RulerSummary& one : engines) engines_json.push_back(as_json(one));
  Json found_json = Json::array();
  for (const Told& one : told) found_json.push_back(json_of(one));

  const std::string faults = faults_sentence(engines) + lost_sentence(results);
  const std::string head = fmt::format("{} scenes, {} findings, half of them with at most {} moving bodies.\n", scenes,
                                       told.size(), median_moving(told));
  const std::string alike = fmt::format(
      "Energy and overlap: in the {} scenes that every engine ran to the end; energy relative to the "
      "scene's range, where none comes from outside.\n",
      engines.empty() ? 0 : engines.front().compared);
  Findings findings{.findings = {{"scenes", scenes}, {"engines", engines_json}, {"found", found_json}}};
  findings.text = plain_table(rows_of(engines)) + alike + "\n" + plain_table(rows_of(told)) + "\n" + head + faults;
  findings.files.emplace_back("find.md", "### Plumb: find\n\n" + head + faults + "\n" +
                                             markdown_table(rows_of(engines)) + "\n" + alike + "\n" +
                                             markdown_table(rows_of(told)));
  std::vector<TestCase> cases;
  for (const Told& one : told) {
    cases.push_back({one.finding.name(), one.finding.engine, one.finding.complaint.words()});
    findings.files.emplace_back("found/" + one.finding.name() + ".json", one.finding.file(seed));
  }
  findings.files.emplace_back("find.xml", junit("plumb find", cases));
  return findings;
}

}  // namespace plumb
