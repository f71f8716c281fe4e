#include "reports/writers/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

void add(const RunRecord& run, EngineSummary& to) {
  ++to.verdicts[run.verdict];
  for (const TruthCheck& check : run.truth) {
    if (!check.reported) continue;
    ++to.checks;
    to.untested += is_evidence(check) ? 0 : 1;
    for (std::size_t i = 0; i < grades.size(); ++i) to.within[i] += relative_error(check) <= grades[i] ? 1 : 0;
  }
  for (const InvariantCheck& check : run.invariants) {
    if (check.status == CheckStatus::not_reported || check.scale == 0) continue;
    ++to.laws;
    to.untested_laws += is_evidence(check) ? 0 : 1;
  }
}

}  // namespace

std::vector<EngineSummary> engine_summaries(const Report& report) {
  std::vector<EngineSummary> all;
  for (const RunRecord& run : report.runs) {
    if (run.exact) continue;
    const std::string label = label_of(run.engine, run.method);
    auto found = std::find_if(all.begin(), all.end(), [&](const EngineSummary& one) { return one.engine == label; });
    if (found == all.end()) found = all.insert(all.end(), {.engine = label});
    add(run, *found);
  }
  return all;
}

std::vector<RelationSummary> relation_summaries(const Report& report) {
  std::vector<RelationSummary> all;
  for (const EngineSummary& engine : engine_summaries(report)) {
    std::map<std::string, RelationSummary> of_engine;
    for (const RunRecord& run : report.runs) {
      if (run.exact || label_of(run.engine, run.method) != engine.engine) continue;
      for (const InvariantCheck& check : run.invariants) {
        if (!check.name.starts_with(relation_prefix)) continue;
        const std::string name = check.name.substr(relation_prefix.size());
        RelationSummary& one = of_engine.try_emplace(name, RelationSummary{engine.engine, name}).first->second;
        const auto share = run.metrics.find(check.name);
        ++one.cases;
        one.alike += share != run.metrics.end() && share->second.value <= relation_grade ? 1 : 0;
        one.broken += check.status == CheckStatus::broken ? 1 : 0;
      }
    }
    for (auto& [name, one] : of_engine) all.push_back(std::move(one));
  }
  return all;
}

std::string share_of(int part, int whole) { return whole == 0 ? "-" : fmt::format("{} %", 100 * part / whole); }

std::optional<Pair> first_pair(const Report& report) {
  std::vector<EngineSummary> engines = engine_summaries(report);
  std::erase_if(engines, [&](const EngineSummary& one) {
    return std::ranges::none_of(report.comparisons, [&](const Comparison& pair) {
      return pair.key && (pair.a == one.engine || pair.b == one.engine);
    });
  });
  if (engines.size() < 2) return std::nullopt;
  const auto box2d =
      std::find_if(engines.begin() + 1, engines.end(), [](const EngineSummary& one) { return one.engine == "box2d"; });
  return Pair{engines[0].engine, (box2d == engines.end() ? engines.begin() + 1 : box2d)->engine};
}

std::vector<const Comparison*> comparisons_of(const Report& report, const Pair& pair) {
  std::vector<const Comparison*> all;
  for (const Comparison& one : report.comparisons) {
    if (one.a == pair.a && one.b == pair.b) all.push_back(&one);
  }
  return all;
}

std::string percent(double ratio) { return std::isfinite(ratio) ? short_number(100 * ratio) : "-"; }

std::string short_number(const std::optional<double>& value) {
  if (!value) return "-";
  const bool whole = std::abs(*value) >= 99.5 && std::abs(*value) < 1e6;
  return whole ? fmt::format("{:.0f}", *value) : fmt::format("{:.2g}", *value);
}

namespace {

/// In how many of the cases in which a difference is known it stays small: "3 of 5".
std::string close_in(const std::vector<const Comparison*>& rows, RelativeDifference KeyDifferences::*difference) {
  int known = 0;
  int close = 0;
  for (const Comparison* row : rows) {
    if (!row->key || !std::isfinite((row->key.value().*difference).largest)) continue;
    ++known;
    close += (row->key.value().*difference).largest <= right_share ? 1 : 0;
  }
  return fmt::format("{} of {}", close, known);
}

}  // namespace

std::string in_one_sentence(const Pair& pair, const std::vector<const Comparison*>& rows) {
  int both = 0;
  int only_a = 0;
  int only_b = 0;
  for (const Comparison* row : rows) {
    if (!row->key) continue;
    both += row->key->rest_a && row->key->rest_b ? 1 : 0;
    only_a += row->key->rest_a && !row->key->rest_b ? 1 : 0;
    only_b += !row->key->rest_a && row->key->rest_b ? 1 : 0;
  }
  return fmt::format(
      "{} and {} stay within 1 % of each other in energy in {} cases, in momentum in {}. Both come to rest in {}, only "
      "{} in {}, only {} in {}.",
      pair.a, pair.b, close_in(rows, &KeyDifferences::energy), close_in(rows, &KeyDifferences::momentum), both, pair.a,
      only_a, pair.b, only_b);
}

std::string in_words(const TruthCheck& check) {
  const std::string of = check.body.empty() ? "" : " of " + check.body;
  const std::string what = fmt::format("{}{} at {:.4g} s: ", check.quantity, of, check.time);
  if (!check.reported) return what + "not reported";
  const std::string side = check.relation == Relation::equal ? "" : name_of(check.relation) + std::string(" ");
  const std::string phases = !check.spread ? ""
                                           : fmt::format(" (worst of {} phases; off by {:.2g} ... {:.2g})",
                                                         check.spread->phases, check.spread->min, check.spread->max);
  return what + fmt::format("{:.6g}, expected {}{:.6g} +- {:.2g} {}, off by {:.3g} % of scale{}", check.measured, side,
                            check.expected, check.tolerance, check.unit, 100 * relative_error(check), phases);
}

std::string in_words(const InvariantCheck& check) {
  const std::string where = check.where.empty() ? "" : " of " + check.where;
  return fmt::format("breaks {}{} at {:.4g} s: {:.3g}, tolerance {:.2g} {} ({:.3g} times{}){}{}", check.name, where,
                     check.time, check.value, check.tolerance, check.unit, check.ratio,
                     check.phases > 1 ? fmt::format(", worst of {} phases", check.phases) : "",
                     check.detail.empty() ? "" : ": ", check.detail);
}

}  // namespace plumb
