#include "reports/study/statistics/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/study/job.h"
#include "reports/system/files.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

// All runs of an engine in an ensemble.
struct EngineRuns {
  std::string engine;
  std::string execution;
  bool control = false;
  int runs = 0, failed = 0;
  std::string status = "ok", why;  // of the first run that is not ok
  std::vector<EnsembleDraw> draws;
  double stepping = 0;  // s, of all runs
  std::vector<EnsembleFinding> findings;

  bool judged() const { return status == "ok" && draws.size() > 1; }
};

void add(EngineRuns& runs, const JobResult& result) {
  ++runs.runs;
  const Json& values = result.output.values;
  const bool done = result.ending == Ending::done;
  const std::string status = done ? values.at("status").get<std::string>() : name_of(result.ending);
  if (status != "ok") {
    if (runs.failed++ == 0) {
      runs.status = status;
      runs.why = done ? values.at("why").get<std::string>() : result.reason;
    }
    return;
  }
  runs.execution = values.at("execution");
  for (const Json& draw : values.at("draws")) runs.draws.push_back(draw.get<EnsembleDraw>());
  if (result.output.times.contains("stepping")) runs.stepping += result.output.times.at("stepping").get<double>();
}

std::vector<EngineRuns> runs_of(const Ensemble& ensemble, const std::vector<JobResult>& results) {
  std::vector<EngineRuns> all;
  for (const JobResult& result : results) {
    if (key_part(result.key, 1) != ensemble.name) continue;  // "statistics|ENSEMBLE|ENGINE|seed N"
    const std::string engine = key_part(result.key, 2);
    auto found = std::find_if(all.begin(), all.end(), [&](const EngineRuns& one) { return one.engine == engine; });
    if (found == all.end()) found = all.insert(found, {.engine = engine, .control = engine.starts_with("control:")});
    add(*found, result);
  }
  return all;
}

std::size_t statistics_in(const Ensemble& ensemble) {
  return ensemble.statistics.size() + (ensemble.distribution ? 1 : 0);
}

Json to_json(const EngineRuns& runs, const EnsembleFinding& finding) {
  return {{"engine", runs.engine},
          {"control", runs.control},
          {"statistic", finding.statistic},
          {"idealisation", finding.idealisation},
          {"draws", finding.draws},
          {"mean", finite_or_null(finding.interval.value)},
          {"low", finite_or_null(finding.interval.low)},
          {"high", finite_or_null(finding.interval.high)},
          {"error", finite_or_null(finding.interval.error)},
          {"verdict", name_of(finding.verdict)},
          {"off", finite_or_null(finding.off)},
          {"needed", finding.needed}};
}

// How often an engine has each verdict over all statistics that are no idealisation.
struct EngineTally {
  std::string engine;
  int agrees = 0, differs = 0, undecided = 0, unjudged = 0;
  std::string text;  // what it differs in or what is undecided

  int judged() const { return agrees + differs + undecided; }
};

std::string off_text(double off) { return std::isfinite(off) ? fmt::format("{:.3g}", off) : "infinitely many"; }

void add(EngineTally& tally, const Ensemble& ensemble, const EngineRuns& runs) {
  if (!runs.judged()) {
    ++tally.unjudged;
    tally.text += fmt::format("  {} {} in {}: {} of {} runs, {}\n", runs.engine, runs.status, ensemble.name,
                              runs.failed, runs.runs, runs.why);
  }
  for (const EnsembleFinding& one : runs.findings) {
    if (one.idealisation) continue;
    tally.agrees += one.verdict == EnsembleVerdict::agrees;
    tally.differs += one.verdict == EnsembleVerdict::differs;
    tally.undecided += one.verdict == EnsembleVerdict::undecided;
    if (one.verdict == EnsembleVerdict::differs)
      tally.text += fmt::format("  {} differs in {}: {}, by {} standard errors\n", runs.engine, ensemble.name,
                                one.statistic, off_text(one.off));
    if (one.verdict == EnsembleVerdict::undecided)
      tally.text += fmt::format("  {} is undecided in {}: {}, {} draws, about {} needed\n", runs.engine, ensemble.name,
                                one.statistic, one.draws, one.needed);
  }
}

std::string band_text(double low, double high, const std::string& unit) {
  const std::string space = unit.empty() ? "" : " ";
  return low == high ? fmt::format("{:.4g}{}{}", low, space, unit)
                     : fmt::format("{:.4g} to {:.4g}{}{}", low, high, space, unit);
}

std::string line_of(const EngineRuns& runs, const EnsembleFinding& one) {
  std::string verdict = name_of(one.verdict);
  if (one.verdict == EnsembleVerdict::differs) verdict += fmt::format(", {} standard errors", off_text(one.off));
  if (one.verdict == EnsembleVerdict::undecided) verdict += fmt::format(", about {} draws needed", one.needed);
  return fmt::format("    {:<28}{:>10.4g}  [{:.4g}, {:.4g}]{:>8} draws  {}\n", runs.engine, one.interval.value,
                     one.interval.low, one.interval.high, one.draws, verdict);
}

std::string text_of(const Ensemble& ensemble, const std::vector<EngineRuns>& all) {
  std::string text = fmt::format("\n{}: {}\n", ensemble.name, ensemble.question);
  const auto lines = [&](std::size_t index, const std::string& head) {
    text += head;
    for (const EngineRuns& runs : all) {
      if (runs.judged()) text += line_of(runs, runs.findings[index]);
    }
  };
  const auto head = [](const std::string& name, const std::string& band, bool idealisation) {
    return fmt::format("  {}: {}{}\n", name, idealisation ? "idealised, " : "", band);
  };
  for (std::size_t i = 0; i < ensemble.statistics.size(); ++i) {
    const Statistic& one = ensemble.statistics[i];
    lines(i, head(one.name, band_text(one.low, one.high, one.unit), one.idealisation));
  }
  if (ensemble.distribution) {
    lines(ensemble.statistics.size(), head(ensemble.distribution->name, "0", ensemble.distribution->idealisation));
  }
  text += "  computing time of a run:";
  for (const EngineRuns& runs : all) {
    if (runs.judged()) text += fmt::format("  {} {:.2g} s", runs.engine, runs.stepping / runs.runs);
  }
  return text + "\n";
}

