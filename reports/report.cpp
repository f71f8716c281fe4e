#include "reports/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumb {

const char* name_of(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::failed:
      return "failed";
    case Status::not_supported:
      return "not supported";
  }
  return "";
}

const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::right:
      return "right";
    case Verdict::coarse:
      return "coarse";
    case Verdict::wrong:
      return "wrong";
    case Verdict::plausible:
      return "plausible";
    case Verdict::no_evidence:
      return "no evidence";
    case Verdict::beyond_horizon:
      return "beyond horizon";
    case Verdict::not_supported:
      return "not supported";
    case Verdict::failed:
      return "failed";
  }
  return "";
}

const char* name_of(CheckStatus status) {
  switch (status) {
    case CheckStatus::held:
      return "held";
    case CheckStatus::broken:
      return "broken";
    case CheckStatus::not_reported:
      return "not reported";
    case CheckStatus::not_applicable:
      return "not applicable";
  }
  return "";
}

double error_ratio(double error, double tolerance) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!std::isfinite(error) || !std::isfinite(tolerance)) return infinity;
  if (error <= 0) return 0;
  return tolerance > 0 ? error / tolerance : infinity;
}

double relative_error(const TruthCheck& check) { return error_ratio(check.error - check.chance, check.scale); }

bool is_evidence(const TruthCheck& check) {
  return check.reported && check.scale > 0 && check.tolerance <= evidence_share * check.scale;
}

bool is_judged(const InvariantCheck& check) {
  return check.status == CheckStatus::held || check.status == CheckStatus::broken;
}

bool is_evidence(const InvariantCheck& check) {
  return is_judged(check) && check.scale > 0 && check.tolerance <= evidence_share * check.scale;
}

std::vector<NotATest> not_tests(const std::vector<TruthCheck>& truth) {
  std::vector<NotATest> all;
  for (const TruthCheck& check : truth) {
    if (!check.reported || is_evidence(check)) continue;
    const std::string of = check.body.empty() ? "" : " of " + check.body;
    all.push_back({fmt::format("{}{} at {:.4g} s", check.quantity, of, check.time), check.tolerance / check.scale});
  }
  return all;
}

std::vector<NotATest> not_tests(const RunRecord& run) {
  std::vector<NotATest> all = not_tests(run.truth);
  for (const InvariantCheck& check : run.invariants) {
    if (check.status == CheckStatus::not_reported || check.scale == 0 || is_evidence(check)) continue;
    all.push_back({check.name, check.tolerance / check.scale});
  }
  return all;
}

std::optional<double> worst_relative_error(const RunRecord& run) {
  std::optional<double> worst;
  for (const TruthCheck& check : run.truth) {
    if (check.reported) worst = std::max(worst.value_or(0), relative_error(check));
  }
  return worst;
}

std::optional<double> worst_error_ratio(const RunRecord& run) {
  std::optional<double> worst;
  const auto add = [&](double ratio) { worst = std::max(worst.value_or(0), ratio); };
  for (const TruthCheck& check : run.truth) {
    if (check.reported) add(error_ratio(check.error, check.tolerance));
  }
  for (const InvariantCheck& check : run.invariants) {
    if (is_judged(check)) add(check.ratio);
  }
  return worst;
}

const char* resting(const KeyDifferences& key) {
  const int many = int{key.rest_a.has_value()} + int{key.rest_b.has_value()};
  return many == 2 ? "both" : many == 1 ? "one" : "none";
}

std::string execution_mark(const std::string& execution) {
  if (execution == name_of(ExecutionKind::native)) return "";
  return execution == name_of(ExecutionKind::not_stated) ? " (program)" : " (" + execution + ")";
}

std::string label_of(const std::string& engine, const std::string& method) {
  return method.empty() ? engine : engine + ":" + method;
}

}  // namespace plumb