std::string csv_line(const Ensemble& ensemble, const EngineRuns& runs, const EnsembleFinding& one) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{}\n", csv_field(ensemble.name), csv_field(runs.engine),
                     csv_field(one.statistic), one.draws, one.interval.value, one.interval.low, one.interval.high,
                     one.interval.error, name_of(one.verdict), one.needed);
}

EngineTally& tally_of(std::vector<EngineTally>& tallies, const std::string& engine) {
  auto found = std::find_if(tallies.begin(), tallies.end(), [&](const auto& one) { return one.engine == engine; });
  if (found == tallies.end()) found = tallies.insert(found, {.engine = engine});
  return *found;
}

// "impulse agrees in 17 of 17 statistics, box2d in 15 of 17."
std::string headline(const std::vector<EngineTally>& tallies) {
  std::string text;
  for (const EngineTally& one : tallies) {
    text += text.empty() ? fmt::format("{} agrees in {} of {} statistics", one.engine, one.agrees, one.judged())
                         : fmt::format(", {} in {} of {}", one.engine, one.agrees, one.judged());
  }
  return text + ".\n";
}

}  // namespace

Json description_of(const Ensemble& ensemble) {
  Json statistics = Json::array();
  for (const Statistic& one : ensemble.statistics) {
    statistics.push_back({{"name", one.name},
                          {"unit", one.unit},
                          {"low", one.low},
                          {"high", one.high},
                          {"resolution", one.resolution},
                          {"source", one.source},
                          {"idealisation", one.idealisation}});
  }
  if (const auto& one = ensemble.distribution) {
    statistics.push_back({{"name", one->name},
                          {"unit", ""},
                          {"low", 0},
                          {"high", 0},
                          {"resolution", one->resolution},
                          {"source", one->source},
                          {"idealisation", one->idealisation}});
  }
  const Control control = ensemble.control();
  return {{"name", ensemble.name},   {"question", ensemble.question}, {"dt", ensemble.dt},
          {"runs", ensemble.runs},   {"large", ensemble.large},       {"statistics", statistics},
          {"control", control.name}, {"control_about", control.about}};
}

Findings conclude_statistics(const std::vector<const Ensemble*>& ensembles, const std::vector<JobResult>& results) {
  std::vector<std::vector<EngineRuns>> runs;
  std::size_t looks = 0;
  for (const Ensemble* ensemble : ensembles) {
    runs.push_back(runs_of(*ensemble, results));
    for (const EngineRuns& one : runs.back()) looks += one.judged() ? statistics_in(*ensemble) : 0;
  }
  const double miss = statistics_miss / static_cast<double>(std::max<std::size_t>(looks, 1));
  Findings found;
  Json all = Json::array();
  Json costs = Json::array();
  std::vector<EngineTally> tallies;
  std::string controls;
  std::string tables;
  std::string csv = "ensemble,engine,statistic,draws,mean,low,high,standard_error,verdict,needed\n";
  for (std::size_t i = 0; i < ensembles.size(); ++i) {
    const Ensemble& ensemble = *ensembles[i];
    Json described = description_of(ensemble);
    described["results"] = Json::array();
    described["unjudged"] = Json::array();
    for (EngineRuns& one : runs[i]) {
      if (one.judged())
        one.findings = judge_draws(ensemble, one.draws, miss);
      else
        described["unjudged"].push_back({{"engine", one.engine}, {"status", one.status}, {"why", one.why}});
      for (const EnsembleFinding& finding : one.findings) {
        described["results"].push_back(to_json(one, finding));
        csv += csv_line(ensemble, one, finding);
      }
      if (one.judged())
        costs.push_back({{"ensemble", ensemble.name},
                         {"engine", one.engine},
                         {"execution", one.execution},
                         {"seconds", one.stepping / one.runs}});
      if (!one.control) {
        add(tally_of(tallies, one.engine), ensemble, one);
      } else {
        const std::string became = !one.judged()                        ? one.status
                                   : worst_difference(one.findings) > 0 ? "differs, as it must,"
                                                                        : "AGREES";
        controls += fmt::format("  {} {} in {}\n", one.engine, became, ensemble.name);
      }
    }
    tables += text_of(ensemble, runs[i]);
    all.push_back(std::move(described));
  }
  Json summary = Json::array();
  std::string exceptions;
  for (const EngineTally& one : tallies) {
    summary.push_back({{"engine", one.engine},
                       {"agrees", one.agrees},
                       {"differs", one.differs},
                       {"undecided", one.undecided},
                       {"unjudged", one.unjudged}});
    exceptions += one.text;
  }
  found.findings = {{"miss", statistics_miss}, {"looks", looks}, {"summary", summary}, {"ensembles", std::move(all)}};
  found.timings = {{"costs", std::move(costs)}};
  found.text = headline(tallies) + exceptions + controls +
               fmt::format("Intervals: Student's t; all {} hold together with {:g} %. Seeds 1, 2, 3 ...\n", looks,
                           100 * (1 - statistics_miss)) +
               tables;
  found.files = {{"statistics/intervals.csv", csv}};
  return found;
}

}  // namespace plumb
